"""Random draws of a channel's noise."""

import numpy as np
from numpy.typing import NDArray
from scipy.signal import lfilter

from pyhrg.gap.whitening.whitening import NoiseModel

Array = NDArray[np.float64]


def draw_noise(noise: NoiseModel, n: int, interval: float, generator: np.random.Generator) -> Array:
    """(n,) readings of one channel's noise, in its unit, `interval` seconds apart.

    Slow terms start at zero; flicker starts in its stationary state, as `whiten` assumes.
    """
    rate = np.zeros(n)
    if noise.rate_random_walk:
        rate += np.cumsum(generator.normal(0.0, noise.rate_random_walk * np.sqrt(interval), n))
    reading = np.zeros(n)
    states = noise.states
    for lag, is_rate, density in zip(states.lags, states.rates, states.densities, strict=True):
        if density:  # lags of the rate are stationary from the start, the others start at zero
            kept, power = np.exp(-interval / lag), density * lag / 2
            steps = generator.normal(0.0, np.sqrt(power * (1 - kept**2)), n)
            if is_rate:
                steps[0] = generator.normal(0.0, np.sqrt(power))
            lagging = rate if is_rate else reading
            lagging += np.asarray(lfilter([1.0], [1.0, -kept], steps))
    steps = generator.normal(0.0, noise.angle_random_walk * np.sqrt(interval), n)
    walk = np.cumsum(rate * interval + steps)
    return np.asarray(reading + walk + generator.normal(0.0, noise.white, n))
