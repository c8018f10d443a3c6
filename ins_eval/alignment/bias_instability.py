"""Bias instability during an alignment: flicker noise that begins with the record.

Its variation before the record counts as the stated bias (docs/methods/alignment.md, Eqs. 10, 11).
"""

import numpy as np
from scipy.special import xlogy

from ins_eval.common.arrays import Array

PROCESSES = 3
"""Number of Gauss-Markov processes that approximate flicker noise. Chosen."""
RATIO = 10.0
"""Ratio of one correlation time to the next. Chosen."""


def correlation_times(longest: float) -> Array:
    """Return the correlation times (3,), s, of the processes whose sum approximates flicker noise.

    They are the longest, a tenth and a hundredth of it. Faster variation is part of the sensors'
    white noise.
    """
    return np.asarray(longest / RATIO ** np.arange(PROCESSES))


def process_variance(coefficient: float) -> float:
    """Return the variance of each process, B^2 ln r / pi.

    Processes of equal variance v whose correlation times T have the ratio r have the total density
    sum of 2 v T/(1 + (w T)^2). As an integral over the logarithm of T it is pi v/(w ln r), and that
    of flicker noise is B^2/w.

    Args:
        coefficient: B of IEEE Std 952, in the unit of the noise.
    """
    return coefficient**2 * np.log(RATIO) / np.pi


def integral_covariance(coefficient: float, times: Array) -> Array:
    """Return the covariance (n, n) of the integral of flicker noise at times (n,), s, since its
    beginning.

    Flicker noise is the half-order integral of white noise (`ins_eval.imu.flicker`). The covariance
    of its integral at times a and b is 4/pi B^2 times the integral of sqrt((a - u) (b - u)) over u
    from 0 to the earlier time.
    """
    a, b = np.meshgrid(times, times)
    lag = np.abs(a - b)
    ratio = (np.sqrt(a) + np.sqrt(b)) ** 2 / np.where(lag > 0, lag, 1.0)
    integral = (a + b) * np.sqrt(a * b) - xlogy(lag**2 / 2, ratio)
    return np.asarray(coefficient**2 / np.pi * integral)


def mean_variance(coefficient: float) -> float:
    """Return the variance of the mean of flicker noise since its beginning: 2/pi B^2, at any
    time."""
    return 2 / np.pi * coefficient**2
