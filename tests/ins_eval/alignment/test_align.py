"""Coarse, then fine: vehicles that sway, and records that are refused."""

from collections.abc import Callable
from dataclasses import replace

import numpy as np
import pytest

from ins_eval.alignment.align import align
from ins_eval.alignment.analytic import level_and_gyrocompass
from ins_eval.common.sensor_errors import SensorErrors
from ins_eval.imu.specification import load_imu
from ins_eval.trajectories.catalogue import load_trajectory
from pyhrg.common.errors import HrgError
from pyhrg.common.units import ARCSEC, DEG, DEG_PER_H, DEG_PER_SQRT_H, MICRO_G
from pyhrg.records.imu.log import Increments
from tests.ins_eval.alignment.cases import (
    LATITUDE,
    MAT_NB,
    POSITION,
    add_sensor_errors,
    attitude_error,
    chi_square_interval,
    make_boarded_record,
    make_creeping_record,
    make_still_record,
    make_swaying_record,
    normalised_square,
)

Motion = Callable[[float, float, np.random.Generator], tuple[Increments, np.ndarray]]

ERRORS = SensorErrors(
    gyro_bias=0.01 * DEG_PER_H,
    angle_random_walk=0.002 * DEG_PER_SQRT_H,
    accelerometer_bias=50 * MICRO_G,
    velocity_random_walk=1e-4,
)


SIMPLE = load_imu("simple").errors
HRG = SensorErrors(
    gyro_bias=0.01 * DEG_PER_H,
    angle_random_walk=1e-4 * DEG_PER_SQRT_H,
    angle_quantization_step=0.07 * ARCSEC,
    accelerometer_bias=5 * MICRO_G,
    velocity_random_walk=5e-5,
    accelerometer_bias_instability=1 * MICRO_G,
)


def test_perfect_sensors_on_a_swaying_vehicle() -> None:
    """Heading to 0.01 deg of a vehicle that sways by a degree; averaging is off by degrees."""
    record, truth = make_swaying_record(300.0, 0.05, np.random.default_rng(3))
    result = align(record, POSITION, SensorErrors(velocity_random_walk=1e-6))
    error = np.abs(attitude_error(result.mat_nb, truth))
    assert np.all(error < [1e-5, 1e-5, 0.01 * DEG])
    assert result.sway == pytest.approx(0.02, rel=0.25)
    averaged = level_and_gyrocompass(record, LATITUDE)
    assert abs(attitude_error(averaged, truth)[2]) > 1.0 * DEG


@pytest.mark.parametrize("motion", [make_swaying_record, make_boarded_record, make_creeping_record])
def test_covariance_on_moving_vehicles_is_consistent(motion: Motion) -> None:
    """20 vehicles, sway found from the record, no bias to hide behind; 99 % interval; seed 4."""
    rng, count = np.random.default_rng(4), 20
    unbiased = replace(SIMPLE, gyro_bias=0.0, accelerometer_bias=0.0)
    squares = []
    for _ in range(count):
        ideal, truth = motion(300.0, 0.1, rng)
        result = align(add_sensor_errors(ideal, unbiased, rng), POSITION, unbiased)
        squares.append(normalised_square(result, truth))
    low, high = chi_square_interval(count, 3)
    assert low < np.mean(squares) < high


@pytest.mark.parametrize("errors", [SIMPLE, HRG])
def test_a_still_vehicle_is_aligned_no_worse_than_by_averaging(errors: SensorErrors) -> None:
    """20 vehicles, biases apart, which both methods feel alike: errors normalised by their
    covariance, 99 % interval, and headings that scatter by at most a fifth more; seed 6."""
    rng, count = np.random.default_rng(6), 20
    unbiased = replace(errors, gyro_bias=0.0, accelerometer_bias=0.0)
    squares, headings = [], []
    for _ in range(count):
        record = add_sensor_errors(make_still_record(300.0, 0.5), unbiased, rng)
        result = align(record, POSITION, unbiased)
        squares.append(normalised_square(result, MAT_NB))
        both = (result.mat_nb, level_and_gyrocompass(record, LATITUDE))
        headings.append([attitude_error(mat_nb, MAT_NB)[2] for mat_nb in both])
    low, high = chi_square_interval(count, 3)
    assert low < np.mean(squares) < high
    fine, averaged = np.sqrt(np.mean(np.square(headings), axis=0))
    assert fine < 1.2 * averaged


def test_averaging_a_vehicle_that_sinks_is_far_off() -> None:
    """The control: averages know nothing of motion. Fine alignment drops the steady tilt."""
    rng = np.random.default_rng(8)
    ideal, truth = make_creeping_record(300.0, 0.1, rng)
    record = add_sensor_errors(ideal, SIMPLE, rng)
    result = align(record, POSITION, SIMPLE)
    averaged = level_and_gyrocompass(record, LATITUDE)
    assert normalised_square(replace(result, mat_nb=averaged), truth) > 100
    assert normalised_square(result, truth) < 15


def test_result_does_not_depend_on_the_coarse_attitude_being_good() -> None:
    """A gyro of 1 deg/h leaves coarse and fine in error by degrees; both by the same bias."""
    east = MAT_NB.T @ np.array([0.0, 1 * DEG_PER_H, 0.0])
    ideal = make_still_record(120.0, 0.1)
    record = Increments(0.1, ideal.rotation + east * 0.1, ideal.velocity)
    result = align(record, POSITION, SensorErrors(gyro_bias=1 * DEG_PER_H))
    expected = level_and_gyrocompass(record, LATITUDE)
    assert attitude_error(result.mat_nb, expected) == pytest.approx(np.zeros(3), abs=1e-4)


@pytest.mark.parametrize("latitude", [-88.0, -60.0, 0.0, 70.0])
@pytest.mark.parametrize("errors", [SensorErrors(), ERRORS])
def test_anywhere_short_of_the_poles(latitude: float, errors: SensorErrors) -> None:
    """At the dateline, where longitude jumps."""
    position = np.array([latitude * DEG, 180 * DEG, 100.0])
    result = align(make_still_record(300.0, 0.1, latitude * DEG), position, errors)
    error = attitude_error(result.mat_nb, MAT_NB)
    assert np.all(np.abs(error) < [1e-6, 1e-6, 1e-4])


def test_history_ends_in_the_result() -> None:
    result = align(make_still_record(60.0, 0.1), POSITION, ERRORS)
    assert result.history.time[-1] == pytest.approx(result.time) == pytest.approx(60.0)
    assert np.array_equal(result.history.mat_nb[-1], result.mat_nb)
    assert np.array_equal(result.history.covariance[-1], result.covariance)


def scaled(rotation: float, velocity: float) -> Callable[[Increments], Increments]:
    return lambda r: Increments(r.interval, r.rotation * rotation, r.velocity * velocity)


def with_hole(record: Increments) -> Increments:
    velocity = record.velocity.copy()
    velocity[17, 1] = np.nan
    return Increments(record.interval, record.rotation, velocity)


@pytest.mark.parametrize(
    ("spoil", "message"),
    [
        (lambda r: r.between(0, 200), r"record of 20 s: expected at least 30 s"),
        (with_hole, r"increment 17: .*nan.*expected finite"),
        (scaled(1.0, 1 / 9.80), r"force 1 m/s\^2: expected gravity, 9.80.*is the velocity in g s"),
        (scaled(1 / DEG, 1.0), r"velocity changes by .* expected at most 1 m/s .* rotation in rad"),
    ],
)
def test_refused_with_what_was_expected(
    spoil: Callable[[Increments], Increments], message: str
) -> None:
    with pytest.raises(HrgError, match=message):
        align(spoil(make_still_record(300.0, 0.1)), POSITION, ERRORS)


@pytest.mark.parametrize("latitude", [90 * DEG, -89.5 * DEG, np.nan])
def test_a_pole_is_refused(latitude: float) -> None:
    with pytest.raises(HrgError, match="at a pole there is no north"):
        align(make_still_record(60.0, 0.1), np.array([latitude, 0.0, 0.0]), ERRORS)


def test_a_car_that_drives_off_is_refused() -> None:
    drive = load_trajectory("car", 310.0, 10.0)
    with pytest.raises(HrgError, match=r"velocity changes by \d.* standing vehicle"):
        align(drive.increments(0.0, 0.1, 3000), drive.position(np.array(0.0)), ERRORS)
