"""Reads what a user names: IMUs at a rate, recorded logs with their place, and a log's truth."""

import gzip
from dataclasses import replace
from pathlib import Path

import numpy as np

from ins_eval.common.state import position_error
from ins_eval.flights.log_flight import Reference, stand_still
from ins_eval.imu.gyros import FmuGyros
from ins_eval.imu.imu import Imu
from ins_eval.imu.specification import load_imu
from ins_eval.trajectories.recorded_drive import read_drive
from ins_eval.trajectories.trajectory import Trajectory
from pyhrg.common.arguments import check_number, check_whole_number
from pyhrg.common.arrays import Array
from pyhrg.common.errors import HrgError
from pyhrg.common.files import write_whole
from pyhrg.fmu import load_own_fmu
from pyhrg.records.imu.log import Increments, RecordedImu
from pyhrg.records.imu.recorded import read_imu_log
from pyhrg.records.imu.table_log import format_table


def read_record(path: str | Path, trusted: bool = False) -> RecordedImu:
    """Read a recorded IMU log in any format of docs/imus.md, gzipped or not.

    Args:
        path: the file.
        trusted: whether units and axes are taken as stated, even if gravity or Earth's rate
            contradict them.

    Raises:
        HrgError: an unreadable file, or one with wrong or contradictory content.
    """
    return read_imu_log(Path(path), trusted)


def write_record(increments: Increments, path: str | Path) -> None:
    """Write increments as an IMU log that `read_record` reads back to the same bits.

    Args:
        increments: those of an IMU (`Imu.measure`) or ideal ones (`Trajectory.increments`).
        path: a table of time and increments in SI (docs/imus.md): `.csv`, `.csv.gz` or `.parquet`.

    Raises:
        HrgError: the name has another ending.
        OSError: the file can't be written.
    """
    path = Path(path)
    packed = path.suffix == ".gz"
    data = format_table(increments, path.with_suffix("").suffix if packed else path.suffix)
    if data is None or (packed and not path.name.endswith(".csv.gz")):
        raise HrgError(f"{path}: found {path.suffix!r}, expected .csv, .csv.gz or .parquet")
    write_whole(path, gzip.compress(data, mtime=0) if packed else data)


NO_TRUTH, AT_REST = "none", "rest"
"""References of a log: no truth is known, or the vehicle stood all the time."""
MAX_START_DISTANCE = 1000.0
"""Distance of a drive's beginning from the place that a log states, m; a drive that begins farther
away is another one."""
HIGHEST_LATITUDE_DEG = 89.0


def load_imu_at_rate(imu: Imu | str, rate_hz: int | None, fmu: Path | str | None = None) -> Imu:
    """An IMU, a ready one or one from a file, at its own rate or another; its gyros simulated by
    `HRG` or a user's FMU."""
    name = imu.name if isinstance(imu, Imu) else imu
    loaded = imu if isinstance(imu, Imu) else load_imu(imu)
    if rate_hz is not None:
        loaded = replace(loaded, interval=1 / check_whole_number("rate_hz", rate_hz, 10, 2000))
    if isinstance(loaded.gyros, FmuGyros):
        try:
            loaded.gyros.check_interval(loaded.interval)
        except HrgError as error:
            raise HrgError(f"{name}: {error}") from error
    return loaded if fmu is None else put_into_fmu(loaded, Path(fmu))


def put_into_fmu(imu: Imu, file: Path) -> Imu:
    """An IMU whose gyros are simulated by a user's FMU in place of `HRG`.

    Raises:
        HrgError: gyros that no FMU simulates, no FMU, or one without sampled control loops.
    """
    if not isinstance(imu.gyros, FmuGyros):
        raise HrgError(
            f"{imu.name}: found gyros of stated errors, expected [gyros] device for the parameters "
            f"of {file.name}"
        )
    fmu = load_own_fmu(file)
    if not fmu.is_sampled:
        raise HrgError(f"{file}: found no sampled control loops, expected those of HRG")
    return replace(imu, name=f"{imu.name} in {file.name}", gyros=replace(imu.gyros, fmu=fmu))


def read_placed_record(
    path: Path, latitude_deg: float | None, longitude_deg: float, height_m: float
) -> tuple[RecordedImu, Array]:
    """A recorded log, and (3,) latitude, longitude (rad), height (m) of the place where it was
    recorded; without a latitude, the log itself must say it."""
    record = read_record(path)
    if latitude_deg is None:
        for name, value in (("longitude_deg", longitude_deg), ("height_m", height_m)):
            if value:
                raise HrgError(f"{name}: found {value:g}, expected latitude_deg as well")
        if record.position is None:
            raise HrgError(
                f"{path}: it doesn't say where it was recorded; expected the argument latitude_deg"
            )
        return record, record.position
    check_number("latitude_deg", latitude_deg, -HIGHEST_LATITUDE_DEG, HIGHEST_LATITUDE_DEG)
    check_number("longitude_deg", longitude_deg, -360, 360)
    check_number("height_m", height_m, -1000, 100_000)
    return record, np.array([np.deg2rad(latitude_deg), np.deg2rad(longitude_deg), height_m])


def find_reference(name: str, position: Array, first: float, last: float) -> Reference | None:
    """The truth of a log from time `first` to `last`, s; None where there is none.

    name: `NO_TRUTH`, `AT_REST`, or a recorded drive whose first row is at the beginning of the log.
    """
    if name == NO_TRUTH:
        return None
    if name == AT_REST:
        return stand_still(position)
    drive = read_drive(Path(name))
    if drive.time[-1] < last - first - 1e-6:
        raise HrgError(
            f"{name}: lasts {drive.time[-1]:g} s; expected all of the log, {last - first:g} s"
        )
    north, east, _ = position_error(drive.position[0], position)
    distance = float(np.hypot(north, east))
    if distance > MAX_START_DISTANCE:
        raise HrgError(
            f"{name}: begins {distance / 1000:.4g} km from where the log was recorded; expected "
            f"at most {MAX_START_DISTANCE / 1000:g} km"
        )
    channels = np.hstack([drive.position, drive.euler])
    return Trajectory(drive.name, drive.time + first, channels).track
