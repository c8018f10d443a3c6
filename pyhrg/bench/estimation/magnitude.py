"""Length of a vector that is measured with noise: unbiased square, and interval."""

import numpy as np
from numpy.typing import NDArray
from scipy import optimize, special, stats

Array = NDArray[np.float64]


def estimate_magnitude(
    values: Array, covariance: Array, confidence: float = 0.95
) -> tuple[float, float, float]:
    """Length of the true vector and the bounds of its interval.

    The squared length of the measured vector is approximated by a scaled noncentral chi-square
    variable of the same mean and variance (exact where the covariance is a multiple of a
    projection). The interval inverts its distribution for the noncentrality. Components (n,) are
    normal and unbiased, their covariance is (n, n). The noise's expectation is subtracted from the
    estimate's square (at least 0). All is in the unit of the values.
    """
    square = float(values @ values)
    trace = float(np.trace(covariance))
    if trace <= 0.0:
        return (float(np.sqrt(square)),) * 3
    scale = float(np.trace(covariance @ covariance)) / trace
    along = float(values @ covariance @ values) / square if square > trace else scale
    scale = scale if square <= 9 * trace else along
    freedom = trace / scale

    def bound(probability: float) -> float:
        def excess(noncentrality: float) -> float:
            return float(special.chndtr(square / scale, freedom, noncentrality)) - probability

        if square / scale > 1e4:
            # far from zero the measured length is normally distributed
            reach = float(stats.norm.ppf(probability)) * np.sqrt(scale)
            return float(np.sqrt(square) - reach)
        if excess(0.0) <= 0.0:
            return 0.0
        upper = (np.sqrt(square / scale) + 6.0) ** 2
        return float(np.sqrt(scale * optimize.brentq(excess, 0.0, upper)))

    tail = (1 - confidence) / 2
    return float(np.sqrt(max(square - trace, 0.0))), bound(1 - tail), bound(tail)
