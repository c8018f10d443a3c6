"""How often flown errors lie inside predicted intervals, with exact binomial intervals."""

import numpy as np
from numpy.typing import NDArray
from scipy.stats import binomtest

from ins_eval.study.scores.resampling import CONFIDENCE, Estimate

Array = NDArray[np.float64]


def coverage(flown: Array, low: Array, high: Array, seed: int) -> Estimate:
    """Share of flown errors (r, m) within intervals, with Clopper and Pearson's interval.

    A triad's missions are not independent: one of them counts for each triad, drawn.

    Args:
        flown, low, high: (r, m).
        seed: of the drawing.
    """
    triads = np.arange(len(flown))
    chosen = np.random.default_rng(seed).integers(flown.shape[1], size=len(flown))
    inside = ((low <= flown) & (flown <= high))[triads, chosen]
    test = binomtest(int(np.sum(inside)), len(inside))
    interval = test.proportion_ci(CONFIDENCE, method="exact")
    return Estimate(float(test.statistic), float(interval.low), float(interval.high))
