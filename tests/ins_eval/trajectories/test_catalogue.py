"""Ready missions: their increments, navigated, reproduce them."""

from pathlib import Path

import numpy as np
import pytest

from ins_eval.common.state import TrackError, track_error
from ins_eval.navigation.height import Clamped, Free
from ins_eval.navigation.strapdown import navigate
from ins_eval.trajectories import catalogue
from ins_eval.trajectories.errors import TrajectoryError
from ins_eval.trajectories.trajectory import Trajectory
from pyhrg.common.units import STANDARD_GRAVITY
from tests.ins_eval.trajectories.test_recorded_drive import make_drive, write_drive

IN_FLIGHT = ("great-circle", "weaving")
SECONDS = {"missile": 850.0}
NAMES = (
    "aircraft",
    "airliner",
    "car",
    "city",
    "great-circle",
    "long-haul",
    "missile",
    "ship",
    "static-table",
    "straight-and-level",
    "weaving",
)
LIMIT = 1e-3
"""Largest position error over half an hour, or over a shorter mission, m."""


def load_ready(name: str) -> tuple[Trajectory, float]:
    duration = SECONDS.get(name, 1800.0)
    return catalogue.load_trajectory(name, duration, 0.0 if name in IN_FLIGHT else 320.0), duration


def navigate_ideally(path: Trajectory, duration: float, interval: float) -> TrackError:
    count = 20 * round(duration / interval / 20)
    heights = path.position(interval * np.arange(count + 1.0))[:, 2]
    increments = path.increments(0.0, interval, count)
    track = navigate(path.state(0.0), increments, Clamped(heights), count // 10)
    return track_error(track, path.track(track.time))


def test_all_ready_missions_are_tried() -> None:
    assert catalogue.list_trajectories() == list(NAMES)


@pytest.mark.parametrize("name", NAMES)
def test_ready_mission_navigates_to_itself(name: str) -> None:
    """Error-free increments at 100 Hz, height clamped."""
    path, duration = load_ready(name)
    error = navigate_ideally(path, duration, 0.01)
    assert np.max(np.linalg.norm(error.position[:, :2], axis=1)) < LIMIT
    assert np.max(np.abs(error.attitude)) < 1e-8


@pytest.mark.parametrize("name", NAMES)
def test_ready_mission_navigates_with_free_height(name: str) -> None:
    """From time 0 for two minutes: also the vertical channel gives the mission back."""
    path, _ = load_ready(name)
    increments = path.increments(0.0, 0.01, 12_000)
    track = navigate(path.state(0.0), increments, Free(), 12_000)
    error = track_error(track, path.track(track.time))
    assert np.max(np.abs(error.position)) < LIMIT


def test_error_of_the_aircraft_is_the_navigators() -> None:
    """It falls with the interval by the square or better: none of the increments' is left over."""
    path, duration = load_ready("aircraft")
    coarse, fine = (
        np.max(np.linalg.norm(navigate_ideally(path, duration, h).position[:, :2], axis=1))
        for h in (0.02, 0.01)
    )
    assert coarse > 4 * fine


@pytest.mark.parametrize("name", sorted(set(NAMES) - set(IN_FLIGHT)))
def test_mission_stands_before_time_0(name: str) -> None:
    path, _ = load_ready(name)
    omega, force = path.rate_and_force(np.linspace(-320, 0, 321))
    assert np.ptp(omega, axis=0) == pytest.approx(np.zeros(3), abs=1e-9)
    assert np.ptp(force, axis=0) == pytest.approx(np.zeros(3), abs=1e-4)


def test_great_circle_crosses_the_dateline_without_a_jump() -> None:
    path = catalogue.load_trajectory("great-circle", 33_600.0)
    longitude = np.rad2deg(path.position(np.linspace(0, 33_600, 1000))[:, 1])
    assert longitude[0] < 180 < longitude[-1]
    assert np.max(np.diff(longitude)) < 0.2
    assert np.rad2deg(path.position(np.array(33_600.0)))[:2] == pytest.approx(
        [37.6, 360 - 122.4], abs=0.6
    )


def test_files_are_told_by_their_endings(tmp_path: Path) -> None:
    mission = tmp_path / "mine.toml"
    mission.write_text((catalogue.READY_FOLDER / "car.toml").read_text())
    assert catalogue.load_trajectory(mission, 60.0, 20.0).name == "mine"
    drive = write_drive(tmp_path, make_drive())
    assert catalogue.load_trajectory(str(drive), 60.0, 20.0).name == drive.name


def test_unknown_name_is_told_the_known_ones() -> None:
    with pytest.raises(TrajectoryError, match="lorry: found no such mission, expected aircraft, "):
        catalogue.load_trajectory("lorry", 60.0)


def test_missile_is_one_that_can_fly() -> None:
    """It coasts at 0 g; elsewhere its lateral force in g stays below dynamic pressure over 4 kPa,
    what a slender body of 33 kPa wing loading has at a normal-force coefficient of 8; it dives."""
    path, duration = load_ready("missile")
    time = np.linspace(0.0, duration, 4000)
    force = path.rate_and_force(time)[1] / STANDARD_GRAVITY
    height = path.position(time)[:, 2]
    speed = np.linalg.norm(path.velocity(time), axis=1)
    pressure = 0.5 * 1.225 * np.exp(-height / 7200.0) * speed**2
    lateral = np.hypot(force[:, 1], force[:, 2])
    assert np.all(lateral < pressure / 4000 + 0.05)
    coasting = height > 50_000
    assert np.max(np.linalg.norm(force[coasting], axis=1)) < 1e-3
    assert np.sum(coasting) * duration / len(time) > 200
    assert path.velocity(time)[-1, 2] / speed[-1] > 0.7
    assert 0 < height[-1] < 15_000


@pytest.mark.parametrize("name", ["car", "city"])
def test_corners_can_be_driven(name: str) -> None:
    """Horizontal specific force stays below 0.5 g, which dry tyres hold."""
    path = catalogue.load_trajectory(name, 3600.0)
    time = np.linspace(0.0, 3600.0, 14_401)
    force = np.einsum("nij,nj->ni", path.mat_nb(time), path.rate_and_force(time)[1])
    assert np.max(np.hypot(force[:, 0], force[:, 1])) < 0.5 * STANDARD_GRAVITY


def test_missile_says_that_it_is_shorter() -> None:
    with pytest.raises(
        TrajectoryError, match=r"missile: lasts 871\.\d+ s, shorter than the 7200 s"
    ):
        catalogue.load_trajectory("missile", 7200.0, 320.0)
