"""Spoiled records are refused with their time; odd but sound ones are not."""

import math
from collections.abc import Callable
from dataclasses import replace

import numpy as np
import pytest

from ins_eval.alignment.align import align
from ins_eval.alignment.record_checks import check_samples
from ins_eval.common.sensor_errors import SensorErrors
from ins_eval.imu.specification import load_imu
from pyhrg.common.errors import HrgError
from pyhrg.common.units import DEG
from pyhrg.records.imu.log import Increments
from tests.ins_eval.alignment.cases import (
    POSITION,
    add_sensor_errors,
    attitude_error,
    make_boarded_record,
    make_still_record,
    make_swaying_record,
    make_turned_record,
)

SIMPLE = load_imu("simple").errors
MIDDLE = 1500
"""Increment at 150 s."""
Spoil = Callable[[Increments], None]


def make_sound_record(kind: str, seed: int = 1) -> Increments:
    rng = np.random.default_rng(seed)
    motions = {"swaying": make_swaying_record, "boarded": make_boarded_record}
    ideal = motions[kind](300.0, 0.1, rng)[0] if kind in motions else make_still_record(300.0, 0.1)
    return add_sensor_errors(ideal, SIMPLE, rng)


def corrupt(record: Increments, spoil: Spoil) -> Increments:
    copy = replace(record, rotation=record.rotation.copy(), velocity=record.velocity.copy())
    spoil(copy)
    return copy


def stick(*sensors: str, first: int = MIDDLE) -> Spoil:
    def spoil(record: Increments) -> None:
        for sensor in sensors:
            samples = getattr(record, sensor)
            samples[first : first + 1000] = samples[first]

    return spoil


def silence(record: Increments) -> None:
    record.rotation[MIDDLE : MIDDLE + 1000] = 0.0


def jump(sensor: str, axis: int, size: float, seconds: float = 0.1) -> Spoil:
    def spoil(record: Increments) -> None:
        count = round(seconds / record.interval)
        getattr(record, sensor)[MIDDLE : MIDDLE + count, axis] += size / count

    return spoil


@pytest.mark.parametrize("kind", ["still", "swaying", "boarded"])
@pytest.mark.parametrize(
    ("spoil", "message"),
    [
        (stick("rotation", "velocity"), "rotation stuck from 150.00 s: the same sample for 99.9 s"),
        (stick("rotation"), "rotation stuck from 150.00 s: the same sample for 99.9 s"),
        (stick("velocity"), "velocity stuck from 150.00 s: .*expected less than 5 s"),
        (stick("rotation", first=2000), "rotation stuck from 200.00 s"),
        (silence, "rotation stuck from 150.00 s"),
        (jump("rotation", 0, 0.5), "at 150.00 s, increment 1500: rotation .* by .*at most 1 rad/s"),
        (jump("rotation", 2, 30 * DEG), "at 150.00 s, increment 1500: rotation"),
        (jump("velocity", 1, 20.0), "at 150.00 s, increment 1500: velocity .* at most 50 m/s"),
    ],
)
def test_a_spoiled_record_is_refused(kind: str, spoil: Spoil, message: str) -> None:
    with pytest.raises(HrgError, match=message):
        align(corrupt(make_sound_record(kind), spoil), POSITION, SIMPLE)


@pytest.mark.parametrize("kind", ["still", "swaying", "boarded"])
@pytest.mark.parametrize(("turn_deg", "message"), [(3, "drifts over 10 steps"), (30, "still off")])
def test_a_turn_that_only_the_gyros_feel_is_refused(
    kind: str, turn_deg: float, message: str
) -> None:
    """Over 5 s, about down: too slow for a spike. Without the refusal heading is off by up to
    15 deg, and a sway of metres found."""
    record = corrupt(make_sound_record(kind), jump("rotation", 2, turn_deg * DEG, 5.0))
    with pytest.raises(HrgError, match=message):
        align(record, POSITION, SIMPLE)


def test_a_small_turn_that_only_the_gyros_feel_is_a_jump() -> None:
    record = corrupt(make_sound_record("still"), jump("rotation", 2, 1 * DEG, 5.0))
    with pytest.raises(HrgError, match=r"at 15\d.0 s: displacement jumps by \d+.* at most 12"):
        align(record, POSITION, SIMPLE)


@pytest.mark.parametrize("turn_deg", [90.0, 180.0, 360.0])
@pytest.mark.parametrize("errors", [SensorErrors(), SIMPLE])
def test_a_turntable_may_turn(turn_deg: float, errors: SensorErrors) -> None:
    """Ideal sensors repeat one sample for 140 s before the turn and 120 s after it."""
    rng = np.random.default_rng(2)
    ideal, truth = make_turned_record(300.0, 0.1, turn_deg * DEG)
    align(ideal, POSITION, SIMPLE)
    error = attitude_error(
        align(add_sensor_errors(ideal, errors, rng), POSITION, errors).mat_nb, truth
    )
    assert abs(error[2]) < 0.25 * DEG


def test_counts_may_repeat() -> None:
    """One count of the gyros in 20 samples, without noise: longest the same for 2 s; and, drowned
    in a quantum, never changing."""
    errors = SensorErrors(
        angle_quantization_step=20 * math.dist(make_still_record(1.0, 0.1).rotation[0], np.zeros(3))
    )
    rng = np.random.default_rng(3)
    check_samples(add_sensor_errors(make_still_record(300.0, 0.1), errors, rng))
    check_samples(
        add_sensor_errors(
            make_still_record(300.0, 0.1), replace(errors, angle_quantization_step=1.0), rng
        )
    )


def test_quiet_spells_of_coarse_counts_are_chance() -> None:
    """A count every 10 s on average, 20 records: repetitions beyond 5 s are the rule there."""
    rng = np.random.default_rng(4)
    for _ in range(20):
        counts = np.where(rng.random((3000, 3)) < 0.01 / 3, 1e-5, 0.0)
        check_samples(replace(make_still_record(300.0, 0.1), rotation=counts))


def test_far_too_small_errors_are_refused() -> None:
    with pytest.raises(HrgError, match=r"drifts over 10 .*errors are stated far too small"):
        align(make_sound_record("still"), POSITION, SensorErrors())
