"""The latitude that the gyros show must be the stated one."""

from dataclasses import replace

import numpy as np
import pytest

from ins_eval.alignment.align import align
from ins_eval.alignment.record_checks import check_latitude
from ins_eval.common.sensor_errors import SensorErrors
from ins_eval.imu.specification import load_imu
from pyhrg.common.errors import HrgError
from pyhrg.common.units import DEG, DEG_PER_H
from pyhrg.records.imu.log import Increments
from tests.ins_eval.alignment.cases import (
    LATITUDE,
    POSITION,
    add_sensor_errors,
    make_boarded_record,
    make_creeping_record,
    make_still_record,
    make_swaying_record,
    make_turned_record,
)

SIMPLE = load_imu("simple").errors


def standing(kind: str) -> Increments:
    rng = np.random.default_rng(1)
    motions = {"boarded": make_boarded_record, "creeping": make_creeping_record}
    ideal = motions[kind](300.0, 0.1, rng)[0] if kind in motions else make_still_record(300.0, 0.1)
    return add_sensor_errors(ideal, SIMPLE, rng)


@pytest.mark.parametrize("kind", ["still", "boarded", "creeping"])
def test_a_wrong_sign_of_the_latitude_is_refused(kind: str) -> None:
    message = (
        r"latitude (39|4[01])\.\d+ deg: expected the stated -40.00 deg.*: latitude's sign, or gyro"
    )
    with pytest.raises(HrgError, match=message):
        align(standing(kind), POSITION * [-1, 1, 1], SIMPLE)


@pytest.mark.parametrize("kind", ["still", "boarded", "creeping"])
def test_reversed_gyros_are_refused(kind: str) -> None:
    record = standing(kind)
    message = r"latitude -(39|4[01])\.\d+ deg: expected the stated 40.00 deg.*gyros reversed\?"
    with pytest.raises(HrgError, match=message):
        align(replace(record, rotation=-record.rotation), POSITION, SIMPLE)


def test_reversed_gyros_of_a_swaying_vehicle_contradict_its_accelerometers() -> None:
    ideal, _ = make_swaying_record(300.0, 0.1, np.random.default_rng(5))
    record = replace(ideal, rotation=-ideal.rotation)
    with pytest.raises(HrgError, match="drifts over 10 steps"):
        align(record, POSITION, SIMPLE)


@pytest.mark.parametrize(("off_deg", "refused"), [(-6, True), (-4, False), (4, False), (8, True)])
def test_some_degrees_are_let_pass(off_deg: float, refused: bool) -> None:
    stated = LATITUDE + off_deg * DEG
    if refused:
        with pytest.raises(HrgError, match=": latitude, or gyros"):
            check_latitude(make_still_record(300.0, 0.1), stated, SIMPLE)
    else:
        check_latitude(make_still_record(300.0, 0.1), stated, SIMPLE)


def test_what_gyros_may_be_wrong_by_is_let_pass() -> None:
    """2 deg/h about the vertical shows a latitude of 31 deg."""
    record = make_still_record(300.0, 0.1)
    up = record.velocity[0] / np.linalg.norm(record.velocity[0])
    biased = replace(record, rotation=record.rotation - 2 * DEG_PER_H * up * 0.1)
    check_latitude(biased, LATITUDE, SensorErrors(gyro_bias=1 * DEG_PER_H))
    with pytest.raises(HrgError, match="show latitude 30"):
        check_latitude(biased, LATITUDE, SensorErrors(gyro_bias=0.01 * DEG_PER_H))


@pytest.mark.parametrize("turn_deg", [1.0, 90.0])
def test_a_vehicle_that_turns_shows_no_latitude(turn_deg: float) -> None:
    """1 deg in 300 s is 12 deg/h, nearly Earth's rate."""
    record, _ = make_turned_record(300.0, 0.1, turn_deg * DEG)
    check_latitude(record, LATITUDE, SIMPLE)
