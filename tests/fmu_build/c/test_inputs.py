"""Inputs within a step: the angle of the case, first derivatives, values at ticks."""

import math
import xml.etree.ElementTree as ET
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from pyhrg.fmu import GyroFmu, record_together
from tests.fmu_build.importer import Importer

AMPLITUDE = 0.5
"""The case turns at this times sin t, rad/s; 517 arcsec off where a step of 10 ms holds it."""
ARCSEC = math.pi / 180 / 3600
DURATION = 2.0

Setter = Callable[[Importer, float, float], None]


def rate(time: float) -> float:
    return AMPLITUDE * math.sin(time)


def angle(time: float) -> float:
    return AMPLITUDE * (1 - math.cos(time))


def hold(gyro: Importer, time: float, step: float) -> None:
    gyro.set({"angularRate": rate(time)})


def average(gyro: Importer, time: float, step: float) -> None:
    gyro.set({"angularRate": (angle(time + step) - angle(time)) / step})


def turn(gyro: Importer, time: float, step: float) -> None:
    gyro.set({"caseAngle": angle(time + step)})


def slope(gyro: Importer, name: str, value: float, order: int = 1) -> None:
    gyro.slave.setRealInputDerivatives(gyro.references([name]), [order], [value])


def follow(gyro: Importer, time: float, step: float) -> None:
    hold(gyro, time, step)
    slope(gyro, "angularRate", AMPLITUDE * math.cos(time))


def turned(folder: Path, setter: Setter, step: float) -> float:
    """What the gyro measured over the duration, rad."""
    gyro = Importer(folder).begin({})
    begin = gyro.get(["gyroAngle"])[0]
    for i in range(round(DURATION / step)):
        setter(gyro, i * step, step)
        gyro.slave.doStep(i * step, step)
    end = gyro.get(["gyroAngle"])[0]
    gyro.free()
    return end - begin


@pytest.mark.parametrize("step", [0.1, 0.4, 2.0])
def test_angle_is_exact_at_any_step(model_folder: Path, step: float) -> None:
    """The turn of each step is that of its mean rate, and no step loses any."""
    measured = turned(model_folder, turn, step)
    assert measured == pytest.approx(turned(model_folder, average, step), abs=1e-12)
    assert measured == pytest.approx(angle(DURATION), abs=2e-3)


@pytest.mark.parametrize("step", [0.01, 0.1])
def test_first_derivative_leaves_the_second(extracted: dict[int, Path], step: float) -> None:
    """A step misses h^3/6 of the second derivative: the run h^2/6 of the first's change."""
    exact = turned(extracted[2], turn, step)
    missed = AMPLITUDE * (math.cos(DURATION) - 1) * step**2 / 6
    held = AMPLITUDE * math.sin(DURATION) * step / 2
    assert exact - turned(extracted[2], follow, step) == pytest.approx(missed, rel=0.1)
    assert exact - turned(extracted[2], hold, step) == pytest.approx(held, rel=0.1)


def test_derivative_holds_for_one_step(extracted: dict[int, Path]) -> None:
    gyro = Importer(extracted[2]).begin({"virtualRotation": 0.0})
    slope(gyro, "caseTemperature", 10.0)
    slope(gyro, "angularRate", 2.0)
    gyro.slave.doStep(0.0, 0.25)
    assert gyro.get(["angularRate", "caseTemperature"]) == pytest.approx([0.5, 300.65], abs=1e-9)
    gyro.slave.doStep(0.25, 0.25)
    assert gyro.get(["angularRate", "caseTemperature"]) == pytest.approx([0.5, 300.65], abs=1e-9)
    gyro.free()


def test_derivatives_are_saved_and_reset(extracted: dict[int, Path]) -> None:
    def end(gyro: Importer) -> list[float]:
        gyro.slave.doStep(0.5, 0.25)
        return gyro.every()

    gyro = Importer(extracted[2]).begin({})
    gyro.slave.doStep(0.0, 0.5)
    plain = gyro.save()
    slope(gyro, "angularRate", 1.0)
    gyro.set({"caseAngle": 0.2})
    saved = gyro.save()
    expected = end(gyro)
    gyro.restore(saved)
    assert end(gyro) == expected
    gyro.restore(plain)
    assert end(gyro) != expected
    gyro.free()


def test_derivative_that_makes_no_sense_is_refused(extracted: dict[int, Path]) -> None:
    gyro = Importer(extracted[2]).begin({})
    refused = gyro.refused
    assert "no real input" in refused(lambda: slope(gyro, "startAngle", 1.0))
    assert "order 2 of angularRate" in refused(lambda: slope(gyro, "angularRate", 1.0, order=2))
    assert "angularRate is nan" in refused(lambda: slope(gyro, "angularRate", math.nan))
    slope(gyro, "driveOn", 1.0)
    message = refused(lambda: gyro.slave.doStep(0.0, 0.1))
    assert message == "the step leads to driveOn = 1.1, which is outside its range from 0 to 1"
    slope(gyro, "driveOn", -1.0)
    gyro.slave.doStep(0.0, 0.1)
    assert gyro.get(["driveOn"]) == pytest.approx([0.9])
    gyro.free()


def test_angle_begins_where_it_is_set_before_the_start(folder: Path) -> None:
    gyro, still = (Importer(folder).begin({"caseAngle": value}) for value in (0.7, 0.0))
    for each in (gyro, still):
        each.slave.doStep(0.0, 0.1)
    assert gyro.get(["gyroAngle", "patternAngle"]) == still.get(["gyroAngle", "patternAngle"])
    gyro.set({"caseAngle": 20.0})
    message = gyro.refused(lambda: gyro.slave.doStep(0.1, 0.1))
    assert message.startswith("the step leads to angularRate = 193")
    gyro.free()
    still.free()


def test_angle_adds_to_the_rate(folder: Path) -> None:
    """A turntable's encoder beside the Earth's rate."""
    both, one = (Importer(folder).begin({}) for _ in range(2))
    for i in range(20):
        both.set({"caseAngle": 0.3 * 0.05 * (i + 1), "angularRate": 0.1})
        one.set({"angularRate": 0.4})
        for gyro in (both, one):
            gyro.slave.doStep(i * 0.05, 0.05)
    assert both.get(["angularRate"]) == [0.1]
    assert both.get(["gyroAngle"]) == pytest.approx(one.get(["gyroAngle"]), abs=1e-13)
    both.free()
    one.free()


class Update:
    """An importer's callback that sets the rate, and may end the first step."""

    def __init__(self, values: bool, until: float | None = None) -> None:
        self.values, self.until = values, until
        self.gyro: Importer

    def __call__(self, environment: Any, time: float, *rest: Any) -> None:
        if self.values:
            self.gyro.set({"angularRate": rate(time)})
        if self.until is not None:
            rest[-2][0], rest[-1][0] = True, self.until
            self.until = None


def begin(folder: Path, update: Update) -> Importer:
    gyro = Importer(folder, intermediateUpdate=update, earlyReturnAllowed=True).begin({})
    update.gyro = gyro
    return gyro


def test_values_set_at_a_tick_hold_from_there(extracted: dict[int, Path]) -> None:
    gyro = begin(extracted[3], Update(values=True))
    for i in range(5):
        gyro.set({"angularRate": rate(0.02 * i)})
        gyro.slave.doStep(0.02 * i, 0.02)
    ticked = Importer(extracted[3]).begin({})
    for i in range(100):
        hold(ticked, 0.001 * i, 0.001)
        ticked.slave.doStep(0.001 * i, 0.001)
    assert gyro.get(["gyroAngle"]) == pytest.approx(ticked.get(["gyroAngle"]), abs=1e-15)
    gyro.free()
    ticked.free()


def test_angle_is_reached_after_an_early_return(extracted: dict[int, Path]) -> None:
    gyro = begin(extracted[3], Update(values=False, until=0.05))
    gyro.set({"caseAngle": 0.1})
    *_, time = gyro.slave.doStep(0.0, 0.2)
    early = gyro.get(["gyroAngle"])[0]
    for i in range(15):
        gyro.slave.doStep(time + 0.01 * i, 0.01)
    gyro.slave.doStep(time + 0.15, 0.1)
    assert [early, *gyro.get(["gyroAngle"])] == pytest.approx([0.025, 0.1], abs=1e-5)
    gyro.free()


def test_within_a_step_only_the_inputs_of_updates_are_set(extracted: dict[int, Path]) -> None:
    messages = []

    class Wrong(Update):
        def __call__(self, environment: Any, time: float, *rest: Any) -> None:
            if not messages:
                for name in ("caseAngle", "startAngle"):
                    messages.append(self.gyro.refused(lambda n=name: self.gyro.set({n: 0.1})))

    gyro = begin(extracted[3], Wrong(values=False))
    gyro.slave.doStep(0.0, 0.01)
    assert "can't be set within it" in messages[0]
    assert "after initialization" in messages[1]
    gyro.free()
    described = ET.parse(extracted[3] / "modelDescription.xml")  # FMPy reads no such attribute
    declared = {v.get("name") for v in described.iterfind(".//*[@intermediateUpdate='true']")}
    assert {"angularRate", "gyroAngle"} <= declared
    assert "caseAngle" not in declared


def test_gyros_together_leave_the_angle_to_each(fmu: GyroFmu) -> None:
    angles = np.linspace(0.0, 0.1, 21)[1:, None]
    held = {"driveOn": np.ones(20)}

    def start() -> list[Any]:
        return [fmu.power_on({}, seed=i, start_angle=0.1) for i in range(3)]

    gyros, alone = start(), start()
    together = record_together(gyros, [{"caseAngle": angles}] * 3, [held] * 3, 0.01, ["gyroAngle"])
    for gyro, (ends, _) in zip(alone, together, strict=True):
        assert (gyro.record({"caseAngle": angles}, held, 0.01, ["gyroAngle"])[0] == ends).all()
        assert ends[-1, 0] == pytest.approx(0.1, abs=1e-5)
