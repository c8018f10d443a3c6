"""Tilting of a vehicle is estimated from its gyros' record."""

from dataclasses import replace

import numpy as np
import pytest

from ins_eval.alignment.kalman.fine import BOUNDS, estimate_tilting
from ins_eval.common.sensor_errors import SensorErrors

STEP, COUNT = 1.0, 300
GYROS = SensorErrors(angle_random_walk=6e-7, gyro_bias_instability=1.5e-8)


def turned(white: float, walk: float, rng: np.random.Generator) -> np.ndarray:
    """Rotation of a tilting vehicle, plus a steady rate."""
    wandered = np.cumsum(rng.normal(0, walk * np.sqrt(STEP), (COUNT, 2)), axis=0)
    steady = 1e-7 * STEP * np.arange(1.0, COUNT + 1)[:, None]
    return np.asarray(wandered + rng.normal(0, white, (COUNT, 2)) + steady)


def test_motion_is_found_beside_the_gyros_noise() -> None:
    """Within 30 %; seed 1."""
    rng = np.random.default_rng(1)
    white, walk = 1e-5, 3e-6
    record = turned(white, np.hypot(walk, GYROS.angle_random_walk), rng)
    estimate = estimate_tilting(record, STEP, GYROS)
    assert estimate.angle_white_noise == pytest.approx(white, rel=0.3)
    assert estimate.angle_random_walk == pytest.approx(walk, rel=0.3)


def test_the_gyros_own_noise_is_no_motion() -> None:
    """50 vehicles at rest; seed 2."""
    rng = np.random.default_rng(2)
    walks = [
        estimate_tilting(turned(0.0, GYROS.angle_random_walk, rng), STEP, GYROS).angle_random_walk
        for _ in range(50)
    ]
    assert np.sqrt(np.mean(np.square(walks))) < 0.3 * GYROS.angle_random_walk


def test_noise_that_is_not_stated_counts_as_motion() -> None:
    rng = np.random.default_rng(3)
    unstated = replace(GYROS, angle_random_walk=0.0)
    estimate = estimate_tilting(turned(0.0, GYROS.angle_random_walk, rng), STEP, unstated)
    assert estimate.angle_random_walk == pytest.approx(GYROS.angle_random_walk, rel=0.2)


def test_nothing_at_all_is_the_least_there_is() -> None:
    estimate = estimate_tilting(np.zeros((COUNT, 2)), STEP, SensorErrors())
    assert (estimate.angle_white_noise, estimate.angle_random_walk) == pytest.approx(
        [low for low, _ in BOUNDS], rel=0.1
    )
