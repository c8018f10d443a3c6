"""Coasting: no specific force, and the parabola of a fall."""

import numpy as np
import pytest

from ins_eval.common import earth
from ins_eval.trajectories.errors import TrajectoryError
from ins_eval.trajectories.manoeuvres.coast import Coast
from ins_eval.trajectories.manoeuvres.straights import Rest, Straight
from tests.ins_eval.trajectories.flights import GRAVITY, HEIGHT, LATITUDE, fly_manoeuvres

CLIMB = np.deg2rad(50)


@pytest.mark.parametrize("heading", [0.0, 2.0, 4.5])
def test_nothing_is_felt_between_the_ramps(heading: float) -> None:
    """Below 1e-3 m/s^2 on the rotating ellipsoid, after a manoeuvre that moves the vehicle; outside
    the ramps gravity is."""
    before = Straight(duration=30.0)
    path, end = fly_manoeuvres(
        before, Coast(duration=150.0), before, speed=1500.0, heading=heading, climb_angle=CLIMB
    )
    _, force = path.rate_and_force(np.linspace(30 + 3.5, end - 30 - 3.5, 500))
    assert np.max(np.linalg.norm(force, axis=1)) < 1e-3
    _, outside = path.rate_and_force(np.array([29.0, end - 29.0]))
    assert np.min(np.linalg.norm(outside, axis=1)) > 8


def test_apex_is_that_of_the_parabola() -> None:
    """A throw of 200 m/s northwards; gravity less the centrifugal force of the path, to 0.2 %."""
    coast = Coast(duration=30.0, ramp=1.0)
    path, _ = fly_manoeuvres(coast, speed=200.0, heading=0.0, climb_angle=CLIMB)
    level = 200 * np.cos(CLIMB)
    pull = GRAVITY - level**2 / float(earth.meridian_radius(LATITUDE))
    time = np.linspace(0, 29, 2000)
    height = path.position(time)[:, 2] - HEIGHT
    rise = (200 * np.sin(CLIMB)) ** 2 / 2 / pull
    ramp_rise = 200 * np.sin(CLIMB) * 0.5
    assert np.max(height) == pytest.approx(rise + ramp_rise, rel=2e-3)


def test_a_vehicle_at_rest_does_not_coast() -> None:
    with pytest.raises(TrajectoryError, match=r"found 0 m/s .* expected at least 1 m/s"):
        fly_manoeuvres(Rest(duration=5.0), Coast(duration=20.0), speed=0.0)
