"""Errors of sensors split into effects."""

from dataclasses import replace

import numpy as np
import pytest

from ins_eval.common.sensor_errors import SensorErrors
from ins_eval.error_model.decomposition import (
    UNEXPLAINED,
    decompose_errors,
    sensor_error,
    sum_over_steps,
)
from ins_eval.error_model.effects import (
    BIASES,
    accelerometer_scale_factor,
    bias_map,
    gyro_scale_factor,
)
from ins_eval.error_model.motion import sample_motion
from ins_eval.trajectories.catalogue import load_trajectory
from pyhrg.records.imu.log import Increments

INTERVAL = 0.1
COUNT = 18_000
FIRST_ANGLE = np.array([0.2, 0.5, 0.9])
EFFECTS = (*BIASES, gyro_scale_factor(), accelerometer_scale_factor(), *bias_map(4, FIRST_ANGLE))


@pytest.fixture(scope="module")
def truth() -> Increments:
    return load_trajectory("car", 1810.0, 20.0).increments(0.0, INTERVAL, COUNT)


def test_each_effect_is_found_again(truth: Increments) -> None:
    """To 1 % of each, under white noise of a hundredth of the map, on the yaw gyro; the others'
    patterns move by a degree, where bias and map look alike."""
    generator = np.random.default_rng(2)
    angle = FIRST_ANGLE - 0.277 * (np.cumsum(truth.rotation, axis=0) - truth.rotation / 2)
    bias_map_4 = 5e-7 * np.cos(4 * angle + 0.3) * INTERVAL
    scale = 1e-5 * truth.rotation
    noise = 5e-9 * INTERVAL * generator.standard_normal(truth.rotation.shape)
    error = replace(
        truth,
        rotation=2e-7 * INTERVAL + scale + bias_map_4 + noise,
        velocity=np.full_like(truth.velocity, 1e-4 * INTERVAL),
    )
    motion = sample_motion(load_trajectory("car", 1810.0, 20.0), 0.0, 1.0, 1800)
    wide, walk = np.ones((len(EFFECTS), 3)), SensorErrors(angle_random_walk=5e-9 * 0.3)
    parts = decompose_errors(error, motion, EFFECTS, wide, walk)
    assert parts["gyro bias"].rotation[:, 2] == pytest.approx(2e-7, rel=1e-2)
    expected = bias_map_4.reshape(1800, 10, 3).sum(axis=1)
    result = parts["bias map, harmonic 4"].rotation
    assert result[:, 2] == pytest.approx(expected[:, 2], abs=5e-9)
    turning = scale[:, 2].reshape(1800, 10).sum(axis=1)
    assert parts["gyro scale factor"].rotation[:, 2] == pytest.approx(turning, rel=1e-2, abs=1e-9)
    whole = sum_over_steps(error, 0.0, 1.0, 1800)
    assert sum(part.rotation for part in parts.values()) == pytest.approx(whole.rotation, abs=1e-18)
    assert sum(part.velocity for part in parts.values()) == pytest.approx(whole.velocity, abs=1e-15)
    assert np.std(parts[UNEXPLAINED].rotation) < 2 * np.std(noise) * np.sqrt(10)


def test_sums(truth: Increments) -> None:
    result = sum_over_steps(truth, 30.0, 0.5, 4)
    assert result.start == 30.0
    assert result.rotation[1] == pytest.approx(truth.rotation[305:310].sum(axis=0))
    with pytest.raises(ValueError, match=r"steps of 0\.25 s.*whole intervals of 0\.1 s"):
        sum_over_steps(truth, 0.0, 0.25, 4)
    with pytest.raises(ValueError, match=r"span 0\.0 to 1800\.0 s: expected 1799\.0 to 1801\.0"):
        sum_over_steps(truth, 1799.0, 1.0, 2)


def test_difference_needs_the_same_times(truth: Increments) -> None:
    twice = replace(truth, rotation=2 * truth.rotation)
    assert np.array_equal(sensor_error(twice, truth).rotation, truth.rotation)
    with pytest.raises(ValueError, match=r"from 5\.0 s; true: 18000 x 0\.1 s from 0\.0 s"):
        sensor_error(replace(truth, start=5.0), truth)
    with pytest.raises(ValueError, match="measured: 10 x"):
        sensor_error(truth.between(0, 10), truth)


def test_prior_keeps_like_signals_from_cancelling(truth: Increments) -> None:
    """On a level gyro whose pattern moves by a degree. A prior that states almost nothing is the
    control."""
    noise = SensorErrors(angle_random_walk=1e-6)
    white = noise.angle_random_walk * np.sqrt(INTERVAL)
    generator = np.random.default_rng(3)
    drift = 2e-7 * INTERVAL + white * generator.standard_normal(truth.rotation.shape)
    error = replace(truth, rotation=drift, velocity=np.zeros_like(truth.velocity))
    motion = sample_motion(load_trajectory("car", 1810.0, 20.0), 0.0, 1.0, 1800)
    narrow, wide = (np.full((len(EFFECTS), 3), size) for size in (1e-7, 1.0))

    def largest(parts: dict[str, Increments]) -> float:
        sums = [np.abs(part.rotation[:, 0].sum()) for n, part in parts.items() if n != UNEXPLAINED]
        return float(max(sums) / np.abs(drift[:, 0].sum()))

    likeliest = decompose_errors(error, motion, EFFECTS, narrow, noise)
    assert largest(likeliest) < 2
    assert largest(decompose_errors(error, motion, EFFECTS, wide, noise)) > 20
    whole = sum_over_steps(error, 0.0, 1.0, 1800).rotation
    assert sum(part.rotation for part in likeliest.values()) == pytest.approx(whole, abs=1e-18)


def test_prior_of_nothing_leaves_all_to_the_rest(truth: Increments) -> None:
    motion = sample_motion(load_trajectory("car", 1810.0, 20.0), 0.0, 1.0, 1800)
    parts = decompose_errors(truth, motion, EFFECTS, np.zeros((len(EFFECTS), 3)), SensorErrors())
    assert parts["gyro bias"].rotation == pytest.approx(0)
    assert np.array_equal(
        parts[UNEXPLAINED].rotation, sum_over_steps(truth, 0.0, 1.0, 1800).rotation
    )
