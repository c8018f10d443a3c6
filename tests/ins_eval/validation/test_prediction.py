"""The prediction against flights of known biases, and against closed form."""

import numpy as np
import pytest

from ins_eval.increments import Increments
from ins_eval.validation.mission import Mission
from ins_eval.validation.prediction import bias_sensitivity, predicted_radial_error
from pyhrg.units import DEG_PER_H
from tests.ins_eval.cases import short_mission


@pytest.fixture(scope="module")
def flight() -> Mission:
    return short_mission(0.5)


def test_prediction_is_the_median_over_devices(flight: Mission) -> None:
    """Against 20 000 draws (seed 2) of constant gyro biases through the same sensitivities."""
    sigma = 0.05 * DEG_PER_H
    sensitivity = bias_sensitivity(flight)
    promised = predicted_radial_error(sensitivity, sigma, 0.0)[-1]
    biases = np.random.default_rng(2).normal(0.0, sigma, size=(20_000, 3))
    errors = biases @ sensitivity[0][:, -1, :]
    assert np.median(np.hypot(*errors.T)) == pytest.approx(promised, rel=0.03)


def test_sensitivity_is_what_the_navigator_does(flight: Mission) -> None:
    """Three gyro and accelerometer biases at once, flown: the sum of their sensitivities."""
    gyro = np.array([0.03, -0.05, 0.04]) * DEG_PER_H
    force = np.array([1e-4, 2e-4, -1e-4])
    truth = flight.truth
    biased = Increments(
        truth.interval,
        truth.rotation + gyro * truth.interval,
        truth.velocity + force * truth.interval,
    )
    gyros, forces = bias_sensitivity(flight)
    expected = np.tensordot(gyro, gyros, 1) + np.tensordot(force, forces, 1)
    error = flight.fly(biased) - flight.fly(truth)
    assert np.max(np.abs(error - expected)) < 0.01 * np.max(np.abs(expected))


def test_prediction_is_proportional_to_the_bias(flight: Mission) -> None:
    sensitivity = bias_sensitivity(flight)
    one = predicted_radial_error(sensitivity, 1e-8, 0.0)
    assert predicted_radial_error(sensitivity, 3e-8, 0.0) == pytest.approx(3 * one)
    assert np.all(predicted_radial_error(sensitivity, 0.0, 0.0) == 0)
    assert np.all(predicted_radial_error(sensitivity, 0.0, 1e-4) > 0)
