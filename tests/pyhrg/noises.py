"""Angle records with the noises of IEEE Std 952, independent of the code under test."""

import numpy as np
from numpy.typing import NDArray
from scipy.signal import fftconvolve

FINER = 4
"""Steps of the flicker in an interval."""
BEFORE = 2
"""Lengths of the record that the flicker has run when it begins."""


Mixture = tuple[float, float, float, float, float]
"""Q (rad), N (rad/sqrt(s)), B (rad/s), K (rad/s/sqrt(s)), rate ramp R (rad/s^2)."""


def noisy_angle(
    n: int, coefficients: Mixture, generator: np.random.Generator
) -> NDArray[np.float64]:
    """A record at intervals of 1 s.

    Args:
        n: angles.
        coefficients: strengths.
        generator: of the noises.

    Returns:
        (n,) rad.
    """
    q, arw, flicker, rrw, ramp = coefficients
    white, steps, walk, within = generator.standard_normal((4, n))
    rate = np.concatenate([[0], np.cumsum(walk[1:])])
    steps = arw * steps + rrw * (rate + walk / 2 + within / np.sqrt(12))
    if flicker:
        steps = steps + flicker * _flicker(n, generator)
    angle = np.concatenate([[0], np.cumsum(steps[:-1])])
    return np.asarray(angle + q * white + ramp * np.arange(n) ** 2 / 2)


def _flicker(n: int, generator: np.random.Generator) -> NDArray[np.float64]:
    """Means over 1 s of a rate of density 1/(2 pi f): white noise half integrated (N. J. Kasdin,
    Discrete simulation of colored noise, Proc. IEEE 83 (1995))."""
    length = n * FINER * (1 + BEFORE)
    k = np.arange(1, length)
    response = np.concatenate([[1.0], np.cumprod((k - 0.5) / k)])
    rate = fftconvolve(generator.standard_normal(length), response)[length - n * FINER : length]
    return np.asarray(rate.reshape(n, FINER).mean(axis=1))
