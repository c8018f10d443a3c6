"""Kullback-Leibler divergence of two noises of the output angle, from their spectra.

Whittle's approximation (docs/methods/next_test.md, Eq. (4); P. Whittle, Ark. Mat. 2 (1953)).
"""

import math

import numpy as np

from pyhrg.common.arrays import Array
from pyhrg.gap.next_test.candidate_tests import LONG_ROWS
from pyhrg.gap.whitening.whitening import NoiseModel


def compute_divergence(
    truth: NoiseModel, rival: NoiseModel, duration: float, interval: float = LONG_ROWS
) -> float:
    """Expected log likelihood ratio of the true noise over a rival after one power-on of a
    duration, s, in rows of an interval, s.

    Random walks start from zero at power-on. The frequencies are therefore those of the eigenmodes
    of a walk that starts from zero.
    """
    n = round(duration / interval)
    angular = np.pi * (2 * np.arange(n) + 1) / (2 * n + 1)
    true_spectrum, rival_spectrum = (
        compute_increment_spectrum(noise, interval, angular) for noise in (truth, rival)
    )
    ratio = true_spectrum / rival_spectrum
    return float((ratio - 1 - np.log(ratio)).sum()) / 2


def compute_increment_spectrum(noise: NoiseModel, interval: float, angular: Array) -> Array:
    """(n,) power spectral density of the angle's increments between consecutive readings at (n,)
    angular frequencies, rad per reading (Eq. 5). The interval between readings is in s. The mean of
    the density over all frequencies is the variance of an increment."""
    cosine = np.cos(angular)
    difference = 2 - 2 * cosine
    total = noise.angle_white_noise**2 * difference + noise.angle_random_walk**2 * interval
    total = total + noise.rate_random_walk**2 * interval**3 / difference
    states = noise.states
    for lag, of_rate, density in zip(states.lags, states.rates, states.densities, strict=True):
        decay = math.exp(-interval / lag)
        power = density * lag / 2 * (1 - decay**2) / (1 + decay**2 - 2 * decay * cosine)
        total = total + power * (interval**2 if of_rate else difference)
    return np.asarray(total)
