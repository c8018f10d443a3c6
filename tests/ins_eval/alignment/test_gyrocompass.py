"""Each method's covariance and scatter against the closed forms of gyrocompassing."""

from collections.abc import Callable
from dataclasses import replace

import numpy as np
import pytest

from ins_eval.alignment.analytic import bias_sensitivity, level_and_gyrocompass
from ins_eval.alignment.kalman.fine import align_by_kalman_filter
from ins_eval.alignment.result import Alignment
from ins_eval.common import earth
from ins_eval.common.sensor_errors import SensorErrors
from pyhrg.common.units import DEG_PER_H, DEG_PER_SQRT_H, MICRO_G
from pyhrg.records.imu.log import Increments
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


def heading_sigma(rate_variance: float, latitude: float) -> float:
    """Return the heading's standard deviation, rad, for a variance of the east rate, (rad/s)^2."""
    return float(np.sqrt(rate_variance) / (earth.RATE * np.cos(latitude)))


def averaged_rate_variance(angle_random_walk: float, duration: float) -> float:
    """Return the variance of a gyro's mean rate, (rad/s)^2, over a duration, s (Eq. 2).

    No method does better, even if the vehicle does not move at all.
    """
    return angle_random_walk**2 / duration


def optimal_rate_variance(angle_random_walk: float, tilt_noise: float, duration: float) -> float:
    """Return the variance of the best linear estimate of the slope of the tilt, (rad/s)^2 (Eq. 3).

    It is N^2/(T - 2/k tanh(k T/2)) with k = N/r, the inverse of the smallest cost of a unit slope:
    the integral of (t - x)^2/r^2 + x'^2/N^2 over all x(t), so that x'' = k^2 (x - t) and x' = 0 at
    both ends. Without tilt noise it is Eq. 2, without random walk 12 r^2/T^3.
    """
    k = angle_random_walk / tilt_noise
    lost = 2 / k * np.tanh(k * duration / 2)
    return float(angle_random_walk**2 / (duration - lost))


RATE_VARIANCES = {
    "free": optimal_rate_variance(WALKS.angle_random_walk, TILT_NOISE, DURATION),
    "fine": averaged_rate_variance(WALKS.angle_random_walk, DURATION),
}


def fine(record: Increments, errors: SensorErrors, steady: bool) -> Alignment:
    return align_by_kalman_filter(record, POSITION, errors, MAT_NB, QUIET, steady)


METHODS: dict[str, Callable[[Increments, SensorErrors], Alignment]] = {
    "free": lambda record, errors: fine(record, errors, steady=False),
    "fine": lambda record, errors: fine(record, errors, steady=True),
}
COUNT = 60
"""Number of records. "free" is fine alignment without the assumption of a steady tilt."""


@pytest.mark.parametrize("method", METHODS)
def test_covariance_of_the_random_walk_is_the_closed_form(method: str) -> None:
    """To 4 %: the covariance also holds the tilt, and the coupling of level axes by Earth."""
    result = METHODS[method](make_still_record(DURATION, INTERVAL), WALKS)
    predicted = heading_sigma(RATE_VARIANCES[method], LATITUDE)
    assert np.sqrt(result.covariance[2, 2]) == pytest.approx(predicted, rel=0.04)


@pytest.mark.parametrize("method", METHODS)
def test_heading_scatters_as_the_closed_form(method: str) -> None:
    """Random walks alone; 99 % interval of chi-square; seed 1."""
    rng, count = np.random.default_rng(1), COUNT
    ideal = make_still_record(DURATION, INTERVAL)
    headings = [
        attitude_error(METHODS[method](add_sensor_errors(ideal, WALKS, rng), WALKS).mat_nb, MAT_NB)[
            2
        ]
        for _ in range(count)
    ]
    sigma = heading_sigma(RATE_VARIANCES[method], LATITUDE)
    low, high = chi_square_interval(count, 1)
    assert low < np.mean(np.square(headings)) / sigma**2 < high


@pytest.mark.parametrize("method", METHODS)
def test_covariance_is_consistent(method: str) -> None:
    """Normalised square of the attitude error, 3 a record; 99 % interval; seed 2."""
    low, high = chi_square_interval(COUNT, 3)
    assert low < mean_normalised_square(method, stated=ALL, seed=2) < high


@pytest.mark.parametrize("method", METHODS)
def test_an_understated_bias_shows_in_the_covariance(method: str) -> None:
    """The control: a quarter of the gyros' bias stated."""
    understated = replace(ALL, gyro_bias=ALL.gyro_bias / 4)
    _, high = chi_square_interval(COUNT, 3)
    assert mean_normalised_square(method, stated=understated, seed=2) > high


def mean_normalised_square(method: str, stated: SensorErrors, seed: int) -> float:
    rng, ideal = np.random.default_rng(seed), make_still_record(DURATION, INTERVAL)
    records = [add_sensor_errors(ideal, ALL, rng) for _ in range(COUNT)]
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
    predicted = bias_sensitivity(LATITUDE, GRAVITY) @ biases
    attitude = attitude_error(level_and_gyrocompass(record, LATITUDE), MAT_NB)
    assert attitude == pytest.approx(predicted, abs=2e-6)


def test_the_optimal_variance_lies_between_its_limits() -> None:
    """Angle random walk alone, and tilt noise alone (Eq. 3)."""
    walk, noise = 1e-7, 1e-5
    long, short = optimal_rate_variance(walk, noise, 1e5), optimal_rate_variance(walk, noise, 1.0)
    assert long == pytest.approx(averaged_rate_variance(walk, 1e5), rel=0.01)
    assert short == pytest.approx(12 * noise**2, rel=0.01)
