"""What the command line names: IMUs, recorded logs, and their truth."""

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from ins_eval.cli.flight_options.place import Place
from ins_eval.common.state import Track, position_error
from ins_eval.flights.log_flight import Reference, at_rest
from ins_eval.imu import recorded, specification
from ins_eval.imu.gyros import FmuGyros
from ins_eval.imu.imu import Imu
from ins_eval.imu.recorded import RecordedImu
from ins_eval.trajectories import recorded_drive
from ins_eval.trajectories.trajectory import Knots, Trajectory
from pyhrg.common.errors import HrgError

Array = NDArray[np.float64]

NONE, REST = "none", "rest"
"""References of a log: no truth, or a vehicle that stood all the time."""
FARTHEST = 1000.0
"""Beginning of a drive from the place that a log states, m: farther, it is another drive's."""


def is_log(name: str) -> bool:
    """Whether it names a recorded log: any file that is not an IMU's TOML."""
    return Path(name).suffix not in ("", ".toml")


def has_truth(reference: str | None) -> bool:
    """Whether this reference of a log is one."""
    return reference not in (None, NONE)


def imu(name: str, rate: int | None) -> Imu:
    """A ready IMU or one from a file, at its own rate or another, Hz.

    Raises:
        SpecificationError: none of them, or a file that is wrong.
        HrgError: whole-angle gyros that can't be read at this rate.
    """
    found = specification.imu(name)
    if rate is not None:
        found = replace(found, interval=1 / rate)
    if isinstance(found.gyros, FmuGyros):
        ticks = found.interval / found.gyros.device.control_period
        if round(ticks) < 1 or abs(ticks - round(ticks)) > 1e-6:
            period = f"{found.gyros.device.control_period:g} s"
            raise HrgError(
                f"{name}: found increments over {found.interval:g} s; "
                f"expected a multiple of the gyros' control period, {period}"
            )
    return found


def log(path: Path, place: Place) -> tuple[RecordedImu, Array]:
    """A recorded log, and (3,) latitude, longitude (rad), height (m) that it was recorded at.

    Raises:
        LogError: an unreadable file, or one with something in it that can't be.
        HrgError: neither the log nor the options say where.
    """
    record = recorded.read(path)
    if place.latitude_deg is None:
        if record.position is None:
            raise HrgError(f"{path}: doesn't say where it was recorded; expected --latitude-deg")
        return record, record.position
    position = [np.deg2rad(place.latitude_deg), np.deg2rad(place.longitude_deg), place.height_m]
    return record, np.array(position)


def reference(name: str, position: Array, first: float, last: float) -> Reference | None:
    """The truth of a log.

    Args:
        name: `NONE`, `REST`, or a recorded drive whose first row is at the log's beginning.
        position: (3,) of the log.
        first: of the log, s, counted from time 0: negative.
        last: of the log, s.

    Raises:
        TrajectoryError: an unreadable drive, or one that is wrong.
        HrgError: a drive that is shorter than the log, or begins elsewhere.
    """
    if name == NONE:
        return None
    if name == REST:
        return at_rest(position)
    drive = recorded_drive.read(Path(name))
    if drive.time[-1] < last - first - 1e-6:
        raise HrgError(
            f"{name}: lasts {drive.time[-1]:g} s; expected all of the log, {last - first:g} s"
        )
    north, east, _ = position_error(drive.position[0], position)
    apart = float(np.hypot(north, east))
    if apart > FARTHEST:
        raise HrgError(
            f"{name}: begins {apart / 1000:.4g} km from where the log was recorded; expected "
            f"at most {FARTHEST / 1000:g} km"
        )
    return _by_spline(drive, first)


def _by_spline(drive: recorded_drive.Drive, first: float) -> Callable[[Array], Track]:
    knots = Knots(drive.time + first, *drive.position.T, *drive.euler.T)
    return Trajectory(drive.name, knots).track
