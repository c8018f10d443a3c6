"""Truth that is consistent with itself."""

import numpy as np
import pytest

from ins_eval.common import earth
from ins_eval.trajectories import catalogue
from ins_eval.trajectories.trajectory import Trajectory


@pytest.fixture(scope="module")
def trajectory() -> Trajectory:
    return catalogue.load_trajectory("car", 900.0, 320.0)


def test_stands_still_and_feels_earth_and_gravity(trajectory: Trajectory) -> None:
    time = np.linspace(-300.0, -1.0, 50)
    omega, force = trajectory.rate_and_force(time)
    latitude, _, height = trajectory.position(np.array(0.0))
    assert np.linalg.norm(omega, axis=1) == pytest.approx(np.full(50, earth.RATE), rel=1e-9)
    assert np.linalg.norm(force, axis=1) == pytest.approx(
        np.full(50, float(earth.gravity(latitude, height))), rel=1e-9
    )


def test_increments_integrate_rate_and_force(trajectory: Trajectory) -> None:
    """Quadrature against the trapezoid rule at 100 times the rate."""
    increments = trajectory.increments(270.0, 0.01, 100)
    time = 270.0 + np.arange(10_001) * 1e-4
    omega, force = trajectory.rate_and_force(time)
    for got, rate in ((increments.rotation, omega), (increments.velocity, force)):
        expected = np.trapezoid(rate, dx=1e-4, axis=0)
        assert got.sum(axis=0) == pytest.approx(expected, rel=1e-7, abs=1e-10)


@pytest.mark.parametrize("name", ["aircraft", "ship", "missile"])
@pytest.mark.parametrize(("rate", "count"), [(10, 200), (14.2857, 200), (100, 400), (2000, 2000)])
def test_increments_at_any_rate(name: str, rate: float, count: int) -> None:
    """Against twelve points on each of twenty panels an interval; intervals need not end at
    knots."""
    path = catalogue.load_trajectory(name, 800.0)
    start, interval = 620.013, 1 / rate
    got = path.increments(start, interval, count)
    points, weights = np.polynomial.legendre.leggauss(12)
    edges = start + interval * np.arange(20 * count + 1) / 20
    half = interval / 40
    times = 0.5 * (edges[1:] + edges[:-1])[:, None] + half * points
    for increments, values in zip(
        (got.rotation, got.velocity), path.rate_and_force(times), strict=True
    ):
        expected = (half * np.einsum("k,nkj->nj", weights, values)).reshape(count, 20, 3).sum(1)
        scale = np.max(np.abs(expected))
        assert np.max(np.abs(increments - expected)) < 1e-10 * scale
        assert np.sum(increments, axis=0) == pytest.approx(
            np.sum(expected, axis=0), abs=1e-12 * scale * count
        )


def test_increments_stay_within_the_trajectory(trajectory: Trajectory) -> None:
    with pytest.raises(ValueError, match=r"from 900 to 920 s; car goes from -320 to 910 s"):
        trajectory.increments(900.0, 0.1, 200)


def test_velocity_is_the_derivative_of_position(trajectory: Trajectory) -> None:
    time = np.array(400.0)
    before, after = trajectory.position(time - 1e-3), trajectory.position(time + 1e-3)
    middle = trajectory.position(time)
    north = (after[0] - before[0]) / 2e-3 * (earth.meridian_radius(middle[0]) + middle[2])
    assert trajectory.velocity(time)[0] == pytest.approx(north, rel=1e-6)


def test_specific_force_is_acceleration_less_gravity_less_coriolis(trajectory: Trajectory) -> None:
    """Finite differences of the velocity's components."""
    time, h = np.array(281.0), 1e-3
    velocity = trajectory.velocity(time)
    acceleration = (trajectory.velocity(time + h) - trajectory.velocity(time - h)) / (2 * h)
    latitude, _, height = trajectory.position(time)
    north = velocity[0] / (earth.meridian_radius(latitude) + height)
    east = velocity[1] / (earth.transverse_radius(latitude) + height)
    turn = np.array([2 * earth.RATE * np.cos(latitude) + east, -north, 0.0])
    turn[2] = -2 * earth.RATE * np.sin(latitude) - east * np.tan(latitude)
    north, east = earth.horizontal_gravity(latitude, height, (0.0, 0.0))
    gravity = [north, east, earth.gravity(latitude, height)]
    expected = acceleration + np.cross(turn, velocity) - gravity
    force = trajectory.rate_and_force(time)[1]
    assert trajectory.mat_nb(time) @ force == pytest.approx(expected, abs=1e-6)


def test_gravity_and_radii_against_tables() -> None:
    """WGS-84: normal gravity at equator, 45 deg and pole; M and N at the equator and the pole."""
    assert earth.gravity(0.0, 0.0) == pytest.approx(9.7803253359, abs=1e-9)
    assert earth.gravity(np.pi / 4, 0.0) == pytest.approx(9.806197769, abs=1e-8)
    assert earth.gravity(np.pi / 2, 0.0) == pytest.approx(9.8321849379, abs=1e-8)
    assert earth.meridian_radius(0.0) == pytest.approx(6335439.327, abs=1e-2)
    assert earth.transverse_radius(0.0) == pytest.approx(6378137.0, abs=1e-6)
    assert earth.meridian_radius(np.pi / 2) == pytest.approx(6399593.626, abs=1e-2)
