"""The yardstick flight flies what it says."""

import numpy as np
import pytest

from benchmarks.navigation.weave import Weave

WEAVE = Weave(latitude=np.deg2rad(-30.0), longitude=3.1, heading=1.0)
TRAJECTORY = WEAVE.trajectory(120)
TIME = np.linspace(0.0, 120.0, 2001)


def test_starts_where_told() -> None:
    start = TRAJECTORY.state(0.0)
    assert [start.latitude, start.longitude, start.height] == pytest.approx(
        [WEAVE.latitude, WEAVE.longitude, WEAVE.height], abs=1e-14
    )


def test_speed_is_constant_and_the_nose_points_where_it_goes() -> None:
    velocity = TRAJECTORY.velocity(TIME)
    assert np.linalg.norm(velocity, axis=1) == pytest.approx(np.full(len(TIME), 250.0), abs=1e-6)
    heading = 1.0 + np.deg2rad(20.0) * np.sin(2 * np.pi * TIME / 60.0)
    assert np.arctan2(velocity[:, 1], velocity[:, 0]) == pytest.approx(heading, abs=1e-8)
    forward = TRAJECTORY.mat_nb(TIME)[:, :, 0]
    assert forward * 250.0 == pytest.approx(velocity, abs=1e-6)


def test_turns_are_coordinated() -> None:
    """Hardly any specific force sideways, of up to 9.2 m/s^2 across the path: Earth's turning and
    curvature alone are not banked for."""
    _, force = TRAJECTORY.rate_and_force(TIME)
    assert np.max(np.abs(force[:, 1])) < 0.06
    assert np.max(np.abs(force[:, 2])) > 13.0
