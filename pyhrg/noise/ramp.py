"""The rate ramp of an angle record, under noise that was fitted to it."""

import numpy as np
from scipy.fft import dct

from pyhrg.common.arrays import Array
from pyhrg.noise.coefficients import COEFFICIENT_NAMES, Coefficient, NoiseCoefficients
from pyhrg.noise.fitting import NORMAL_QUANTILE
from pyhrg.noise.likelihood import POWERS, compute_shapes


def estimate_rate_ramp(angle: Array, interval: float, noise: NoiseCoefficients) -> Coefficient:
    """Rate ramp, rad/s^2, by generalized least squares (Eq. 17 of docs/methods/noise.md).

    Angles are (n,) rad, evenly spaced by the interval, s. The confidence interval covers the true
    ramp with at least 95 %. It is normal, and its variance includes the largest rate random walk
    that the record allows, whose slope from end to end can't be told from a ramp.
    """
    n = len(angle)
    time = interval * (np.arange(n) - (n - 1) / 2)
    columns = np.array([time, time**2 / 2])
    *trends, record = dct(np.vstack([columns, angle]), norm="ortho")[:, 1:]
    units = np.array([interval ** ((1 - max(power, 1)) / 2) for power in POWERS])
    levels = np.array([getattr(noise, name).value for name in COEFFICIENT_NAMES])
    density = (levels / units) ** 2 @ compute_shapes(np.arange(1, n) / (2 * n))
    weighted = np.array(trends) / density
    covariance = np.linalg.inv(weighted @ np.array(trends).T)
    value = float((covariance @ (weighted @ record))[1])
    duration = n * interval
    variance = covariance[1, 1] + noise.rate_random_walk.high**2 / duration
    variance += 8 / np.pi * (noise.bias_instability.value / duration) ** 2
    reach = NORMAL_QUANTILE * float(np.sqrt(variance))
    return Coefficient(value, value - reach, value + reach)
