"""Gyros recorded together against the same gyros one by one: the same bits."""

import threading
from collections.abc import Sequence
from contextlib import ExitStack
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from fmu_build.bundle import build_fmu
from pyhrg.common.arrays import Array
from pyhrg.device.ready_devices import TYPICAL
from pyhrg.fmu import Gyro, GyroError, GyroFmu, record_together
from pyhrg.fmu import together as module
from pyhrg.fmu.together import Lanes

FAULTS = (
    {"drive.authority": 2e-4, "resonator.material.dampingAnisotropy": 1e-4},
    {"controller.readout.quantum": 1e-7, "controller.synthesis.loopDelay": 1e-3},
    {"controller.startUp.firstTime": 0.2, "startAmplitude": 0.5, "pickOff.cubic": 0.05},
    {"pickOff.resolution": 1e-5, "pickOff.fullScale": 0.9, "resonator.material.duffing": 1.0},
    {"controller.forceToRebalance": 1.0, "resonator.material.frequencySplit": 0.5},
)
ENDS = ["gyroAngle", "patternAngle", "amplitude", "valid"]
MEANS = ["frequencyOffset", "amplitudeForce"]
Case = tuple[dict[str, float], int, float]


@pytest.fixture
def tries(monkeypatch: pytest.MonkeyPatch) -> list[bool]:
    """Whether each attempt to go together succeeded."""
    found: list[bool] = []
    record = Lanes.record

    def spy(*arguments: object) -> bool:
        found.append(record(*arguments))  # type: ignore[arg-type]
        return found[-1]

    monkeypatch.setattr(Lanes, "record", spy)
    return found


def draw_cases(fmu: GyroFmu, count: int) -> list[Case]:
    """Parameters, seed and start angle of different gyros, most of them with a fault."""
    generator = np.random.default_rng(count)
    cases = []
    for i in range(count):
        fault = FAULTS[i % len(FAULTS)] if i else {}
        parameters = {**TYPICAL.another(generator).fmu_parameters(), **fault}
        cases.append((parameters, i, float(generator.uniform(-4, 4))))
    return cases


def draw_inputs(count: int, rows: int) -> tuple[list[dict[str, Array]], list[dict[str, Array]]]:
    """Inputs of 10 ms steps in rows of 0.1 s; the drive is off for a while, and held inputs change
    in the middle."""
    generator = np.random.default_rng(rows)
    middle = np.arange(rows) >= rows // 2
    moving = [
        {
            "angularRate": generator.uniform(-5, 5) * np.sin(generator.normal(size=(rows, 10))),
            "caseTemperature": 300 + generator.normal(size=(rows, 10)),
        }
        for _ in range(count)
    ]
    held = [
        {
            "virtualRotation": generator.normal() * middle,
            "driveOn": 1.0 * (np.arange(rows) != 3),
            "accelerationX": generator.normal() * middle,
        }
        for _ in range(count)
    ]
    return moving, held


def run(
    fmu: GyroFmu, cases: Sequence[Case], together: bool, rows: int = 30
) -> tuple[list[tuple[Array, Array]], list[float]]:
    """Outputs of two recordings in turn, of which the second is always one by one, and times."""
    moving, held = draw_inputs(len(cases), rows)
    with ExitStack() as stack:
        gyros = [stack.enter_context(fmu.power_on(*case)) for case in cases]

        def one_by_one() -> list[tuple[Array, Array]]:
            inputs = zip(gyros, moving, held, strict=True)
            return [gyro.record(m, h, 0.01, ENDS, MEANS) for gyro, m, h in inputs]

        if together:
            outputs = record_together(gyros, moving, held, 0.01, ENDS, MEANS)
        else:
            outputs = one_by_one()
        outputs += one_by_one()
        return outputs, [gyro.time for gyro in gyros]


def check(fmu: GyroFmu, cases: Sequence[Case], rows: int = 30) -> None:
    """Together and one by one give the same bits, then and afterwards."""
    (some, at), (others, then) = (run(fmu, cases, way, rows) for way in (True, False))
    assert at == then
    for one, other in zip(some, others, strict=True):
        for values, expected in zip(one, other, strict=True):
            assert values.tobytes() == expected.tobytes()


@pytest.mark.parametrize("count", [2, 3, 4, 5, 8, 10])
def test_bits_are_those_of_single_gyros(fmu: GyroFmu, tries: list[bool], count: int) -> None:
    check(fmu, draw_cases(fmu, count))
    assert tries == [True] * (2 if count > 8 else 1)


def test_seeds_differ_in_their_lanes(fmu: GyroFmu) -> None:
    parameters = TYPICAL.fmu_parameters()
    moving, held = draw_inputs(1, 30)
    with ExitStack() as stack:
        gyros = [stack.enter_context(fmu.power_on(parameters, s, 0.3)) for s in (1, 2, 1)]
        outputs = record_together(gyros, moving * 3, held * 3, 0.01, ENDS)
    assert outputs[0][0].tobytes() == outputs[2][0].tobytes() != outputs[1][0].tobytes()


def test_gyros_with_and_without_noise_go_one_by_one(fmu: GyroFmu, tries: list[bool]) -> None:
    silent = replace(TYPICAL.without_noise(), quantization_step=0.0)
    cases = [*draw_cases(fmu, 2), (silent.fmu_parameters(), 0, 0.1)]
    check(fmu, cases)
    assert tries == [False]


def test_many_steps_go_in_parts(
    fmu: GyroFmu, tries: list[bool], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(module, "CHUNK", 70)
    check(fmu, draw_cases(fmu, 3), rows=17)
    assert tries == [True] * 3


def test_without_a_compiler_it_goes_one_by_one(
    fmu: GyroFmu, tries: list[bool], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(module, "load_lanes", lambda folder, width: None)
    check(fmu, draw_cases(fmu, 3))
    assert not tries


@pytest.mark.parametrize(("model", "rows"), [("HRGSlow", 30), ("HRGCarrier", 1)])
def test_other_models(model: str, rows: int, tries: list[bool]) -> None:
    cases: list[Case] = [({}, seed, 0.4 * seed) for seed in range(3)]
    check(GyroFmu(build_fmu(model)), cases, rows)
    assert tries == [True]


def test_quasi_steady_gyros_of_other_steps_go_one_by_one(tries: list[bool]) -> None:
    """Their step is a parameter."""
    cases: list[Case] = [({"samplePeriod": period}, 0, 0.4) for period in (0.01, 0.02)]
    check(GyroFmu(build_fmu("HRGSlow")), cases)
    assert tries == [False]


EXPLOSIVE = {"resonator.material.duffing": 100.0, "startAmplitude": 10.0}


@pytest.mark.parametrize(
    ("parameters", "rate", "message"),
    [({}, 1e3, "angularRate = 1000 is outside"), (EXPLOSIVE, 0.0, "no longer finite")],
)
def test_a_refusal_is_that_of_the_single_gyro(
    fmu: GyroFmu, tries: list[bool], parameters: dict[str, float], rate: float, message: str
) -> None:
    moving, held = draw_inputs(2, 4)
    moving[1]["angularRate"][2, 5] = rate

    def refuse(count: int) -> str:
        some = slice(2 - count, 2)
        gyros = [fmu.power_on(each, 1, 0.3) for each in ({}, parameters)[some]]
        inputs = (each[some] for each in (moving, held))
        with pytest.raises(GyroError, match=message) as error:
            record_together(gyros, *inputs, 0.01, ENDS)
        return str(error.value)

    assert refuse(2) == refuse(1)
    assert tries == [False]


@pytest.mark.parametrize("numbers", [(6, 9), (9, 6)])
def test_a_record_that_is_longer_is_whole(fmu: GyroFmu, numbers: tuple[int, int]) -> None:
    moving, held = (
        [{name: values[:n] for name, values in each.items()} for each in every for n in numbers]
        for every in draw_inputs(1, 9)
    )
    with ExitStack() as stack:
        gyros = [stack.enter_context(fmu.power_on({}, 0, 0.3)) for _ in numbers]
        short, long = sorted(
            record_together(gyros, moving, held, 0.01, ENDS), key=lambda x: len(x[0])
        )
    assert len(long[0]) == 9
    assert long[0][:6].tobytes() == short[0].tobytes()
    assert (long[0][6:] != 0).any(axis=1).all()


def test_gyros_are_of_one_fmu(fmu: GyroFmu, fmu_path: Path) -> None:
    moving, held = draw_inputs(2, 4)
    with ExitStack() as stack:
        gyros = [
            stack.enter_context(each.power_on({}, 0, 0.3)) for each in (fmu, GyroFmu(fmu_path))
        ]
        with pytest.raises(ValueError, match="different FMUs"):
            record_together(gyros, moving, held, 0.01, ENDS)


def test_inputs_have_the_same_names(fmu: GyroFmu) -> None:
    moving, held = draw_inputs(2, 4)
    del moving[1]["caseTemperature"]
    with ExitStack() as stack:
        gyros = [stack.enter_context(fmu.power_on({}, seed, 0.3)) for seed in range(2)]
        with pytest.raises(ValueError, match="different names"):
            record_together(gyros, moving, held, 0.01, ENDS)


def test_a_stop_ends_it(fmu_path: Path) -> None:
    fmu = GyroFmu(fmu_path)
    fmu.stop = threading.Event()
    fmu.stop.set()
    moving, held = draw_inputs(2, 4)
    gyros: list[Gyro] = [fmu.power_on({}, seed, 0.3) for seed in range(2)]
    with pytest.raises(GyroError, match="stopped"):
        record_together(gyros, moving, held, 0.01, ENDS)
