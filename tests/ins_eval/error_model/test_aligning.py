"""Alignment as part of the linear model."""

from dataclasses import replace

import numpy as np
import pytest

from ins_eval.alignment.analytic import level_and_gyrocompass
from ins_eval.common import earth
from ins_eval.common.sensor_errors import SensorErrors
from ins_eval.common.state import Track, track_error
from ins_eval.error_model.dynamics import ATTITUDE, COUNT
from ins_eval.error_model.error_budget import compute_weights
from ins_eval.error_model.linear_model import (
    join_models,
    linearize,
    model_alignment,
    propagate_covariance,
)
from ins_eval.error_model.motion import sample_motion
from ins_eval.navigation.height import Clamped
from ins_eval.trajectories.catalogue import load_trajectory
from tests.ins_eval.error_model.cases import propagate, sum_coefficient_weights
from tests.ins_eval.error_model.test_closed_forms import at_rest

CLAMPED = Clamped(np.zeros(1))


@pytest.mark.parametrize("sensor", [0, 1], ids=["gyro", "accelerometer"])
@pytest.mark.parametrize("axis", [0, 1, 2])
def test_attitude_error_is_the_alignments(sensor: int, axis: int) -> None:
    """To 1e-5 of the attitude that a bias leads to, north 30 deg left of forward; the plumb line
    leans by 4e-8 rad at 50 m, so that 4e-15 rad come of a bias of 1e-7 g down."""
    car = load_trajectory("car", 20.0, 100.0)
    record = car.increments(-90.0, 0.1, 900)
    state = car.state(-0.1)
    biases = np.zeros((2, 3))
    biases[sensor, axis] = (1e-9, 1e-6)[sensor]

    def aligned(sign: float) -> np.ndarray:
        rotation, velocity = sign * biases * 0.1
        biased = replace(
            record, rotation=record.rotation + rotation, velocity=record.velocity + velocity
        )
        return level_and_gyrocompass(biased, state.latitude)

    def track(mat_nb: np.ndarray) -> Track:
        return Track(np.zeros(1), np.zeros((1, 3)), np.zeros((1, 3)), mat_nb[None])

    result = propagate(model_alignment(sample_motion(car, -90.0, 1.0, 90)), np.zeros(COUNT), biases)
    expected = track_error(track(aligned(1.0)), track(aligned(-1.0))).attitude[0] / 2
    size = np.linalg.norm(expected) + 1e-9
    assert result[-1, ATTITUDE] == pytest.approx(expected, abs=1e-5 * size)


def test_alignment_hides_the_east_gyro() -> None:
    """Heading north at rest for an hour, its bias is cancelled by the heading that it gave; the
    north gyro's is not. Once the vehicle turns, the east gyro's is seen."""
    still = at_rest(40.0, 0.0, 2.0, 150)
    standing = replace(at_rest(40.0, 0.0, 2.0, 1800), start=300.0)
    model = join_models(model_alignment(still), linearize(standing, CLAMPED))
    result = sum_coefficient_weights(compute_weights(model))[:, 0]
    drift = np.linalg.norm(result, axis=0)
    assert drift[1] < 1e-3 * drift[0]
    about = np.diag([-1.0, -1.0, 1.0])
    turned = replace(standing, mat_nb=standing.mat_nb @ about, force=standing.force @ about)
    model = join_models(model_alignment(still), linearize(turned, CLAMPED))
    seen = np.linalg.norm(sum_coefficient_weights(compute_weights(model))[:, 0], axis=0)
    assert seen[1] > 0.9 * drift[0]


def test_gyrocompassing_noise() -> None:
    """Heading: angle random walk over sqrt(T) RATE cos(latitude)."""
    noise = SensorErrors(angle_random_walk=1e-6)
    model = model_alignment(at_rest(40.0, 0.0, 1.0, 300), (), noise)
    result = propagate_covariance(model, np.zeros((COUNT, COUNT)), np.zeros((0, 3)))[-1]
    expected = 1e-6 / np.sqrt(300) / earth.RATE / np.cos(np.deg2rad(40))
    assert np.sqrt(result[8, 8]) == pytest.approx(expected, rel=1e-6)
