"""Standard deviation of normal numbers with a few outliers."""

import numpy as np
from numpy.typing import NDArray

SIGMA_PER_MEDIAN = 1.4826
"""Ratio of a normal distribution's standard deviation to its median magnitude."""


def estimate_robust_deviation(values: NDArray[np.float64]) -> float:
    """Standard deviation about zero of (n,) values, in their unit, from their median magnitude; NaN
    if there are no values."""
    return SIGMA_PER_MEDIAN * float(np.median(np.abs(values))) if len(values) else float("nan")
