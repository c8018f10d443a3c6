"""Figures of merit of position errors, with their intervals."""

import numpy as np
from numpy.typing import ArrayLike, NDArray
from scipy.optimize import brentq
from scipy.stats import binom

from ins_eval import earth

Array = NDArray[np.float64]

FEWEST_FOR_MEDIAN = 6
"""Smallest sample whose extremes hold the median with 95 % confidence: 1 - 2 / 2^6 = 96.9 %."""


def position_error(position: Array, truth: Array) -> Array:
    """North and east error (..., 2), m, of latitude and longitude (..., 2+) against the truth
    (..., 3)."""
    latitude, height = truth[..., 0], truth[..., 2]
    north = (position[..., 0] - latitude) * (earth.meridian_radius(latitude) + height)
    east_radius = (earth.transverse_radius(latitude) + height) * np.cos(latitude)
    return np.stack([north, (position[..., 1] - truth[..., 1]) * east_radius], axis=-1)


def median_interval(sample: ArrayLike, confidence: float = 0.95) -> tuple[float, float]:
    """Confidence interval of the median from order statistics, without assumptions.

    Raises:
        ValueError: fewer than `FEWEST_FOR_MEDIAN` values for 95 %.
    """
    ordered = np.sort(np.asarray(sample, dtype=float))
    n = len(ordered)
    below = int(binom.ppf((1 - confidence) / 2, n, 0.5))
    if below < 1 or binom.cdf(below - 1, n, 0.5) > (1 - confidence) / 2:
        below -= 1
    if below < 0:
        raise ValueError(f"{n} values can't hold the median with {confidence:.0%} confidence")
    return float(ordered[below]), float(ordered[n - 1 - below])


def median_radius(covariance: Array) -> float:
    """Radius that a zero-mean normal pair with this covariance (2, 2) exceeds half of the time.

    The distribution function is an integral over the angle of the polar form (Hoyt 1947).
    """
    variances = np.linalg.eigvalsh(covariance)
    largest = float(variances[1])
    if largest <= 0:
        return 0.0
    ratio = max(float(variances[0]) / largest, 1e-9)
    angle = (np.arange(720) + 0.5) * np.pi / 720
    precision = np.cos(angle) ** 2 + np.sin(angle) ** 2 / ratio

    def excess(radius: float) -> float:
        share = -np.expm1(-0.5 * radius**2 * precision) / precision
        return float(np.mean(share) / np.sqrt(ratio) - 0.5)

    return float(brentq(excess, 1e-3, 10.0)) * np.sqrt(largest)
