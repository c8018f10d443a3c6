"""Bias instability over an alignment: flicker noise that begins with the record.

What it has done before counts as the stated bias.
"""

import numpy as np
from numpy.typing import NDArray
from scipy.special import xlogy

Array = NDArray[np.float64]

PROCESSES = 3
RATIO = 10.0
"""Of one correlation time to the next."""


def correlation_times(longest: float) -> Array:
    """(3,) of the Gauss-Markov processes whose sum stands for flicker: the longest, s, a tenth and
    a hundredth of it. What is faster yet is left to the sensors' white noise."""
    return np.asarray(longest / RATIO ** np.arange(PROCESSES))


def process_variance(coefficient: float) -> float:
    """Of each process.

    Processes of equal variance v whose correlation times T have equal ratios r: the sum of their
    densities 2 v T/(1 + (w T)^2), taken as an integral over the logarithm of T, is pi v/(w ln r);
    flicker's is B^2/w.

    Args:
        coefficient: B of IEEE Std 952.
    """
    return coefficient**2 * np.log(RATIO) / np.pi


def integral_covariance(coefficient: float, times: Array) -> Array:
    """(n, n) of flicker's integral at times (n,), s, since it began.

    Flicker is white noise summed half a time (`ins_eval.imu.flicker`), its integral one and a half
    times: the covariance at a and b is 4/pi B^2 times the integral of sqrt((a - u) (b - u)) over u
    up to the earlier one.
    """
    a, b = np.meshgrid(times, times)
    apart = np.abs(a - b)
    ratio = (np.sqrt(a) + np.sqrt(b)) ** 2 / np.where(apart > 0, apart, 1.0)
    within = (a + b) * np.sqrt(a * b) - xlogy(apart**2 / 2, ratio)
    return np.asarray(coefficient**2 / np.pi * within)


def mean_variance(coefficient: float) -> float:
    """Of flicker's mean from its beginning on: 2/pi B^2, over any duration."""
    return 2 / np.pi * coefficient**2
