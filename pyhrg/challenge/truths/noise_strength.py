"""Strength of a noise beyond another, from the spectra of the output's increments
(docs/methods/challenge.md, Eq. 2), and of non-stationary noise beyond the best stationary noise.
"""

import math
from collections.abc import Sequence
from dataclasses import replace
from typing import Any

import numpy as np
from scipy.optimize import minimize

from pyhrg.bench.programme import Course
from pyhrg.common.arrays import Array
from pyhrg.device.device import Device
from pyhrg.gap.effects.catalogue import NoiseEffect

LEVELS = ("angle_random_walk", "angle_white_noise")
STATED_LEVEL_SIGMA = 0.03
"""Standard deviation of the logarithm of a stated noise level."""


def set_noise(device: Device, noise: NoiseEffect, value: float) -> Device:
    """A device with a noise at this value, SI."""
    changed: dict[str, Any] = {noise.field: value}
    return replace(device, **changed)


def measure_noise(device: Device, other: Device, courses: Sequence[Course]) -> float:
    """Strength of a device's noise beyond that of another device in tests, sigmas: the root of
    twice the divergence of the spectra (P. Whittle, 1953). The other's stated levels may be off by
    `STATED_LEVEL_SIGMA`."""

    def compute_squared_strength(logarithms: Array) -> float:
        off = zip(LEVELS, np.exp(STATED_LEVEL_SIGMA * logarithms), strict=True)
        changed: dict[str, Any] = {name: getattr(other, name) * x for name, x in off}
        moved = replace(other, **changed)
        divergence = sum(_divergence(device, moved, course) for course in courses)
        return 2 * divergence + float(logarithms @ logarithms)

    least = minimize(compute_squared_strength, np.zeros(len(LEVELS))).fun
    return math.sqrt(max(float(least), 0.0))


def _divergence(device: Device, other: Device, course: Course) -> float:
    """Divergence of the spectra of two devices' output increments in a test."""
    frequency = np.arange(1, len(course)) / (2 * len(course))
    ratio = _density(device, frequency, course) / _density(other, frequency, course)
    return float(np.sum(ratio - 1 - np.log(ratio)) / 2)


def _density(device: Device, frequency: Array, course: Course) -> Array:
    """Spectrum of an angle's increments over an interval, frequencies in cycles per row."""
    interval = course.interval
    white = device.angle_white_noise**2 + device.quantization_step**2 / 12
    step = 4 * np.sin(math.pi * frequency) ** 2
    rate = device.angle_random_walk**2 * interval
    flicker = device.bias_instability**2 * interval**2 / (2 * math.pi * frequency)
    walk = device.rate_random_walk**2 * interval**3 / step
    return np.asarray(white * step + rate + flicker + walk)


CELL = 16
"""Neighbouring coefficients of one time scale whose mean power is one estimate (chosen)."""


def measure_unsteadiness(kinds: Sequence[Sequence[Array]]) -> float:
    """Strength, sigmas, of noise that is added to white noise, beyond the stationary noise of any
    spectrum that imitates it best: the root of twice the divergence of the two.

    The added power is estimated in cells, from 16 Haar coefficients each: one time scale by one
    stretch of time. The expected contribution of their scatter is subtracted.

    Args:
        kinds: the added noise as series (n,), in standard deviations of the white noise; the series
            of one kind share a stationary spectrum.
    """
    return float(np.sqrt(max(sum(map(_measure_departure, kinds)), 0.0)))


def _measure_departure(series: Sequence[Array]) -> float:
    """Twice the divergence of series of one kind."""
    scales = [_average_cells(values) for values in series]
    total = 0.0
    for scale in range(max(map(len, scales), default=0)):
        added = np.concatenate([cells[scale] for cells in scales if scale < len(cells)])
        level = float(np.mean(added))
        ratio = (1 + added) / (1 + level)
        chance = (level / (1 + level)) ** 2
        total += float(np.sum(CELL * (ratio - 1 - np.log(ratio)) - chance))
    return total


def _average_cells(series: Array) -> list[Array]:
    """Mean power of the Haar coefficients in each cell, from the shortest time scale on."""
    scales = []
    smooth = series
    while len(smooth) >= 2 * CELL:
        pairs = smooth[: len(smooth) // 2 * 2].reshape(-1, 2)
        detail = (pairs[:, 0] - pairs[:, 1]) / np.sqrt(2)
        smooth = pairs.sum(axis=1) / np.sqrt(2)
        count = len(detail) // CELL
        scales.append(np.mean(detail[: count * CELL].reshape(count, CELL) ** 2, axis=1))
    return scales
