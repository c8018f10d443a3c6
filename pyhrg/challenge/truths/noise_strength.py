"""Strength of a noise beyond another, from the spectra of the output's increments
(docs/methods/challenge.md, Eq. 2)."""

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
MAX_LEVEL_LOGARITHM = 10.0
"""Largest magnitude of the logarithm of a level over the stated one that the minimization tries.
Chosen: far beyond the minimum, whose prior is 333 standard deviations away; no number overflows."""


def set_noise(device: Device, noise: NoiseEffect, value: float) -> Device:
    """A device with a noise at this value, SI."""
    changed: dict[str, Any] = {noise.field: value}
    return replace(device, **changed)


def measure_noise(device: Device, other: Device, courses: Sequence[Course]) -> float:
    """Strength of a device's noise beyond that of another device in tests, sigmas: the root of
    twice the divergence of the spectra (P. Whittle, 1953). The other's stated levels may be off by
    `STATED_LEVEL_SIGMA`."""

    def compute_squared_strength(logarithms: Array) -> float:
        away = np.clip(STATED_LEVEL_SIGMA * logarithms, -MAX_LEVEL_LOGARITHM, MAX_LEVEL_LOGARITHM)
        off = zip(LEVELS, np.exp(away), strict=True)
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
