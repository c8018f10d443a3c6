"""Coverage of predicted intervals, with exact binomial intervals (Eq. 15)."""

import numpy as np
from scipy.stats import binomtest

from ins_eval.study.scores.resampling import CONFIDENCE, Estimate
from pyhrg.common.arrays import Array


def estimate_coverage(flown: Array, low: Array, high: Array, seed: int) -> Estimate:
    """Share of flown errors inside predicted intervals, with the Clopper-Pearson interval.

    A triad's missions are not independent, so that one mission of each triad is drawn and counts.

    Args:
        flown, low, high: (r, m) flown errors and ends of their intervals.
    """
    triads = np.arange(len(flown))
    chosen = np.random.default_rng(seed).integers(flown.shape[1], size=len(flown))
    inside = ((low <= flown) & (flown <= high))[triads, chosen]
    test = binomtest(int(np.sum(inside)), len(inside))
    interval = test.proportion_ci(CONFIDENCE, method="exact")
    return Estimate(float(test.statistic), float(interval.low), float(interval.high))
