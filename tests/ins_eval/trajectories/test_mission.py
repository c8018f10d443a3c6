"""Missions: rest before, repetition, ends, poles."""

import numpy as np
import pytest

from ins_eval.trajectories.errors import MovingStartError, TrajectoryError
from ins_eval.trajectories.manoeuvres.manoeuvre import Manoeuvre
from ins_eval.trajectories.manoeuvres.overlays import Sway
from ins_eval.trajectories.manoeuvres.straights import Accelerate, Rest, Straight
from ins_eval.trajectories.manoeuvres.turns import CoordinatedTurn, Turn
from ins_eval.trajectories.manoeuvres.vertical import Climb
from ins_eval.trajectories.mission import Mission, Start, build_trajectory, compute_duration

STANDING = Start(latitude=0.8, longitude=0.1)
MOVING = Start(latitude=0.8, longitude=0.1, speed=20.0)
DRIVE = (Rest(duration=20.0), Accelerate(speed=20.0, duration=15.0))


def test_stands_before_time_0_and_departs_after() -> None:
    mission = Mission(name="m", start=STANDING, course=(*DRIVE, Straight(duration=100.0)))
    path = build_trajectory(mission, 100.0, 300.3)
    assert path.start <= -300.3
    assert path.end >= 100.0
    still = path.velocity(np.linspace(-300.3, 10.0, 100))
    assert np.max(np.abs(still)) < 1e-6
    assert np.linalg.norm(path.velocity(np.array(60.0))) == pytest.approx(20.0, abs=1e-6)


def test_sea_begins_when_the_ship_leaves() -> None:
    course = (*DRIVE, Straight(duration=200.0))
    sea = (Sway(roll=0.1, start=20.0),)
    mission = Mission(name="m", start=STANDING, course=course, overlays=sea)
    omega = build_trajectory(mission, 200.0, 300.0).rate_and_force(np.linspace(-300, 10, 200))[0]
    assert np.ptp(omega, axis=0) == pytest.approx(np.zeros(3), abs=1e-7)


def test_motion_is_not_asked_to_stand() -> None:
    mission = Mission(name="m", start=MOVING, course=(Straight(duration=100.0),))
    with pytest.raises(
        MovingStartError, match=r"m: starts at 20 m/s, expected .* for 320 s before"
    ):
        build_trajectory(mission, 60.0, 320.0)


def test_mission_shorter_than_asked_for() -> None:
    mission = Mission(name="m", start=MOVING, course=(Straight(duration=100.0),), repeat=3)
    assert compute_duration(mission) == pytest.approx(300.0)
    assert build_trajectory(mission, 300.0).end >= 300.0
    with pytest.raises(TrajectoryError, match=r"m: lasts 300 s, shorter than the 301 s asked for"):
        build_trajectory(mission, 301.0)


def test_course_repeats_after_its_departure() -> None:
    """Four sides of a square, over and over; departure once."""
    side = (Straight(duration=50.0), Turn(turn=np.pi / 2, duration=10.0))
    mission = Mission(name="m", start=STANDING, departure=DRIVE, course=side, repeat=None)
    assert compute_duration(mission) == np.inf
    path = build_trajectory(mission, 1000.0)
    assert 1000.0 < path.end < 1011.0
    lap = path.velocity(np.array([60.0, 120.0, 180.0, 240.0, 300.0]))[:, :2] / 20.0
    expected = [[1, 0], [0, 1], [-1, 0], [0, -1], [1, 0]]
    assert lap == pytest.approx(np.array(expected), abs=1e-4)


def test_beginning_does_not_depend_on_the_end() -> None:
    """Asked for longer, a mission begins the same."""
    mission = Mission(name="m", start=STANDING, course=(*DRIVE, Straight(duration=5000.0)))
    time = np.linspace(0, 80, 200)
    short, long = (build_trajectory(mission, duration) for duration in (100.0, 4000.0))
    assert short.position(time) == pytest.approx(long.position(time), abs=1e-13)


def test_manoeuvre_that_cannot_be_entered_is_named() -> None:
    turn = CoordinatedTurn(turn=1.0)
    mission = Mission(name="m", start=STANDING, departure=(Rest(duration=1.0), turn), course=DRIVE)
    with pytest.raises(TrajectoryError, match=r"^m: departure 2: speed: found 0 m/s"):
        build_trajectory(mission, 1.0)


@pytest.mark.parametrize("path", ["rhumb", "great-circle"])
def test_pole_is_refused_with_its_time(path: str) -> None:
    """From 88 deg north at 250 m/s: 1 deg, 111.7 km, takes 447 s."""
    start = Start(latitude=np.deg2rad(88), longitude=0.0, speed=250.0)
    mission = Mission(name="m", start=start, course=(Straight(duration=2000.0, path=path),))
    with pytest.raises(TrajectoryError, match=r"m: at 447 s it passes latitude 89 deg; expected"):
        build_trajectory(mission, 2000.0)
    assert build_trajectory(mission, 430.0).end > 430.0


@pytest.mark.parametrize(("still", "duration"), [(-1.0, 10.0), (0.0, 0.0), (np.nan, 10.0)])
def test_times_that_are_none(still: float, duration: float) -> None:
    mission = Mission(name="m", start=STANDING, course=DRIVE)
    with pytest.raises(TrajectoryError, match=r"s at rest and .* s after, expected 0 or more"):
        build_trajectory(mission, duration, still)


@pytest.mark.parametrize(
    ("manoeuvre", "message"),
    [
        (Accelerate(speed=4000.0, duration=0.5), r"at 0\.\d s it has .* m/s2 of specific force"),
        (Turn(turn=60.0, duration=0.3), r"at 0\.\d s it has .* expected 0 to 1000"),
        (
            Climb(height_change=-9000.0, climb_angle=0.5),
            "s it has -1.* m of height; expected -1000",
        ),
    ],
)
def test_what_no_vehicle_does_is_refused(manoeuvre: Manoeuvre, message: str) -> None:
    course = (manoeuvre, Straight(duration=20.0))
    mission = Mission(name="m", start=MOVING, course=course)
    with pytest.raises(TrajectoryError, match=message):
        build_trajectory(mission, compute_duration(mission))


def test_values_out_of_range_are_refused_in_python_too() -> None:
    with pytest.raises(TrajectoryError, match="latitude_deg: found 90, expected -89 to 89 deg"):
        Start(latitude=np.pi / 2, longitude=0.0)
    with pytest.raises(TrajectoryError, match=r"bank_deg: found 85, expected 0\.1 to 80 deg"):
        CoordinatedTurn(turn=1.0, bank=np.deg2rad(85))
    with pytest.raises(TrajectoryError, match="path: found 'straight', expected \"rhumb\" or"):
        Straight(duration=1.0, path="straight")
