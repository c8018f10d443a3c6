"""Files that hold a static record: logs of IMUs, and of bench tests."""

from pathlib import Path

from pyhrg import records
from pyhrg.gap.static_record.record import StaticRecord, of_increments, of_log
from pyhrg.gap.static_record.terms import ACCELEROMETER, GYRO
from pyhrg.records.imu import recorded
from pyhrg.records.imu.log import content

AXES = ("x", "y", "z")
BENCH_COLUMN = b"gyro_angle_deg"
HEADER = 4096
"""Bytes in which a table's header is looked for."""


def read(path: Path, trusted: bool = False) -> StaticRecord:
    """The record in a file: an IMU's (PSINS, CSV, Parquet: `pyhrg.records.imu`; body axes forward,
    right, down) or a bench log (`pyhrg.records`).

    Args:
        path: of the file.
        trusted: whether an IMU's units and axes are taken as stated though gravity or Earth's rate
            speak against them.

    Raises:
        imu_records.log.LogError, records.LogError: the file can't be used.
        RecordError: it is too short, or a channel never changes.
    """
    if BENCH_COLUMN in content(path)[:HEADER]:
        return of_log(records.read(path))
    imu = recorded.read(path, trusted).increments
    channels = [
        of_increments(f"{kind.name}_{axis}", kind, imu.interval, values)
        for kind, triad in ((GYRO, imu.rotation), (ACCELEROMETER, imu.velocity))
        for axis, values in zip(AXES, triad.T, strict=True)
    ]
    return StaticRecord(path.name, tuple(channels))
