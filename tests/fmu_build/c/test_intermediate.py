"""FMI 3.0: every tick within a step is an intermediate update, at which a step can end early."""

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

from tests.fmu_build.importer import Importer

PARAMETERS = {"seed": 4, "noise.pickOff": 1e-6, "startAngle": 0.2}


class Update:
    """The importer's callback: reads an output, and may ask for an early return."""

    def __init__(self, until: float | None = None) -> None:
        self.until = until
        self.gyro: Importer
        self.seen: list[tuple[float, float, bool]] = []
        self.refusals: list[str] = []

    def __call__(
        self,
        environment: Any,
        time: float,
        set_requested: bool,
        get_allowed: bool,
        finished: bool,
        can_return: bool,
        requested: Any,
        until: Any,
    ) -> None:
        assert (set_requested, get_allowed, finished) == (True, True, True)
        self.seen.append((time, *self.gyro.get(["gyroAngle"]), can_return))
        if len(self.seen) == 1:
            self.refusals = [
                self.gyro.refused(call)
                for call in (
                    lambda: self.gyro.slave.doStep(time, 0.001),
                    self.gyro.slave.reset,
                    self.gyro.save,
                    self.gyro.slave.terminate,
                )
            ]
        if self.until is not None:
            requested[0], until[0] = True, self.until


def _started(folder: Path, update: Update, may_return: bool = False) -> Importer:
    gyro = Importer(folder, intermediateUpdate=update, earlyReturnAllowed=may_return)
    update.gyro = gyro
    return gyro.begin(PARAMETERS)


@pytest.fixture
def plain(extracted: dict[int, Path]) -> Iterator[Importer]:
    """Without a callback."""
    gyro = Importer(extracted[3]).begin(PARAMETERS)
    gyro.set({"angularRate": 0.3})
    yield gyro
    gyro.free()


def test_updates_come_at_the_ticks_and_change_nothing(
    extracted: dict[int, Path], plain: Importer
) -> None:
    update = Update()
    gyro = _started(extracted[3], update)
    gyro.set({"angularRate": 0.3})
    assert gyro.slave.doStep(0.0, 0.0105) == (False, False, False, 0.0105)
    assert [time for time, *_ in update.seen] == pytest.approx([0.001 * i for i in range(1, 11)])
    for index, (_, angle, can_return) in enumerate(update.seen):
        plain.slave.doStep(0.001 * index, 0.001)
        assert plain.get(["gyroAngle"]) == [angle]
        assert not can_return
    assert all("not legal within a step" in text for text in update.refusals)
    assert len(update.refusals) == 4
    gyro.free()


@pytest.mark.parametrize(
    ("until", "reached"), [(0.0, 0.001), (0.001, 0.001), (0.0055, 0.0055), (0.02, 0.02)]
)
def test_step_ends_where_the_importer_asks(
    extracted: dict[int, Path], plain: Importer, until: float, reached: float
) -> None:
    gyro = _started(extracted[3], Update(until), may_return=True)
    gyro.set({"angularRate": 0.3})
    *_, early, time = gyro.slave.doStep(0.0, 0.02)
    assert early == (reached < 0.02)
    assert time == pytest.approx(reached)
    plain.slave.doStep(0.0, reached)
    assert gyro.get(["gyroAngle", "amplitude"]) == plain.get(["gyroAngle", "amplitude"])
    gyro.slave.doStep(time, 0.001)
    gyro.free()


def test_request_is_ignored_where_no_early_return_is_allowed(extracted: dict[int, Path]) -> None:
    gyro = _started(extracted[3], Update(0.001))
    assert gyro.slave.doStep(0.0, 0.02) == (False, False, False, 0.02)
    gyro.free()


def test_unknown_intermediate_variable_is_refused(extracted: dict[int, Path]) -> None:
    with pytest.raises(Exception, match="instantiate"):
        Importer(extracted[3], requiredIntermediateVariables=[999999])
