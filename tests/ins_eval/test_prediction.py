"""The prediction against flights of known biases, and against closed form."""

import numpy as np
import pytest

from ins_eval.increments import Increments
from ins_eval.mission import Mission
from ins_eval.prediction import bias_sensitivity, predicted_radial_error
from pyhrg.units import DEG_PER_H
from tests.ins_eval.cases import short_mission


@pytest.fixture(scope="module")
def flight() -> Mission:
    return short_mission(0.5)


def test_prediction_is_the_median_of_flights_with_constant_biases(flight: Mission) -> None:
    """60 draws (seed 2) of three constant gyro biases, flown one by one: median within 30 %
    (about three standard errors)."""
    sigma = 0.05 * DEG_PER_H
    promised = predicted_radial_error(bias_sensitivity(flight), sigma, 0.0)[-1]
    generator = np.random.default_rng(2)
    radial = []
    for _ in range(60):
        bias = generator.normal(0.0, sigma, size=3)
        truth = flight.truth
        biased = Increments(truth.interval, truth.rotation + bias * truth.interval, truth.velocity)
        radial.append(np.hypot(*flight.fly(biased)[-1]))
    assert np.median(radial) == pytest.approx(promised, rel=0.3)


def test_prediction_is_proportional_to_the_bias(flight: Mission) -> None:
    sensitivity = bias_sensitivity(flight)
    one = predicted_radial_error(sensitivity, 1e-8, 0.0)
    assert predicted_radial_error(sensitivity, 3e-8, 0.0) == pytest.approx(3 * one)
    assert np.all(predicted_radial_error(sensitivity, 0.0, 0.0) == 0)
    assert np.all(predicted_radial_error(sensitivity, 0.0, 1e-4) > 0)
