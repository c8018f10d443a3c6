"""Gyrocompassing against theory."""

import numpy as np
import pytest

from ins_eval.alignment.analytic import level_and_gyrocompass
from ins_eval.common import earth
from ins_eval.common.rotation import body_rate_from_euler, euler_from_mat, mat_from_euler
from pyhrg.common.errors import HrgError
from pyhrg.common.units import DEG, DEG_PER_H
from pyhrg.records.imu.log import Increments
from tests.ins_eval.cases import at_rest

LATITUDE = 40 * DEG


@pytest.mark.parametrize("yaw", [0.0, 0.7, 3.0, -2.0])
def test_perfect_sensors_give_the_attitude(yaw: float) -> None:
    attitude = level_and_gyrocompass(at_rest(LATITUDE, 0.0, 10, np.zeros(3), yaw), LATITUDE)
    roll, pitch, heading = euler_from_mat(attitude)
    assert (roll, pitch) == pytest.approx((0.0, 0.0), abs=1e-12)
    assert heading == pytest.approx(yaw, abs=1e-12)


def test_tilted_vehicle() -> None:
    angles = (0.02, -0.05, 1.0)
    attitude = mat_from_euler(*map(np.array, angles))
    level = at_rest(LATITUDE, 0.0, 10, np.zeros(3))
    tilted = Increments(0.01, level.rotation @ attitude, level.velocity @ attitude)
    assert euler_from_mat(level_and_gyrocompass(tilted, LATITUDE)) == pytest.approx(
        angles, abs=1e-12
    )


def test_east_gyro_bias_turns_the_heading() -> None:
    """Heading errs by -e/(RATE cos latitude): at 40 deg, 0.1 deg/h gives half a degree."""
    bias = 0.1 * DEG_PER_H
    record = at_rest(LATITUDE, 0.0, 10, np.array([0.0, bias, 0.0]))
    heading = euler_from_mat(level_and_gyrocompass(record, LATITUDE))[2]
    assert heading == pytest.approx(-bias / (earth.RATE * np.cos(LATITUDE)), rel=1e-3)


def test_moving_vehicle_is_refused() -> None:
    record = at_rest(LATITUDE, 0.0, 10, np.array([0.0, 0.0, 0.01]))
    with pytest.raises(HrgError, match=r"mean rate .* expected about Earth's"):
        level_and_gyrocompass(record, LATITUDE)


def test_euler_rates_are_the_derivative_of_the_attitude() -> None:
    """`omega_nb_b` against finite differences of the rotation matrix."""

    def euler(t: float) -> np.ndarray:
        return np.array([0.3 * np.sin(t), 0.2 * np.cos(2 * t), 1.5 * t])

    h, t = 1e-5, 0.7
    before, middle, after = (mat_from_euler(*euler(t + d)) for d in (-h, 0.0, h))
    skew = middle.T @ (after - before) / (2 * h)
    rates = (euler(t + h) - euler(t - h)) / (2 * h)
    omega = body_rate_from_euler(*euler(t)[:2], *rates)
    assert omega == pytest.approx([skew[2, 1], skew[0, 2], skew[1, 0]], abs=1e-8)
