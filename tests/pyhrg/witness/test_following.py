"""A gyro that is followed by `HRGSlow` beside one that is replayed by `HRG`."""

from dataclasses import replace

import numpy as np
import pytest

from pyhrg.fmu import GyroFmu
from pyhrg.witness.following import FOLLOWED_ANGLE, FollowedGyro, begin, follow
from pyhrg.witness.mechanisms import change_device
from pyhrg.witness.replay import Replay, Witnesses, read_witnesses, replay
from tests.pyhrg.witness.flights import GYRO, PRIOR, draw_changes, fly

DURATION, AVERAGED = 180.0, 50
DEVICE = change_device(GYRO, draw_changes(PRIOR, np.random.default_rng(0)))


@pytest.fixture(scope="module")
def witnesses(fmu: GyroFmu) -> Witnesses:
    return read_witnesses(fly(fmu, DEVICE, DURATION, 0, self_test=True), GYRO)


@pytest.fixture(scope="module")
def followed(
    fmu: GyroFmu, slow_fmu: GyroFmu, witnesses: Witnesses
) -> tuple[FollowedGyro, Replay, Replay]:
    """A gyro, its replay by `HRGSlow` with the target corrected twice, and by `HRG` on the same
    course."""
    gyro = begin(GYRO, witnesses)
    for _ in range(2):
        slowly = follow((fmu, slow_fmu), {0: DEVICE}, [gyro])[0]
    (fast,) = replay(fmu, [DEVICE], [witnesses], [gyro.course])
    return gyro, slowly, fast


def test_hrg_goes_through_the_recorded_angles(
    followed: tuple[FollowedGyro, Replay, Replay],
) -> None:
    gyro, slowly, fast = followed
    assert gyro.is_corrected
    assert slowly.angle_error < FOLLOWED_ANGLE
    assert fast.angle_error < FOLLOWED_ANGLE


def test_residuals_are_those_of_hrg(
    slow_fmu: GyroFmu, followed: tuple[FollowedGyro, Replay, Replay]
) -> None:
    """Means of 5 s differ by less than a thousandth of the forces' noise; those of `HRGSlow` by
    itself by more than a tenth."""
    gyro, slowly, fast = followed

    def compare(other: Replay) -> float:
        rows = (fast.residuals - other.residuals)[: -(len(fast.residuals) % AVERAGED) or None]
        means = rows.reshape(-1, AVERAGED, 2).mean(axis=1)[4:, 0]
        return float(np.sqrt(np.mean(means**2)))

    noise = 2 * GYRO.bryan_factor * GYRO.angle_random_walk / np.sqrt(5.0)
    (alone,) = replay(slow_fmu, [DEVICE], [gyro.witnesses], [gyro.course])
    assert compare(slowly) < 1e-3 * noise
    assert compare(alone) > 0.1 * noise


def test_one_force_may_be_missing(fmu: GyroFmu, slow_fmu: GyroFmu, witnesses: Witnesses) -> None:
    forces = witnesses.forces * [1.0, np.nan]
    gyro = begin(GYRO, replace(witnesses, forces=forces))
    found = follow((fmu, slow_fmu), {0: DEVICE}, [gyro])[0]
    assert np.isfinite(found.residuals[:, 0]).all()
    assert np.isnan(found.residuals[:, 1]).all()
