"""How far noises of the output angle part, by their spectra (P. Whittle, Ark. Mat. 2 (1953))."""

import math

import numpy as np
from numpy.typing import NDArray

from pyhrg.gap.next_test.candidate_tests import SLOW
from pyhrg.gap.whitening.whitening import SlowNoise

Array = NDArray[np.float64]


def divergence(
    truth: SlowNoise, rival: SlowNoise, duration: float, interval: float = SLOW
) -> float:
    """Expected logarithm of the likelihoods' ratio after one power-on, at which walks start from
    nothing: at the frequencies of such a walk's own modes.

    Args:
        truth: the noise that there is.
        rival: the one that is believed in.
        duration: of the power-on, s.
        interval: of its rows, s.
    """
    n = round(duration / interval)
    angular = np.pi * (2 * np.arange(n) + 1) / (2 * n + 1)
    ratio = spectrum(truth, interval, angular) / spectrum(rival, interval, angular)
    return float((ratio - 1 - np.log(ratio)).sum()) / 2


def spectrum(noise: SlowNoise, interval: float, angular: Array) -> Array:
    """(n,) density of the change from reading to reading, whose mean over all angular frequencies
    is its variance.

    Args:
        noise: of a reading.
        interval: between readings, s.
        angular: (n,) frequencies, rad per reading.
    """
    turn = np.cos(angular)
    steps = 2 - 2 * turn
    total = noise.white**2 * steps + noise.walk**2 * interval
    total = total + noise.rate_walk**2 * interval**3 / steps
    states = noise.states
    for lag, adds, density in zip(states.lags, states.rates, states.densities, strict=True):
        kept = math.exp(-interval / lag)
        power = density * lag / 2 * (1 - kept**2) / (1 + kept**2 - 2 * kept * turn)
        total = total + power * (interval**2 if adds else steps)
    return np.asarray(total)
