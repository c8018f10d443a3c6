"""What is read during initialization is what the start time has, and reading changes nothing."""

from collections.abc import Iterator
from pathlib import Path

import pytest

from tests.fmu_build.importer import Importer

PARAMETERS = {
    "seed": 3,
    "startAmplitude": 0.5,
    "startAngle": 0.3,
    "pickOff.offset": 1e-4,
    "noise.pickOff": 1e-6,
    "resonator.material.dampingAnisotropy": 1e-6,
}


@pytest.fixture
def gyro(model_folder: Path) -> Iterator[Importer]:
    importer = Importer(model_folder)
    importer.enter(2.0)
    yield importer
    importer.free()


def test_values_are_those_of_the_start_time(gyro: Importer) -> None:
    """Of all variables, to the last bit; whatever was read before the last of them was set."""
    before = gyro.every()
    gyro.set(PARAMETERS)
    during = gyro.every()
    assert during != before
    gyro.slave.exitInitializationMode()
    assert gyro.every() == during
    assert gyro.get(["amplitude", "patternAngle"]) == pytest.approx([0.5, 0.3], abs=1e-3)
    (force,) = gyro.get(["amplitudeForce"])
    assert force > 1.0  # the amplitude loop has seen what is missing


def test_reading_and_differentiating_change_no_byte(gyro: Importer) -> None:
    gyro.set(PARAMETERS)
    before = gyro.save()
    gyro.every()
    gyro.derivative(["amplitudeForce"], ["startAmplitude"], [1.0])
    assert gyro.save() == before


def test_what_was_read_has_no_effect_on_a_run(gyro: Importer, model_folder: Path) -> None:
    gyro.every()
    gyro.set(PARAMETERS)
    gyro.every()
    gyro.slave.exitInitializationMode()
    gyro.slave.doStep(2.0, 0.05)
    blind = Importer(model_folder).begin(PARAMETERS, start=2.0)
    blind.slave.doStep(2.0, 0.05)
    assert gyro.save() == blind.save()
    blind.free()


def test_values_follow_a_restored_state_and_a_reset(gyro: Importer) -> None:
    fresh, state = gyro.every(), gyro.save()
    gyro.set(PARAMETERS)
    assert gyro.every() != fresh
    gyro.restore(state)
    assert gyro.every() == fresh
    gyro.set(PARAMETERS)
    gyro.every()
    gyro.slave.reset()
    gyro.enter(2.0)
    assert gyro.every() == fresh
