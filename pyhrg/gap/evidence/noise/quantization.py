"""Quantization of the output angle, estimated from the angles themselves (Eq. (18))."""

import math
from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from pyhrg.common.units import ARCSEC
from pyhrg.device.device import Device
from pyhrg.gap.effects.catalogue import NOISE_EFFECTS, NOISES, NoiseEffect
from pyhrg.gap.evidence.noise.noise_hypothesis import NORMAL_95, AddedNoise
from pyhrg.gap.replay.inputs.table_steps import find_lattice_step
from pyhrg.gap.replay.observations import ObservedTest
from pyhrg.gap.replay.reading_noise import REST_RATE

QUANTIZATION = NOISE_EFFECTS["angle_quantisation"]
MIN_STEP, MAX_STEP = 0.01 * ARCSEC, 10 * ARCSEC
"""Range of quantization steps that are looked for, rad. Chosen."""
ROUNDING_ERROR = 1e-3 * MIN_STEP
"""Two second differences that differ by less are equal, rad. Chosen."""
STEP_TOLERANCE = 0.05
"""A stated step that differs from the estimated one by less than this share is no gap. Chosen."""


def find_quantization(
    tests: Sequence[ObservedTest],
    stated_step: float,
    noises: Sequence[NoiseEffect] = NOISES,
) -> AddedNoise | None:
    """The quantization of the output, where there is one in these tests that is not stated, rad (0:
    none). The readings show it whatever the effects are, so that it is no matter of odds."""
    step = find_quantization_step(tests) if QUANTIZATION in noises else None
    if step is None or abs(step[0] - stated_step) < STEP_TOLERANCE * stated_step:
        return None
    value, sigma = step
    ends = (value - NORMAL_95 * sigma, value + NORMAL_95 * sigma)
    return AddedNoise(QUANTIZATION, value, ends, math.inf, 0.0)


def put_quantization(device: Device, quantization: AddedNoise | None) -> Device:
    """The device with this quantization of its output."""
    return replace(device, quantization_step=quantization.total) if quantization else device


def find_quantization_step(tests: Sequence[ObservedTest]) -> tuple[float, float] | None:
    """Quantization step of the output angle and its standard deviation, rad, from tests without
    rotation; None where the angles are on no lattice. Second differences of angles on a lattice are
    on the same lattice."""
    parts = [
        np.diff(t.log.gyro_angle, 2)
        for t in tests
        if np.abs(t.inputs.table.rates).max() < REST_RATE and not np.ptp(t.log.virtual_rotation)
    ]
    differences = np.concatenate([np.empty(0), *parts])
    known = differences[np.isfinite(differences)]
    return find_lattice_step(known, MIN_STEP, MAX_STEP, ROUNDING_ERROR)
