"""Random draws of a channel's noise."""

import numpy as np
from numpy.typing import NDArray
from scipy.signal import lfilter

from pyhrg.gap.whitening.whitening import NoiseModel

Array = NDArray[np.float64]


def draw_noise(noise: NoiseModel, n: int, interval: float, generator: np.random.Generator) -> Array:
    """(n,) readings of a noise, in its unit.

    Slow terms start at zero; flicker starts in its stationary state, as `whiten` assumes.

    Args:
        noise: of one channel.
        n: number of readings.
        interval: between readings, s.
        generator: source of all draws.
    """
    rate = np.zeros(n)
    if noise.rate_random_walk:
        rate += np.cumsum(generator.normal(0.0, noise.rate_random_walk * np.sqrt(interval), n))
    reading = np.zeros(n)
    states = noise.states
    for lag, is_rate, density in zip(states.lags, states.rates, states.densities, strict=True):
        if density:
            lagged = _draw_lagged(lag, density, bool(is_rate), n, interval, generator)
            if is_rate:
                rate += lagged
            else:
                reading += lagged
    steps = generator.normal(0.0, noise.angle_random_walk * np.sqrt(interval), n)
    walk = np.cumsum(rate * interval + steps)
    return np.asarray(reading + walk + generator.normal(0.0, noise.white, n))


def _draw_lagged(
    lag: float,
    density: float,
    is_stationary: bool,
    n: int,
    interval: float,
    generator: np.random.Generator,
) -> Array:
    """(n,) white noise behind a first-order lag, stationary from the start or starting at zero."""
    kept = np.exp(-interval / lag)
    power = density * lag / 2
    steps = generator.normal(0.0, np.sqrt(power * (1 - kept**2)), n)
    if is_stationary:
        steps[0] = generator.normal(0.0, np.sqrt(power))
    return np.asarray(lfilter([1.0], [1.0, -kept], steps))
