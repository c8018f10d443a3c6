"""Weights from one backward pass against many forward ones."""

import numpy as np
import pytest

from ins_eval.error_model.dynamics import COUNT
from ins_eval.error_model.effects import BIASES, bias_map, gyro_scale_factor
from ins_eval.error_model.error_budget import Weights, compute_weights
from ins_eval.error_model.linear_model import LinearModel, linearize
from ins_eval.error_model.motion import sample_motion
from ins_eval.navigation.height import BaroDamped
from tests.ins_eval.error_model.cases import Flight, propagate, sum_coefficient_weights, weave

EFFECTS = (*BIASES, gyro_scale_factor(), *bias_map(4, np.array([0.1, 0.7, 1.3])))


@pytest.fixture(scope="module")
def model() -> LinearModel:
    motion = sample_motion(weave(45, 1200), 0.0, 1.0, 1200)
    return linearize(motion, BaroDamped(np.zeros(1)), EFFECTS)


@pytest.fixture(scope="module")
def weights(model: LinearModel) -> Weights:
    return compute_weights(model)


def test_initial_errors(model: LinearModel, weights: Weights) -> None:
    for state in range(COUNT):
        forward = propagate(model, np.eye(COUNT)[state], np.zeros((5, 3)))[-1, :2]
        assert weights.states[0][:, state] == pytest.approx(forward, rel=1e-11, abs=1e-9)


def test_coefficients(model: LinearModel, weights: Weights) -> None:
    for place in np.ndindex(5, 3):
        unit = np.zeros((5, 3))
        unit[place] = 1.0
        forward = propagate(model, np.zeros(COUNT), unit)[-1, :2]
        size = np.linalg.norm(forward)
        assert sum_coefficient_weights(weights)[:, *place] == pytest.approx(
            forward, abs=1e-11 * size
        )


def test_an_error_at_any_moment_is_the_navigators() -> None:
    """A gyro errs by 1e-5 rad in one second, at three moments: the navigator ends where the
    weights say, to 1e-4 of the triad's."""
    flight = Flight.of(weave(45, 1200), 1200)
    height = BaroDamped(flight.heights)
    own = compute_weights(linearize(sample_motion(flight.trajectory, 0.0, 1.0, 1200), height))
    for second in (0, 333, 1000):
        for sensor, size in enumerate((1e-5,) * 3 + (1e-1,) * 3):
            errors = np.zeros((60_000, 6))
            errors[50 * second : 50 * second + 50, sensor] = size
            ends = [flight.flown(height, np.zeros(9), sign * errors)[-1, :2] for sign in (1, -1)]
            expected = size * own.sensors[second, :, sensor]
            difference = np.linalg.norm((ends[0] - ends[1]) / 2 - expected)
            triad = slice(0, 3) if sensor < 3 else slice(3, 6)
            assert difference < 1e-4 * size * np.linalg.norm(own.sensors[second, :, triad])
