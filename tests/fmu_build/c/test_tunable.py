"""Parameters that can be set while the gyro runs: the compensations of its electronics."""

from collections.abc import Iterator
from pathlib import Path

import pytest

from tests.fmu_build.importer import Importer

MAP = {2: "controller.biasMap.mean", 3: "controller.biasMap.coefficients[1]"}
CANCELLATION = "controller.cancellation.dampingAnisotropy"
DEPENDENT = "controller.cancellation.quarterCos"
PUMP = "controller.pump"
RATE = 1e-3
"""Of the bias map, rad/s."""


@pytest.fixture
def gyro(model_folder: Path) -> Iterator[Importer]:
    importer = Importer(model_folder).begin({})
    importer.slave.doStep(0.0, 0.2)
    yield importer
    importer.free()


def _turn(gyro: Importer, time: float) -> float:
    """Angle that the output makes in 0.2 s."""
    (before,) = gyro.get(["gyroAngle"])
    gyro.slave.doStep(time, 0.2)
    (after,) = gyro.get(["gyroAngle"])
    return after - before


def test_a_new_bias_map_is_taken_out_from_the_next_tick_on(gyro: Importer) -> None:
    before = _turn(gyro, 0.2)
    gyro.set({MAP[gyro.fmi]: RATE})
    _turn(gyro, 0.4)
    assert _turn(gyro, 0.6) - before == pytest.approx(-0.2 * RATE, rel=1e-6)


def test_what_is_computed_from_one_follows(gyro: Importer) -> None:
    gyro.set({CANCELLATION: 1e-3})
    assert gyro.get([DEPENDENT]) == [1e-3 / 4]


def test_a_value_that_is_set_again_changes_no_bit(gyro: Importer, model_folder: Path) -> None:
    other = Importer(model_folder).begin({})
    other.slave.doStep(0.0, 0.2)
    gyro.set({MAP[gyro.fmi]: 0.0, CANCELLATION: 0.0})
    for each in (gyro, other):
        each.slave.doStep(0.2, 0.2)
    assert gyro.save() == other.save()
    other.free()


def test_the_amplitude_force_goes_over_to_parametric_drive(gyro: Importer) -> None:
    """In one tick, and back: the pump grows by the amplitude force, which stays."""
    (force,) = gyro.get(["amplitudeForce"])
    assert gyro.get([PUMP]) == [0.0]
    gyro.set({"controller.parametricShare": 1.0})
    gyro.slave.doStep(0.2, 0.2)
    assert gyro.get(["amplitudeForce", PUMP]) == pytest.approx([force, force], rel=1e-6)
    gyro.set({"controller.parametricShare": 0.0})
    gyro.slave.doStep(0.4, 0.2)
    assert gyro.get([PUMP]) == [0.0]


def test_a_limit_of_valid_output_moves(gyro: Importer) -> None:
    gyro.set({"amplitudeSetpoint": 1.05})
    gyro.slave.doStep(0.2, 0.1)
    assert gyro.get(["controller.startUp.valid"]) == [1.0]
    gyro.set({"controller.startUp.amplitudeTolerance": 1e-3})
    gyro.slave.doStep(0.3, 0.1)
    assert gyro.get(["controller.startUp.valid"]) == [0.0]


def test_they_are_declared(gyro: Importer) -> None:
    declared = {n for n, v in gyro.variables.items() if v.variability == "tunable"}
    settings = {"quadratureSetpoint", "parametricShare", "startUp.amplitudeTolerance"}
    assert {
        MAP[gyro.fmi],
        CANCELLATION,
        DEPENDENT,
        *(f"controller.{s}" for s in settings),
    } <= declared
    assert "controller.readout.bryanFactor" not in declared
    assert "controller.biasMap.samplePeriod" not in declared
