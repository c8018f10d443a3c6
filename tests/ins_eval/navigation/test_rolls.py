"""Rolls of 360 deg in a second and a half, at any rate of increments."""

import numpy as np
import pytest

from ins_eval.common.state import track_error
from ins_eval.navigation.coefficients import SAMPLES_PER_STEP
from ins_eval.navigation.height import Clamped
from ins_eval.navigation.strapdown import navigate
from ins_eval.trajectories.trajectory import Trajectory
from pyhrg.records.imu.log import Increments

SECONDS = 60
FINE = 2000
"""Rate at which the increments are made, Hz; slower ones are their sums."""


@pytest.fixture(scope="module")
def rolls() -> tuple[Trajectory, Increments]:
    """Five rolls, 360 deg/s and more at their height, at 250 m/s heading north-east."""
    time = np.arange(-2.0, SECONDS + 2.0, 0.02)
    s = np.clip(np.mod(time, 12.0) / 1.5, 0.0, 1.0)
    roll = 2 * np.pi * (np.floor(time / 12.0) + s**4 * (35 - 84 * s + 70 * s**2 - 20 * s**3))
    zero = np.zeros_like(time)
    latitude = np.deg2rad(45.0) + 2.8e-5 * time
    channels = [latitude, 3.9e-5 * time, zero + 5000.0, roll, zero + 0.02, zero + 0.78]
    trajectory = Trajectory("rolls", time, np.stack(channels, axis=-1))
    return trajectory, trajectory.increments(0.0, 1 / FINE, SECONDS * FINE)


def sum_increments(fine: Increments, rate: int) -> Increments:
    each = FINE // rate
    shape = (len(fine) // each, each, 3)
    rotation, velocity = (x.reshape(shape).sum(axis=1) for x in (fine.rotation, fine.velocity))
    return Increments(1 / rate, rotation, velocity)


def largest_errors(
    rolls: tuple[Trajectory, Increments], rate: int, samples: int
) -> tuple[float, float]:
    """Largest horizontal error, m, and attitude error, rad."""
    trajectory, fine = rolls
    record = sum_increments(fine, rate)
    clamp = Clamped(trajectory.position(record.bounds)[:, 2])
    track = navigate(trajectory.state(0.0), record, clamp, 12 * rate, samples)
    error = track_error(track, trajectory.track(track.time))
    return (
        float(np.max(np.linalg.norm(error.position[:, :2], axis=1))),
        float(np.max(np.abs(error.attitude))),
    )


def test_two_samples_at_100_hz_stay_within_the_weaving_aircrafts_budget(
    rolls: tuple[Trajectory, Increments],
) -> None:
    """3 mm; after five rolls."""
    assert largest_errors(rolls, 100, 2)[0] < 3e-3


@pytest.mark.parametrize("samples", SAMPLES_PER_STEP)
def test_error_falls_with_the_third_power_of_the_step_or_better(
    rolls: tuple[Trajectory, Increments], samples: int
) -> None:
    slow, fast = (largest_errors(rolls, rate, samples)[0] for rate in (100, 500))
    assert np.log(slow / fast) / np.log(5) > 3.0


@pytest.mark.parametrize("samples", SAMPLES_PER_STEP)
def test_attitude_stands_a_quarter_turn_and_more_a_step(
    rolls: tuple[Trajectory, Increments], samples: int
) -> None:
    """At 10 Hz; in position, where gravity swings round within the step, that is too slow."""
    record = sum_increments(rolls[1], 10)
    steps = record.rotation[:, 0].reshape(-1, samples).sum(axis=1)
    assert np.max(steps) > np.pi / 2
    assert largest_errors(rolls, 10, samples)[1] < 1e-4
