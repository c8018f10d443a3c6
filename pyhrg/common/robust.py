"""Spread of normal numbers among which a few are something else."""

import numpy as np
from numpy.typing import NDArray

NORMAL = 1.4826
"""Standard deviation over the median of magnitudes."""


def robust_deviation(values: NDArray[np.float64]) -> float:
    """Standard deviation about zero of (n,) values, in their unit, by the median of their
    magnitudes; NaN of none."""
    return NORMAL * float(np.median(np.abs(values))) if len(values) else float("nan")
