"""Each method's covariance and scatter against the closed forms of gyrocompassing."""

from collections.abc import Callable
from dataclasses import replace

import numpy as np
import pytest

from ins_eval.alignment import gyrocompass
from ins_eval.alignment.analytic import align_by_means, level_and_gyrocompass
from ins_eval.alignment.inertial.inertial_frame import align_in_inertial_frame
from ins_eval.alignment.kalman.fine import align_by_kalman_filter
from ins_eval.alignment.result import Alignment
from ins_eval.common import earth
from ins_eval.common.sensor_errors import SensorErrors
from pyhrg.common.units import DEG_PER_H, DEG_PER_SQRT_H, MICRO_G
from pyhrg.records.imu.increments import Increments
from tests.ins_eval.alignment.cases import (
    GRAVITY,
    LATITUDE,
    MAT_NB,
    POSITION,
    add_sensor_errors,
    attitude_error,
    chi_square_interval,
    make_still_record,
    normalised_square,
)

DURATION, INTERVAL = 300.0, 0.5
WALKS = SensorErrors(angle_random_walk=0.002 * DEG_PER_SQRT_H, velocity_random_walk=1e-4)
ALL = replace(WALKS, gyro_bias=0.01 * DEG_PER_H, accelerometer_bias=50 * MICRO_G)
QUIET = 1e-6
"""Sway, m; of a vehicle that stands still."""

TILT_NOISE = WALKS.velocity_random_walk / GRAVITY
RATE_VARIANCES = {
    "analytic": gyrocompass.averaged_rate_variance(WALKS.angle_random_walk, DURATION),
    "inertial": gyrocompass.fitted_rate_variance(WALKS.angle_random_walk, TILT_NOISE, DURATION),
    "free": gyrocompass.optimal_rate_variance(WALKS.angle_random_walk, TILT_NOISE, DURATION),
    "fine": gyrocompass.averaged_rate_variance(WALKS.angle_random_walk, DURATION),
}


def inertial(record: Increments, errors: SensorErrors) -> Alignment:
    return align_in_inertial_frame(record, POSITION, errors, sway=0.0)


def fine(record: Increments, errors: SensorErrors, steady: bool) -> Alignment:
    return align_by_kalman_filter(record, POSITION, errors, MAT_NB, QUIET, steady)


METHODS: dict[str, Callable[[Increments, SensorErrors], Alignment]] = {
    "analytic": lambda record, errors: align_by_means(record, POSITION, errors),
    "inertial": inertial,
    "free": lambda record, errors: fine(record, errors, steady=False),
    "fine": lambda record, errors: fine(record, errors, steady=True),
}
COUNTS = {"analytic": 400, "inertial": 400, "free": 60, "fine": 60}
"""Numbers of records. "free" is fine alignment without the assumption of a steady tilt."""


@pytest.mark.parametrize("method", METHODS)
def test_covariance_of_the_random_walk_is_the_closed_form(method: str) -> None:
    """To 4 %: the covariance also holds the tilt, and the coupling of level axes by Earth."""
    result = METHODS[method](make_still_record(DURATION, INTERVAL), WALKS)
    predicted = gyrocompass.heading_sigma(RATE_VARIANCES[method], LATITUDE)
    assert np.sqrt(result.covariance[2, 2]) == pytest.approx(predicted, rel=0.04)


@pytest.mark.parametrize("method", METHODS)
def test_heading_scatters_as_the_closed_form(method: str) -> None:
    """Random walks alone; 99 % interval of chi-square; seed 1."""
    rng, count = np.random.default_rng(1), COUNTS[method]
    ideal = make_still_record(DURATION, INTERVAL)
    headings = [
        attitude_error(METHODS[method](add_sensor_errors(ideal, WALKS, rng), WALKS).mat_nb, MAT_NB)[
            2
        ]
        for _ in range(count)
    ]
    sigma = gyrocompass.heading_sigma(RATE_VARIANCES[method], LATITUDE)
    low, high = chi_square_interval(count, 1)
    assert low < np.mean(np.square(headings)) / sigma**2 < high


@pytest.mark.parametrize("method", METHODS)
def test_covariance_is_consistent(method: str) -> None:
    """Normalised square of the attitude error, 3 a record; 99 % interval; seed 2."""
    low, high = chi_square_interval(COUNTS[method], 3)
    assert low < mean_normalised_square(method, stated=ALL, seed=2) < high


@pytest.mark.parametrize("method", METHODS)
def test_an_understated_bias_shows_in_the_covariance(method: str) -> None:
    """The control: a quarter of the gyros' bias stated."""
    understated = replace(ALL, gyro_bias=ALL.gyro_bias / 4)
    _, high = chi_square_interval(COUNTS[method], 3)
    assert mean_normalised_square(method, stated=understated, seed=2) > high


def mean_normalised_square(method: str, stated: SensorErrors, seed: int) -> float:
    rng, ideal = np.random.default_rng(seed), make_still_record(DURATION, INTERVAL)
    records = [add_sensor_errors(ideal, ALL, rng) for _ in range(COUNTS[method])]
    return float(np.mean([normalised_square(METHODS[method](r, stated), MAT_NB) for r in records]))


@pytest.mark.parametrize("method", METHODS)
def test_no_method_knows_heading_better_than_the_east_gyro(method: str) -> None:
    bias = 0.01 * DEG_PER_H
    quiet = SensorErrors(gyro_bias=bias, velocity_random_walk=1e-7)
    result = METHODS[method](make_still_record(DURATION, INTERVAL), quiet)
    hidden = bias / (earth.RATE * np.cos(LATITUDE))
    assert np.sqrt(result.covariance[2, 2]) == pytest.approx(hidden, rel=0.01)
    assert np.sqrt(result.covariance[2, 2]) >= hidden * (1 - 1e-6)


@pytest.mark.parametrize("axis", range(6))
def test_biases_turn_the_attitude_as_the_closed_form(axis: int) -> None:
    biases = np.zeros(6)
    biases[axis] = 0.01 * DEG_PER_H if axis < 3 else 50 * MICRO_G
    ideal = make_still_record(10.0, 0.5)
    record = Increments(
        0.5,
        ideal.rotation + MAT_NB.T @ biases[:3] * 0.5,
        ideal.velocity + MAT_NB.T @ biases[3:] * 0.5,
    )
    predicted = gyrocompass.bias_sensitivity(LATITUDE, GRAVITY) @ biases
    attitude = attitude_error(level_and_gyrocompass(record, LATITUDE), MAT_NB)
    assert attitude == pytest.approx(predicted, abs=2e-6)


def test_the_optimal_variance_lies_between_its_limits() -> None:
    walk, noise = 1e-7, 1e-5
    long, short = 1e5, 1.0
    optimal = gyrocompass.optimal_rate_variance
    averaged, fitted = gyrocompass.averaged_rate_variance, gyrocompass.fitted_rate_variance
    assert optimal(walk, noise, long) == pytest.approx(averaged(walk, long), rel=0.01)
    assert optimal(walk, noise, short) == pytest.approx(fitted(walk, noise, short), rel=0.01)
    assert averaged(walk, 300.0) < optimal(walk, noise, 300.0) < fitted(walk, noise, 300.0)
