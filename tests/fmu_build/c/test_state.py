"""Saved states and communication steps leave no trace in the numbers, to the last bit."""

import random
import re
import struct
from collections.abc import Iterator
from pathlib import Path

import pytest

from tests.fmu_build.importer import Importer

PARAMETERS = {
    "seed": 11,
    "startAngle": 0.3,
    "noise.angleRandomWalk": 3e-5,
    "noise.pickOff": 1e-6,
    "noise.rateRandomWalk": 1e-8,
    "resonator.material.dampingAnisotropy": 1e-6,
    "pickOff.resolution": 1e-6,
}
INPUTS = {
    "angularRate": 0.5,
    "accelerationX": 9.8,
    "virtualRotation": 0.1,
    "caseTemperature": 320.0,
}
TICK = 1e-3


@pytest.fixture
def gyro(folder: Path) -> Iterator[Importer]:
    importer = Importer(folder).begin(PARAMETERS)
    yield importer
    importer.free()


def _partition(chance: random.Random, ticks: int) -> Iterator[int]:
    """Steps of 1 tick to 1 s that make up a time."""
    while ticks:
        step = min(ticks, chance.choice([1, 2, 3, 7, 10, 50, 100, 333, 1000]))
        yield step
        ticks -= step


@pytest.mark.parametrize("case", range(6))
def test_neither_steps_nor_saving_matter(folder: Path, case: int) -> None:
    """Inputs hold for a second; within it steps, restored states and other instances vary."""
    chance = random.Random(case)
    plain, broken = Importer(folder).begin(PARAMETERS), Importer(folder).begin(PARAMETERS)
    for second in range(3):
        values = {name: (1 + second) * value / 3 for name, value in INPUTS.items()}
        values["caseTemperature"] = 300.0 + second
        plain.set(values)
        broken.set(values)
        plain.slave.doStep(second, 1.0)
        ticks = 1000 * second
        for step in _partition(chance, 1000):
            if chance.random() < 0.2:
                state = broken.save()
                broken.slave.doStep(ticks * TICK, 0.05)
                if chance.random() < 0.5:
                    broken.free()
                    broken = Importer(folder)
                broken.restore(state)
            broken.slave.doStep(ticks * TICK, (ticks + step) * TICK - ticks * TICK)
            ticks += step
        assert plain.every() == broken.every()
    plain.free()
    broken.free()


@pytest.mark.parametrize("error", [9e-8, -9e-8])
def test_times_that_drift_do_not_matter(folder: Path, error: float) -> None:
    """Importers add up their steps and lose a microsecond in hours; here in ten seconds. No tick is
    late, and no input acts in another interval."""
    exact, drifting = Importer(folder).begin(PARAMETERS), Importer(folder).begin(PARAMETERS)
    for k in range(1000):
        for gyro, time in ((exact, k * 0.01), (drifting, k * 0.01 * (1 + error))):
            gyro.set({"angularRate": 0.5 * (-1) ** k})
            gyro.slave.doStep(time, 0.01)
    state = drifting.save()
    drifting.restore(state)
    assert drifting.save() == state
    outputs = [n for n, v in exact.variables.items() if v.causality == "output" and n != "valid"]
    assert drifting.get(outputs) == exact.get(outputs)


def test_same_state_same_bytes(folder: Path) -> None:
    """Whatever was read, saved or reset on the way there."""

    def run(importer: Importer, curious: bool) -> bytes:
        importer.begin(PARAMETERS)
        for step in range(5):
            importer.slave.doStep(step * 0.1, 0.1)
            if curious:
                importer.every()
                importer.save()
        return importer.save()

    fresh, used = Importer(folder), Importer(folder).begin({"noise.pickOff": 3e-5, "seed": 3})
    used.slave.doStep(0.0, 0.77)
    used.slave.reset()
    assert run(fresh, False) == run(used, True)
    fresh.free()
    used.free()


def test_state_is_taken_back_in_its_phase(folder: Path) -> None:
    importer = Importer(folder)
    before = importer.save()
    importer.begin(PARAMETERS)
    importer.slave.doStep(0.0, 0.5)
    importer.restore(before)
    importer.begin(PARAMETERS)
    fresh = Importer(folder).begin(PARAMETERS)
    assert importer.save() == fresh.save()
    importer.free()
    fresh.free()


@pytest.mark.parametrize("fmi", [2, 3])
def test_states_pass_between_the_standards(extracted: dict[int, Path], fmi: int) -> None:
    one, other = (Importer(extracted[f]).begin(PARAMETERS) for f in (fmi, 5 - fmi))
    one.slave.doStep(0.0, 0.5)
    other.restore(one.save())
    assert other.get(["gyroAngle", "amplitudeForce"]) == one.get(["gyroAngle", "amplitudeForce"])
    one.free()
    other.free()


def _forged(state: bytes, offset: int, value: bytes) -> bytes:
    """With other content, and the digest (Fowler, Noll, Vo: FNV-1a) to match."""
    content = state[8:offset] + value + state[offset + len(value) :]
    digest = 14695981039346656037
    for byte in content:
        digest = (digest ^ byte) * 1099511628211 % 2**64
    return struct.pack("<Q", digest) + content


PHASE, STOP_DEFINED, TICKS, TIME, OFFSET = (48 + 8 * i for i in (0, 1, 2, 3, 7))
VALUES = 48 + 8 * 8


@pytest.mark.parametrize(
    ("place", "value", "message"),
    [
        (8, b"another model", "not one of this model"),
        (PHASE, struct.pack("<Q", 3), "no legal phase or flag"),
        (PHASE, struct.pack("<Q", 2**63), "no legal phase or flag"),
        (STOP_DEFINED, struct.pack("<Q", 2), "no legal phase or flag"),
        (TICKS, struct.pack("<q", -5), "impossible times"),
        (TICKS, struct.pack("<q", 2**62), "impossible times"),
        (TIME, struct.pack("<d", float("nan")), "impossible times"),
        (TIME, struct.pack("<d", float("-inf")), "impossible times"),
        (OFFSET, struct.pack("<d", 1e9), "impossible times"),
        ("seed", struct.pack("<d", 0.5), r"seed = 0.5, which is outside its range"),
        ("startAngle", struct.pack("<d", float("inf")), "startAngle = inf, which is outside"),
        ("gyroAngle", struct.pack("<d", float("nan")), "gyroAngle = -?nan, which is outside"),
    ],
)
def test_impossible_state_is_refused_and_changes_nothing(
    gyro: Importer, place: int | str, value: bytes, message: str
) -> None:
    gyro.slave.doStep(0.0, 0.1)
    state = gyro.save()
    assert _forged(state, 8, b"") == state
    offset = VALUES + 8 * gyro.references([place])[0] if isinstance(place, str) else place
    text = gyro.refused(lambda: gyro.restore(_forged(state, offset, value)))
    assert re.search(message, text), text
    assert gyro.save() == state


@pytest.mark.parametrize("step", [1e-12, 1e-8, 1e-5])
def test_a_step_that_begins_early_does_not_turn_time_back(gyro: Importer, step: float) -> None:
    """Importers add up times; the slack grows with them, and a state must be legal everywhere."""
    now = 100.0004
    gyro.slave.doStep(0.0, now)
    gyro.slave.doStep(now - 0.9e-9 * (1 + now), step)
    state = gyro.save()
    gyro.restore(state)
    assert gyro.save() == state


def test_what_is_computed_on_demand_may_overflow_in_a_state(gyro: Importer) -> None:
    """It is computed anew, so that it is no part of what is restored."""
    gyro.slave.doStep(0.0, 0.1)
    state, value = gyro.save(), gyro.get(["frequencyOffset"])
    offset = VALUES + 8 * gyro.references(["frequencyOffset"])[0]
    gyro.restore(_forged(state, offset, struct.pack("<d", float("inf"))))
    assert gyro.get(["frequencyOffset"]) == value
    assert gyro.save() == state


def test_damaged_state_is_refused(gyro: Importer) -> None:
    state = gyro.save()
    chance = random.Random(1)
    for _ in range(200):
        damaged = bytearray(state)
        damaged[chance.randrange(len(state))] ^= 1 << chance.randrange(8)
        text = gyro.refused(lambda damaged=damaged: gyro.restore(bytes(damaged)))
        assert "damaged" in text or "not one of this model" in text
    assert "bytes are no state" in gyro.refused(lambda: gyro.restore(state[:-1]))
    assert gyro.save() == state
