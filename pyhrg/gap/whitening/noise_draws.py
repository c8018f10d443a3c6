"""Noise of a channel, drawn."""

import numpy as np
from numpy.typing import NDArray
from scipy.signal import lfilter

from pyhrg.gap.whitening.whitening import SlowNoise

Array = NDArray[np.float64]


def drawn(noise: SlowNoise, n: int, interval: float, generator: np.random.Generator) -> Array:
    """(n,) readings of a noise that starts at zero; flicker is as it ever was.

    Args:
        noise: in the channel's unit.
        n: number of readings.
        interval: between them, s.
        generator: of the draws.
    """
    rate = np.zeros(n)
    if noise.rate_walk:
        rate += np.cumsum(generator.normal(0.0, noise.rate_walk * np.sqrt(interval), n))
    reading = np.zeros(n)
    states = noise.states
    for lag, adds, density in zip(states.lags, states.rates, states.densities, strict=True):
        if density:
            lagged = _lagged(lag, density, bool(adds), n, interval, generator)
            if adds:
                rate += lagged
            else:
                reading += lagged
    walk = np.cumsum(rate * interval + generator.normal(0.0, noise.walk * np.sqrt(interval), n))
    return np.asarray(reading + walk + generator.normal(0.0, noise.white, n))


def _lagged(
    lag: float, density: float, old: bool, n: int, interval: float, generator: np.random.Generator
) -> Array:
    """(n,) white noise behind a first-order lag, that was always there or starts at zero."""
    kept = np.exp(-interval / lag)
    power = density * lag / 2
    steps = generator.normal(0.0, np.sqrt(power * (1 - kept**2)), n)
    if old:
        steps[0] = generator.normal(0.0, np.sqrt(power))
    return np.asarray(lfilter([1.0], [1.0, -kept], steps))
