"""Recorded drives: read from CSV, checked, and repeated with smooth joints to any duration.

Those that are not part of the package, because their licence forbids it, stand in a folder named by
the environment variable `HRG_REAL`; without it, it is `shared/real` beside the folder of the
project.
"""

import math
import os
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from scipy.integrate import cumulative_simpson

from ins_eval.common.state import displace
from ins_eval.trajectories.errors import check_durations
from ins_eval.trajectories.trajectory import Trajectory
from pyhrg.common.arrays import Array
from pyhrg.common.errors import HrgError, quote
from pyhrg.common.reading.documents import parse_csv
from pyhrg.common.reading.files import decode, read_unpacked
from pyhrg.common.reading.limits import LARGEST_NUMBER

DEFAULT_FOLDER = Path(__file__).parents[3] / "shared" / "real"


def find_recording(name: str) -> Path | None:
    """Return the path of a recorded drive by its file's name; None if the file does not exist."""
    path = Path(os.environ.get("HRG_REAL", DEFAULT_FOLDER)) / name
    return path if path.is_file() else None


LIMITS = {
    "time_s": (-LARGEST_NUMBER, LARGEST_NUMBER),
    "latitude_deg": (-89.0, 89.0),
    "longitude_deg": (-360.0, 360.0),
    "height_m": (-1000.0, 50_000.0),
    "velocity_north_m_s": (-1000.0, 1000.0),
    "velocity_east_m_s": (-1000.0, 1000.0),
    "velocity_down_m_s": (-1000.0, 1000.0),
    "roll_deg": (-360.0, 360.0),
    "pitch_deg": (-80.0, 80.0),
    "yaw_deg": (-720.0, 720.0),
}
"""Columns of the file, others are ignored, and the range of each. Chosen."""
COLUMNS = tuple(LIMITS)
EULER = COLUMNS[-3:]
MIN_ROWS = 10
"""Smallest number of rows. Chosen."""
MIN_DURATION = 10.0
"""Shortest duration of a drive, s. Chosen."""
MAX_TURN_RATE = 10.0
"""Largest Euler rate, rad/s. Chosen: no vehicle turns faster, so the angles must be wrong."""
MAX_GAP = 5.0
"""Longest time between rows that is interpolated, s. Chosen."""
MAX_VELOCITY_DIFFERENCE = 1.0
"""Largest rms difference of recorded velocity and the derivative of position, m/s. Chosen."""
JOINT_DURATION = 20
"""Shortest time from the end of one repetition to the start of the next, s. Chosen."""
JOINT_RADIUS = 6.0
"""Radius of the bend of a vehicle that must turn where it stands, m. Chosen: that of a car."""
MAX_JOINT_ACCELERATION = 4.0
"""Largest lateral acceleration of a joint, m/s^2, which lasts longer instead. Chosen: 0.4 g."""
SUBSTEPS = 20
"""Steps a second of the joint's path. Chosen."""
REST_SPEED = 0.05
"""Speed below which a drive begins at rest, m/s. Chosen: noise of recorded velocities."""
MARGIN = 10.0
"""Time after its end that a trajectory goes on, s. Chosen."""


@dataclass(frozen=True)
class Drive:
    """A recorded drive in SI and rad; `time` (n,) begins at 0."""

    name: str
    time: Array
    position: Array
    """(n, 3) latitude, longitude, rad, height, m."""
    velocity: Array
    """(n, 3) north, east, down, m/s."""
    euler: Array
    """(n, 3) roll, pitch, yaw, rad, without jumps of a full turn."""


def read_drive(path: Path) -> Drive:
    """Read a drive from a CSV file, gzipped or not.

    Raises:
        HrgError: an unreadable file; a missing column; a value that is not a number or out of
            range; time that does not increase; a long gap; too few rows; angles that turn too fast;
            velocities that contradict the positions.
    """
    time, latitude, longitude, height, *others = np.array(_read_rows(path)).T
    _check_time(path, time)
    drive = Drive(
        name=path.name,
        time=time - time[0],
        position=np.stack(
            [np.deg2rad(latitude), np.unwrap(np.deg2rad(longitude)), height], axis=-1
        ),
        velocity=np.stack(others[:3], axis=-1),
        euler=np.stack([np.unwrap(np.deg2rad(angle)) for angle in others[3:]], axis=-1),
    )
    _check_turns(path, drive)
    _check_velocity(path, drive)
    return drive


def repeat_drive(drive: Drive, duration: float, still: float = 0.0) -> Trajectory:
    """Build a trajectory that stands still for `still` s and then repeats the drive for `duration`
    s.

    A drive that begins at rest begins at time 0; to another a joint leads from rest. Each
    repetition begins where the one before ended. Joints change velocity and attitude smoothly. The
    trajectory's remark says what is not as recorded.
    """
    check_durations(drive.name, duration, still)
    standing = np.arange(-still, 0.5, 1.0)
    time = [standing]
    position = [np.tile(drive.position[0], (len(standing), 1))]
    euler = [np.tile(drive.euler[0], (len(standing), 1))]
    velocity = np.zeros(3)
    begins: list[float] = []
    while time[-1][-1] < duration + MARGIN:
        pieces = [_join(drive, position[-1][-1], velocity, euler[-1][-1]), None]
        if not begins and np.linalg.norm(drive.velocity[0]) < REST_SPEED:
            del pieces[0]
        for piece in pieces:
            if piece is None:
                begins.append(float(time[-1][-1]))
            t, p, e = piece or _continue_drive(drive, position[-1][-1], euler[-1][-1])
            time.append(time[-1][-1] + t)
            position.append(p)
            euler.append(e)
        velocity = drive.velocity[-1]
    p, e = np.concatenate(position), np.concatenate(euler)
    low, high = np.deg2rad(LIMITS["latitude_deg"])
    if np.any((p[:, 0] < low) | (p[:, 0] > high)):
        raise HrgError(
            f"{drive.name}: repeated for {duration / 3600:g} h it leaves latitudes "
            f"{LIMITS['latitude_deg'][0]:g} to {LIMITS['latitude_deg'][1]:g}; fly it for less"
        )
    remark = _remark(drive, begins, duration)
    return Trajectory(drive.name, np.concatenate(time), np.hstack([p, e]), remark=remark)


def _remark(drive: Drive, begins: Sequence[float], duration: float) -> str:
    """What of a trajectory is not as recorded; begins: times at which the repetitions begin, s."""
    said = []
    if begins[0] > 0:
        said.append(f"it is in motion at its first row, so {begins[0]:g} s lead to it from rest")
    if begins[0] + drive.time[-1] < duration:
        said.append(f"it lasts {drive.time[-1]:g} s and is repeated")
    return f"{drive.name}: {'; '.join(said)}" if said else ""


def _join(
    drive: Drive, position: Array, velocity: Array, euler: Array
) -> tuple[Array, Array, Array]:
    """Return a knot each second from a given state to the drive's first velocity and attitude.

    The velocity keeps its components along the vehicle, forward or backward, and the heading turns
    with distance driven. Sideslip goes smoothly from the one recorded at one end to the other's. A
    vehicle that would turn
    where it stands drives a bend of `JOINT_RADIUS`.
    """
    begin = _turn_to_vehicle(velocity, euler[2])
    end = _turn_to_vehicle(drive.velocity[0], drive.euler[0, 2])
    turn = np.remainder(drive.euler[0] - euler + math.pi, 2 * math.pi) - math.pi
    fastest = max(abs(begin[0]), abs(end[0])) * 1.5 * abs(turn[2])
    duration = max(JOINT_DURATION, math.ceil(fastest / MAX_JOINT_ACCELERATION))
    s = np.arange(0, duration * SUBSTEPS + 0.5) / (duration * SUBSTEPS)
    ramp, bell = s**2 * (3 - 2 * s), 6 * s * (1 - s)
    along = begin + (end - begin) * ramp[:, None]
    missing = 1.5 * JOINT_RADIUS * abs(turn[2]) - float(np.mean(abs(along[:, 0]) * bell)) * duration
    along[:, 0] += math.copysign(max(missing, 0.0) / (1.2 * duration), begin[0] + end[0]) * bell
    turned = cumulative_simpson(abs(along[:, 0]) * bell, x=s, initial=0.0)
    yaw = euler[2] + turn[2] * turned / max(turned[-1], 1e-12)
    cos, sin = np.cos(yaw), np.sin(yaw)
    north, east = along[:, 0] * cos - along[:, 1] * sin, along[:, 0] * sin + along[:, 1] * cos
    moving = np.stack([north, east, along[:, 2]], axis=-1)
    moved = cumulative_simpson(moving, dx=1 / SUBSTEPS, axis=0, initial=0.0)
    each = slice(SUBSTEPS, None, SUBSTEPS)
    angles = euler + turn * ramp[:, None]
    angles[:, 2] = yaw
    return s[each] * duration, displace(position, moved[each]), angles[each]


def _turn_to_vehicle(velocity: Array, yaw: float) -> Array:
    """Return a velocity (3,) north, east, down as forward, right, down."""
    cos, sin = math.cos(yaw), math.sin(yaw)
    north, east, down = velocity
    return np.array([north * cos + east * sin, east * cos - north * sin, down])


def _continue_drive(drive: Drive, position: Array, euler: Array) -> tuple[Array, Array, Array]:
    """Return the drive's rows after the first, shifted to follow a given position and attitude."""
    turns = np.round((euler - drive.euler[0]) / (2 * math.pi)) * 2 * math.pi
    moved = drive.position[1:] - drive.position[0]
    moved[:, 1] *= np.cos(drive.position[1:, 0]) / np.cos(position[0] + moved[:, 0])
    return (
        drive.time[1:],
        position + moved,
        drive.euler[1:] + turns,
    )


def _read_rows(path: Path) -> list[list[float]]:
    text = decode(path, read_unpacked(path))
    lines = parse_csv(path, text)
    _, names = next(lines, (1, []))
    header = [name.strip() for name in names]
    missing = [name for name in COLUMNS if name not in header]
    if missing:
        raise HrgError(f"{path}: column {', '.join(missing)} is missing; found {', '.join(header)}")
    if repeated := [name for name in COLUMNS if header.count(name) > 1]:
        raise HrgError(f"{path}: column {', '.join(repeated)} appears more than once")
    places = [header.index(name) for name in COLUMNS]
    rows = [_parse_row(path, number, row, places) for number, row in lines]
    if len(rows) < MIN_ROWS:
        raise HrgError(f"{path}: {len(rows)} rows; expected at least {MIN_ROWS}")
    return rows


def _parse_row(path: Path, line: int, row: list[str], places: list[int]) -> list[float]:
    values = []
    for name, place in zip(COLUMNS, places, strict=True):
        text = row[place] if place < len(row) else ""
        try:
            value = float(text)
        except ValueError:
            raise HrgError(f"{path}: row {line}, {name}: {quote(text)} is not a number") from None
        low, high = LIMITS[name]
        if not low <= value <= high:
            found = f"row {line}, {name}: {text}"
            raise HrgError(f"{path}: {found}; expected {low:g} to {high:g}")
        values.append(value)
    return values


def _check_time(path: Path, time: Array) -> None:
    steps = np.diff(time)
    if time[-1] - time[0] < MIN_DURATION and np.all(steps > 0):
        raise HrgError(
            f"{path}: time_s covers {time[-1] - time[0]:g} s; expected at least {MIN_DURATION:g} s"
        )
    if np.any(steps <= 0):
        row = int(np.argmax(steps <= 0)) + 1
        raise HrgError(
            f"{path}: row {row + 2}, time_s: {time[row]:g} after {time[row - 1]:g}; "
            "expected time to increase"
        )
    if np.any(steps > MAX_GAP):
        row = int(np.argmax(steps > MAX_GAP)) + 1
        raise HrgError(
            f"{path}: row {row + 2}, time_s: a gap of {steps[row - 1]:g} s; "
            f"expected at most {MAX_GAP:g} s"
        )


def _check_turns(path: Path, drive: Drive) -> None:
    rates = np.abs(np.diff(drive.euler, axis=0)) / np.diff(drive.time)[:, None]
    row, axis = np.unravel_index(np.argmax(rates), rates.shape)
    fastest = rates[row, axis]
    if fastest > MAX_TURN_RATE:
        raise HrgError(
            f"{path}: row {row + 3}, {EULER[axis]}: turns at {np.rad2deg(fastest):.0f} deg/s; "
            f"expected at most {np.rad2deg(MAX_TURN_RATE):.0f} deg/s"
        )


def _check_velocity(path: Path, drive: Drive) -> None:
    channels = np.hstack([drive.position, drive.euler])
    derived = Trajectory(drive.name, drive.time, channels).velocity(drive.time)
    difference = float(np.sqrt(np.mean(np.sum((derived - drive.velocity) ** 2, axis=1))))
    if difference > MAX_VELOCITY_DIFFERENCE:
        raise HrgError(
            f"{path}: velocities differ from the positions' derivative by {difference:.1f} m/s "
            f"rms; expected at most {MAX_VELOCITY_DIFFERENCE:g} m/s: are columns swapped, or units "
            "mixed?"
        )
