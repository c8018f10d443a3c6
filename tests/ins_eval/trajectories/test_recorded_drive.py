"""Reading a drive: what is right goes through, what is wrong is named."""

import gzip
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from scipy.integrate import cumulative_trapezoid

from ins_eval.common import earth
from ins_eval.common.state import position_error
from ins_eval.trajectories.errors import TrajectoryError
from ins_eval.trajectories.recorded_drive import COLUMNS, Drive, read_drive, repeat_drive
from ins_eval.trajectories.trajectory import Trajectory
from pyhrg.common.errors import HrgError
from tests.recordings import find_recording

Rows = list[list[str]]


def make_drive() -> Rows:
    """Two minutes of a car going north at 10 m/s, turning gently, 1 Hz."""
    time = np.arange(121.0)
    heading = 0.2 + 0.3 * np.sin(time / 60)
    north, east = 10 * np.cos(heading), 10 * np.sin(heading)
    latitude = 0.78 + np.cumsum(north) / float(earth.meridian_radius(0.78))
    longitude = 0.13 + np.cumsum(east) / float(earth.transverse_radius(0.78)) / np.cos(0.78)
    zero = np.zeros_like(time)
    table = np.stack(
        [
            time,
            np.rad2deg(latitude),
            np.rad2deg(longitude),
            zero + 300,
            (north + np.roll(north, -1)) / 2,
            (east + np.roll(east, -1)) / 2,
            zero,
            zero,
            zero,
            np.rad2deg(heading),
        ],
        axis=-1,
    )
    return [list(COLUMNS), *([f"{value:.9f}" for value in row] for row in table)]


def write_drive(folder: Path, rows: Rows) -> Path:
    path = folder / "drive.csv"
    path.write_text("\n".join(",".join(row) for row in rows) + "\n")
    return path


def test_drive_is_read_plain_and_gzipped(tmp_path: Path) -> None:
    plain = write_drive(tmp_path, make_drive())
    packed = tmp_path / "drive.csv.gz"
    packed.write_bytes(gzip.compress(plain.read_bytes()))
    assert np.array_equal(read_drive(plain).position, read_drive(packed).position)


def test_drive_repeats_smoothly(tmp_path: Path) -> None:
    """Ten minutes from two: accelerations stay those of a car, rest comes first, heading holds."""
    drive = read_drive(write_drive(tmp_path, make_drive()))
    path = repeat_drive(drive, 600.0, 320.0)
    assert path.start == -320.0
    assert path.end > 605.0
    time = np.arange(0.0, 600.0, 0.1)
    force = path.rate_and_force(time)[1]
    assert np.max(np.abs(force[:, :2])) < 4.0
    assert np.max(np.linalg.norm(path.velocity(time), axis=1)) < 15.0
    assert path.velocity(np.array(-100.0)) == pytest.approx(np.zeros(3), abs=1e-6)
    speed = np.linalg.norm(path.velocity(np.array([60.0, 200.0, 340.0, 480.0])), axis=1)
    assert speed == pytest.approx(np.full(4, 10.0), abs=0.3)


def test_drive_in_circles_repeats_without_unwinding(tmp_path: Path) -> None:
    """Two rounds to the right: repetitions go on from the heading reached, never back."""
    rows = make_drive()
    time = np.arange(121.0)
    heading = 4 * np.pi * time / 120
    radius = 10 * 120 / (4 * np.pi)
    north, east = radius * np.sin(heading), radius * (1 - np.cos(heading))
    for i, row in enumerate(rows[1:]):
        row[1] = f"{np.rad2deg(0.78 + north[i] / float(earth.meridian_radius(0.78))):.10f}"
        east_radius = float(earth.transverse_radius(0.78)) * np.cos(0.78)
        row[2] = f"{np.rad2deg(0.13 + east[i] / east_radius):.10f}"
        row[4], row[5] = f"{10 * np.cos(heading[i]):.6f}", f"{10 * np.sin(heading[i]):.6f}"
        row[9] = f"{np.rad2deg(np.mod(heading[i], 2 * np.pi)):.6f}"
    path = repeat_drive(read_drive(write_drive(tmp_path, rows)), 900.0, 320.0)
    omega = path.rate_and_force(np.arange(0.0, 900.0, 0.1))[0]
    assert np.max(np.abs(omega[:, 2])) < 0.2


def make_bend(yaw_deg: np.ndarray, speed: np.ndarray) -> Drive:
    """A drive without sideslip, 1 Hz, at headings and speeds (n,), negative backward."""
    time, yaw = np.arange(float(len(speed))), np.deg2rad(yaw_deg)
    velocity = np.stack([speed * np.cos(yaw), speed * np.sin(yaw), 0 * yaw], axis=-1)
    moved = cumulative_trapezoid(velocity, dx=1.0, axis=0, initial=0.0)
    radius = [float(earth.meridian_radius(0.78)), float(earth.transverse_radius(0.78))]
    latitude, longitude = moved[:, 0] / radius[0], moved[:, 1] / radius[1] / np.cos(0.78)
    position = np.stack([0.78 + latitude, longitude, 0 * yaw], axis=-1)
    return Drive("bend", time, position, velocity, np.stack([0 * yaw, 0 * yaw, yaw], axis=-1))


HALF = np.linspace(0.0, 1.0, 61)
BENDS = {
    "round a corner": make_bend(90 * HALF, np.full(61, 9.0)),
    "fast round": make_bend(170 * HALF, np.full(61, 25.0)),
    "from rest to rest, about": make_bend(180 * HALF, 40 * HALF * (1 - HALF)),
    "backward at the end": make_bend(60 * HALF, 8 - 14 * HALF),
}


@pytest.mark.parametrize("name", BENDS)
def test_joints_have_no_sideslip(name: str) -> None:
    """The velocity points where the nose does or back, to 1 % or 0.1 m/s between the knots; it was
    beside it by up to the whole speed. Joints bend no tighter than a car can, below 0.5 g."""
    drive = BENDS[name]
    path = repeat_drive(drive, 200.0, 10.0)
    time = np.arange(21.0, 200.0, 0.1)
    velocity, mat = path.velocity(time), path.mat_nb(time)
    side = np.einsum("ni,ni->n", velocity, mat[:, :, 1])
    assert np.all(np.abs(side) < 0.1 + 0.01 * np.linalg.norm(velocity, axis=1))
    rate, force = path.rate_and_force(time)
    assert np.max(np.abs(force[:, 1])) < 0.5 * 9.81
    speed = np.linalg.norm(velocity, axis=1)
    assert np.all(np.abs(rate[:, 2]) * 5.5 < speed + 0.15)


def test_vehicles_reverse() -> None:
    """Backward at the end of a drive: it goes on backward into the joint, and stops on the way to
    the drive's forward beginning."""
    path = repeat_drive(BENDS["backward at the end"], 200.0, 10.0)
    time = np.arange(81.0, 99.0)
    along = np.einsum("ni,ni->n", path.velocity(time), path.mat_nb(time)[:, :, 0])
    assert along[0] == pytest.approx(-6.0, abs=0.5)
    assert along[-1] > 6
    assert np.sum(np.diff(np.sign(along)) != 0) == 1


def edit(row: int, column: str, text: str) -> Callable[[Rows], Rows]:
    def apply(rows: Rows) -> Rows:
        rows[row][COLUMNS.index(column)] = text
        return rows

    return apply


def drop_columns(rows: Rows) -> Rows:
    return [row[:7] for row in rows]


def swap_velocities(rows: Rows) -> Rows:
    return [rows[0], *([*row[:4], row[5], row[4], *row[6:]] for row in rows[1:])]


def roll_over(rows: Rows) -> Rows:
    """At ten times the pace, so that a jump of 170 deg can't be a turn."""
    for row in rows[1:]:
        row[0] = str(float(row[0]) / 10)
    return edit(5, "roll_deg", "170")(rows)


def gap(rows: Rows) -> Rows:
    return rows[:40] + rows[60:]


@pytest.mark.parametrize(
    ("mistake", "message"),
    [
        (drop_columns, r"column roll_deg, pitch_deg, yaw_deg is missing; found time_s, "),
        (edit(7, "latitude_deg", "nan"), r"row 8, latitude_deg: nan; expected -89 to 89"),
        (edit(9, "latitude_deg", "95.0"), r"row 10, latitude_deg: 95\.0; expected -89 to 89"),
        (edit(5, "time_s", "2.0"), r"row 6, time_s: 2 after 3; expected time to increase"),
        (edit(5, "yaw_deg", "north"), r"row 6, yaw_deg: 'north' is not a number"),
        (edit(5, "time_s", ""), r"row 6, time_s: '' is not a number"),
        (lambda rows: rows[:5], r"4 rows; expected at least 10"),
        (
            lambda rows: [[*row, row[0]] for row in rows],
            r"column time_s appears more than once",
        ),
        (edit(5, "yaw_deg", "1e3"), r"row 6, yaw_deg: 1e3; expected -720 to 720"),
        (roll_over, r"row 7, roll_deg: turns at 1700 deg/s; expected at most 573 deg/s"),
        (lambda rows: [], r"column time_s, .* is missing"),
        (gap, r"row 41, time_s: a gap of 21 s; expected at most 5 s"),
        (swap_velocities, r"velocities differ from the positions' derivative by"),
    ],
)
def test_mistake_is_named(tmp_path: Path, mistake: Callable[[Rows], Rows], message: str) -> None:
    path = write_drive(tmp_path, mistake(make_drive()))
    with pytest.raises(HrgError, match=message) as caught:
        read_drive(path)
    assert str(caught.value).startswith(str(path))
    assert "\n" not in str(caught.value)


def test_byte_order_mark_is_no_column(tmp_path: Path) -> None:
    path = write_drive(tmp_path, make_drive())
    path.write_text("\ufeff" + path.read_text())
    assert len(read_drive(path).time) == 121


def test_missing_and_broken_files(tmp_path: Path) -> None:
    with pytest.raises(HrgError, match="No such file"):
        read_drive(tmp_path / "nowhere.csv")
    (tmp_path / "broken.gz").write_bytes(b"\x1f\x8bnonsense")
    with pytest.raises(HrgError, match="no whole gzipped data"):
        read_drive(tmp_path / "broken.gz")


def test_drive_that_would_pass_the_pole_is_refused(tmp_path: Path) -> None:
    """North at 10 m/s from 45 deg: 150 h would end beyond 89 deg."""
    drive = read_drive(write_drive(tmp_path, make_drive()))
    with pytest.raises(HrgError, match="leaves latitudes -89 to 89"):
        repeat_drive(drive, 150 * 3600.0, 320.0)


@pytest.mark.parametrize(("duration", "still"), [(0.0, 0.0), (np.inf, 0.0), (60.0, -1.0)])
def test_times_that_are_no_durations_are_refused(
    tmp_path: Path, duration: float, still: float
) -> None:
    drive = read_drive(write_drive(tmp_path, make_drive()))
    with pytest.raises(TrajectoryError, match=r"s at rest and .* s after, expected 0 or more"):
        repeat_drive(drive, duration, still)


@pytest.fixture(scope="module")
def city() -> Drive:
    """A car in city traffic, 21 min at 1 Hz; `HRG_REAL` says where recorded data are."""
    path = find_recording("turin_drive.csv.gz")
    return read_drive(path)


def spline_drive(drive: Drive, rows: slice) -> Trajectory:
    return Trajectory(
        "part", drive.time[rows], np.hstack([drive.position[rows], drive.euler[rows]])
    )


def test_recorded_velocity_is_the_splines(city: Drive) -> None:
    """0.10, 0.07 and 0.05 m/s rms apart; the record's own scatter, as far as the next test tells:
    down, positions 2 s apart predict withheld heights to 13 mm, but no velocity below 0.05 m/s."""
    difference = spline_drive(city, slice(None)).velocity(city.time) - city.velocity
    rms = np.sqrt(np.mean(difference**2, axis=0))
    assert np.all(rms < [0.11, 0.08, 0.06])


def test_withheld_rows_are_predicted(city: Drive) -> None:
    """From every other row: twice the interval of the drive as it is flown."""
    odd = slice(1, -1, 2)
    spline = spline_drive(city, slice(None, None, 2))
    error = position_error(spline.position(city.time[odd]), city.position[odd])
    assert np.all(np.sqrt(np.mean(error**2, axis=0)) < [0.1, 0.1, 0.02])


def test_recorded_drive_stays_a_cars(city: Drive) -> None:
    """Over 2 h: neither attitude at 1 Hz nor joints make motion that the rows don't have.

    Largest change of a recorded velocity within a second: 3.3 m/s; of yaw: 35 deg.
    """
    path = repeat_drive(city, 7200.0, 320.0)
    time = np.arange(0.0, 7200.0, 0.1)
    omega, force = path.rate_and_force(time)
    assert np.all(np.max(np.abs(omega), axis=0) < np.deg2rad([4.5, 4.5, 40]))
    assert np.all(np.max(np.abs(force[:, :2]), axis=0) < 4.0)
    assert np.max(np.linalg.norm(path.velocity(time), axis=1)) < 20.5
    recorded = np.linalg.norm(city.velocity, axis=1)
    assert np.max(recorded) == pytest.approx(20.1, abs=0.1)


def test_a_drive_that_begins_at_rest_begins_at_time_zero() -> None:
    drive = BENDS["from rest to rest, about"]
    path = repeat_drive(drive, 60.0, 10.0)
    apart = path.position(drive.time) - drive.position
    assert np.max(np.abs(apart)) < 1e-12
    assert path.remark == ""


def test_what_is_not_as_recorded_is_said() -> None:
    path = repeat_drive(BENDS["round a corner"], 100.0, 10.0)
    joint = "it is in motion at its first row, so 20 s lead to it from rest"
    assert path.remark == f"bend: {joint}; it lasts 60 s and is repeated"
