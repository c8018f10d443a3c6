"""The largest of several means, with a confidence interval."""

import numpy as np
from numpy.typing import NDArray
from scipy import stats

Array = NDArray[np.float64]


def estimate_largest(samples: Array, confidence: float = 0.95) -> tuple[float, float, float]:
    """Largest absolute value of m means, and the bounds of its interval.

    Every mean has a Student's interval; the intervals hold simultaneously (Bonferroni) for all
    means that may be the largest. Means whose intervals show that they are not the largest are
    dropped, and the intervals are computed again, until none can be dropped. Samples are (n, m), n
    independent ones of the m means. The bounds are NaN where n is 1.
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
