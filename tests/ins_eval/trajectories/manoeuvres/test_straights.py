"""Straight legs, great circles, rolls, the turntable, against closed forms."""

import math

import numpy as np
import pytest

from ins_eval.common import earth
from ins_eval.trajectories.errors import TrajectoryError
from ins_eval.trajectories.manoeuvres.straights import Accelerate, Rest, Roll, Straight, Turntable
from ins_eval.trajectories.manoeuvres.turns import Turn
from ins_eval.trajectories.mission import Mission, Start, build_trajectory
from tests.ins_eval.trajectories.flights import displacement, euler, fly_manoeuvres


def vincenty(latitude: float, azimuth: float, distance: float) -> tuple[float, float, float]:
    """Latitude, change of longitude and azimuth at the end of a geodesic (Vincenty 1975, direct
    formula; 0.1 mm)."""
    f, a = earth.FLATTENING, earth.SEMI_MAJOR
    b = a * (1 - f)
    tan_u1 = (1 - f) * math.tan(latitude)
    cos_u1 = 1 / math.hypot(1, tan_u1)
    sin_u1 = tan_u1 * cos_u1
    sigma1 = math.atan2(tan_u1, math.cos(azimuth))
    sin_alpha = cos_u1 * math.sin(azimuth)
    cos2_alpha = 1 - sin_alpha**2
    u2 = cos2_alpha * (a**2 - b**2) / b**2
    k_a = 1 + u2 / 16384 * (4096 + u2 * (-768 + u2 * (320 - 175 * u2)))
    k_b = u2 / 1024 * (256 + u2 * (-128 + u2 * (74 - 47 * u2)))
    sigma = distance / (b * k_a)
    for _ in range(30):
        m = math.cos(2 * sigma1 + sigma)
        s, c = math.sin(sigma), math.cos(sigma)
        last = k_b / 6 * m * (4 * s * s - 3) * (4 * m * m - 3)
        sigma = distance / (b * k_a) + k_b * s * (m + k_b / 4 * (c * (2 * m * m - 1) - last))
    m, s, c = math.cos(2 * sigma1 + sigma), math.sin(sigma), math.cos(sigma)
    across = sin_u1 * s - cos_u1 * c * math.cos(azimuth)
    end = math.atan2(
        sin_u1 * c + cos_u1 * s * math.cos(azimuth), (1 - f) * math.hypot(sin_alpha, across)
    )
    lam = math.atan2(s * math.sin(azimuth), cos_u1 * c - sin_u1 * s * math.cos(azimuth))
    k_c = f / 16 * cos2_alpha * (4 + f * (4 - 3 * cos2_alpha))
    bend = sigma + k_c * s * (m + k_c * c * (2 * m * m - 1))
    return end, lam - (1 - k_c) * f * sin_alpha * bend, math.atan2(sin_alpha, -across)


def far(path: str, heading: float, hours: float) -> np.ndarray:
    """Latitude, longitude, yaw (3,) after hours at 250 m/s, at sea level, from 40 N 170 E."""
    start = Start(latitude=np.deg2rad(40), longitude=np.deg2rad(170), heading=heading, speed=250.0)
    leg = Straight(duration=hours * 3600 + 60, path=path)
    flight = build_trajectory(Mission(name="far", start=start, course=(leg,)), hours * 3600)
    end = np.array(hours * 3600)
    return np.array([*flight.position(end)[:2], euler(flight, end)[2]])


@pytest.mark.parametrize("heading_deg", [60.0, 90.0, 135.0])
def test_great_circle_ends_where_vincenty_says(heading_deg: float) -> None:
    """5400 km across the dateline, to 2 mm; the rhumb line ends hundreds of km away."""
    heading = math.radians(heading_deg)
    latitude, longitude, azimuth = vincenty(math.radians(40), heading, 250.0 * 6 * 3600)
    expected = [latitude, math.radians(170) + longitude, azimuth]
    assert expected[1] > math.pi
    assert far("great-circle", heading, 6) == pytest.approx(expected, abs=3e-10)
    assert abs(far("rhumb", heading, 6)[0] - latitude) > 0.02


def test_rhumb_line_keeps_its_heading_and_goes_by_isometric_latitude() -> None:
    """Change of longitude = tan(heading) times the change of isometric latitude."""

    def isometric(latitude: float) -> float:
        e = math.sqrt(earth.ECCENTRICITY_SQUARED)
        s = math.sin(latitude)
        return math.atanh(s) - e * math.atanh(e * s)

    latitude, longitude, yaw = far("rhumb", 1.0, 4)
    change = math.tan(1.0) * (isometric(latitude) - isometric(math.radians(40)))
    assert longitude - math.radians(170) == pytest.approx(change, abs=1e-9)
    assert yaw == pytest.approx(1.0, abs=1e-10)


def test_acceleration_ends_at_its_speed() -> None:
    """Way: the mean of both speeds, by symmetry of the step; peak 1.875 of the mean."""
    path, end = fly_manoeuvres(Accelerate(speed=260.0, duration=30.0))
    assert displacement(path, end)[0] == pytest.approx(230 * 30, rel=1e-5)
    assert path.velocity(np.array(end))[0] == pytest.approx(260.0, abs=1e-3)
    force = path.rate_and_force(np.array(15.0))[1]
    assert force[0] == pytest.approx(1.875 * 60 / 30, abs=2e-2)


@pytest.mark.parametrize("turns", [1, -2])
def test_roll_comes_back(turns: int) -> None:
    """The integral of the rate about the forward axis is the roll; attitude and course are kept."""
    path, end = fly_manoeuvres(Roll(roll=turns * 2 * np.pi, duration=8.0), Straight(duration=5.0))
    swept = path.increments(0.0, end / 1000, 1000).rotation[:, 0].sum()
    assert swept == pytest.approx(turns * 2 * np.pi, abs=2e-3)
    assert path.mat_nb(np.array(end)) == pytest.approx(path.mat_nb(np.array(0.0)), abs=1e-5)
    assert euler(path, np.array(4.0))[0] % (2 * np.pi) == pytest.approx(
        (turns * np.pi) % (2 * np.pi), abs=1e-6
    )
    assert displacement(path, end)[1] == pytest.approx(0.0, abs=1e-6)


def test_turntable_turns_at_its_rate_and_stays() -> None:
    table = Turntable(turn=np.deg2rad(-270), rate=np.deg2rad(10), ramp=1.0)
    path, end = fly_manoeuvres(Rest(duration=30.0), table, Rest(duration=30.0), speed=0.0)
    assert end == pytest.approx(30 + 28 + 30)
    assert displacement(path, end) == pytest.approx(np.zeros(3), abs=1e-9)
    assert euler(path, np.array(end))[2] == pytest.approx(np.deg2rad(90), abs=1e-6)
    down = -path.rate_and_force(np.array(44.0))[0][2]
    assert down == pytest.approx(np.deg2rad(10) + earth.RATE * np.sin(np.deg2rad(45)), rel=1e-6)


def test_turntable_too_short_for_its_rate() -> None:
    with pytest.raises(TrajectoryError, match=r"course 1: turn_deg: found 0\.1 s .* ramp_s, 1 s"):
        fly_manoeuvres(Turntable(turn=0.01, rate=0.1), speed=0.0)


@pytest.mark.parametrize("manoeuvre", [Rest(duration=5.0), Turntable(turn=1.0, rate=0.1)])
def test_moving_vehicle_does_not_stand(manoeuvre: Rest | Turntable) -> None:
    with pytest.raises(TrajectoryError, match="course 1: speed: found 200 m/s, expected 0"):
        fly_manoeuvres(manoeuvre)


def test_a_vehicle_reverses_round_a_corner() -> None:
    """Backward at 3 m/s: the nose leads the other way, and a turn to the right swings the tail to
    the left: it ends behind, by the chord of the bend."""
    reverse = (Accelerate(speed=-3.0, duration=10.0), Straight(duration=10.0))
    path, end = fly_manoeuvres(*reverse, Turn(turn=np.pi / 2, duration=10.0), speed=0.0)
    assert path.velocity(np.array(15.0)) == pytest.approx([-3.0, 0.0, 0.0], abs=1e-6)
    assert path.mat_nb(np.array(15.0))[:, 0] == pytest.approx([1.0, 0.0, 0.0], abs=1e-9)
    assert path.velocity(np.array(end)) == pytest.approx([0.0, -3.0, 0.0], abs=1e-3)
    assert displacement(path, 20.0)[:2] == pytest.approx([-45.0, 0.0], abs=1e-3)
