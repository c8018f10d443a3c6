"""The largest of several means, with an interval."""

import numpy as np
from numpy.typing import NDArray
from scipy import stats

Array = NDArray[np.float64]


def largest_interval(samples: Array, confidence: float = 0.95) -> tuple[float, float, float]:
    """Largest absolute mean.

    Every mean gets its Student's interval, simultaneously (Bonferroni) over those that may be the
    largest; which these are follows from the intervals, until no more can be left out.

    Args:
        samples: (n, m) n independent samples of m means.

    Returns:
        Value and bounds; NaN bounds where n is 1.
    """
    n, count = samples.shape
    means = np.abs(np.mean(samples, axis=0))
    if n < 2:
        return float(np.max(means)), np.nan, np.nan
    errors = np.std(samples, axis=0, ddof=1) / np.sqrt(n)
    while True:
        reach = errors * stats.t.ppf(1 - (1 - confidence) / (2 * count), n - 1)
        low = max(0.0, float(np.max(means - reach)))
        high = means + reach
        candidates = int(np.sum(high >= low))
        if candidates >= count:
            return float(np.max(means)), low, float(np.max(high))
        count = candidates
