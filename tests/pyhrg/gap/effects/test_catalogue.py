"""Effects as vectors: there and back, in the format's units, within what a gyro may have."""

import math
from dataclasses import replace

import numpy as np
import pytest

from pyhrg.challenge.scoring.score import COORDINATES
from pyhrg.common.units import DEG
from pyhrg.device.declarations import read_declarations
from pyhrg.device.device import Device
from pyhrg.gap.effects.catalogue import (
    DETERMINISTIC,
    EFFECT_NAMES,
    EFFECTS,
    FULL_CATALOGUE,
    Effect,
)

DEVICE = Device(damping_anisotropy=1e-6, damping_axis=20 * DEG, phase_error=1e-3)


@pytest.mark.parametrize("effect", DETERMINISTIC, ids=lambda effect: effect.name)
def test_vectors_come_back(effect: Effect) -> None:
    wanted = effect.scale * np.array([0.6, -0.3][: effect.size])
    put = effect.put(DEVICE, wanted)
    np.testing.assert_allclose(effect.vector(put), wanted, rtol=1e-12)
    np.testing.assert_allclose(effect.vector_of(effect.parameters(wanted)), wanted, rtol=1e-9)
    kept = {field: getattr(DEVICE, field) for field in effect.fields}
    assert replace(put, **kept) == DEVICE


@pytest.mark.parametrize("effect", DETERMINISTIC, ids=lambda effect: effect.name)
def test_vectors_end_where_gyros_do(effect: Effect) -> None:
    low, high = effect.bounds
    far = effect.put(DEVICE, np.full(effect.size, 1e9))
    assert np.linalg.norm(effect.vector(far)) == pytest.approx(high)
    if effect.size == 1:
        assert effect.vector(effect.put(DEVICE, np.array([-1e9]))) == pytest.approx(low)


def test_a_delay_is_never_negative() -> None:
    delay = EFFECTS["loop_delay"]
    assert delay.put(DEVICE, np.array([-1e-3])).loop_delay == 0.0


def test_every_declared_effect_has_one_name_and_one_position() -> None:
    declared = [d.effect for d in read_declarations(Device).values() if d.effect]
    positions = [effect.position for effect in declared if np.isfinite(effect.position)]
    assert len(set(positions)) == len(positions)
    assert len(set(EFFECT_NAMES)) == len(EFFECT_NAMES) == len(COORDINATES)
    assert [effect.name for effect in DETERMINISTIC][:2] == [
        "damping_anisotropy",
        "frequency_split",
    ]


def test_a_stated_tolerance_replaces_the_declared_one() -> None:
    """An effect of the gyro is then a nominal value, and an exact scale is known within it."""
    stated = {"decay_time_s": 20.0, "frequency_split_Hz": 1e-5, "amplitude_force_scale": 0.02}
    catalogue = FULL_CATALOGUE.with_tolerances(stated)
    known = {effect.name: effect for effect in catalogue.known}
    assert known["nominal_decay_time"].tolerance_of(Device(decay_time=450.0)) == 20.0
    assert known["frequency_split"].family == "nominal"
    assert known["frequency_split"].tolerance == pytest.approx(2 * math.pi * 1e-5)
    assert known["amplitude_force_scale"].tolerance == 0.02
    assert "frequency_split" not in {effect.name for effect in catalogue.effects}
    assert len(catalogue.parameters) == len(FULL_CATALOGUE.parameters)
    assert FULL_CATALOGUE.with_tolerances({}) == FULL_CATALOGUE
