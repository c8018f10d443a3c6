"""Rate noise drawn outside the FMU: white noise, flicker, random walk."""

import math

import numpy as np
from numpy.typing import NDArray
from scipy.fft import irfft, next_fast_len, rfft, rfftfreq

from pyhrg.device.device import Device

Array = NDArray[np.float64]


def draw_rate_noise(
    device: Device, count: int, step: float, generator: np.random.Generator
) -> Array:
    """(count,) input-referred rate noise of a device, rad/s, each value the mean over a step, s.

    Densities are those of IEEE Std 952, annex C: N^2, B^2/(2 pi f), K^2/(2 pi f)^2. The same
    numbers are drawn whatever the coefficients are.
    """
    white, coloured, steps = generator.standard_normal((3, 2 * count))
    rate = device.angle_random_walk / math.sqrt(step) * white[:count]
    if device.bias_instability:
        rate += device.bias_instability * _flicker(coloured, step)[:count]
    walk = np.cumsum(steps[:count]) - steps[:count] / 2
    return np.asarray(rate + device.rate_random_walk * math.sqrt(step) * walk)


def _flicker(white: Array, step: float) -> Array:
    """Flicker of unit coefficient, by shaping white noise in frequency. The period is twice the
    record, so that start and end are not correlated."""
    length = next_fast_len(len(white), real=True)
    frequency = rfftfreq(length, step)
    frequency[0] = frequency[1] / 2
    padded = np.concatenate((white, white[: length - len(white)]))
    shaped = rfft(padded) / np.sqrt(2 * math.pi * frequency * step)
    return np.asarray(irfft(shaped, length))
