"""Reads a static record from the log of an IMU or of a bench test."""

from pathlib import Path

from pyhrg import records
from pyhrg.gap.static_record.record import StaticRecord, channel_from_increments, record_from_log
from pyhrg.gap.static_record.terms import ACCELEROMETER, GYRO
from pyhrg.records.imu import recorded
from pyhrg.records.table import read_bytes

AXES = ("x", "y", "z")
BENCH_COLUMN = b"gyro_angle_deg"
HEADER_BYTES = 4096
"""Bytes at the start of a file in which the header of a table is expected."""


def read_static_record(path: Path, trusted: bool = False) -> StaticRecord:
    """Read the log of an IMU (PSINS, CSV, Parquet: `pyhrg.records.imu`; body axes forward, right,
    down) or a bench log (`pyhrg.records`).

    Args:
        path: of the file.
        trusted: whether an IMU's units and axes are taken as stated, though gravity or Earth's
            rate in it contradict them.

    Raises:
        imu_records.log.LogError, records.LogError: the file can't be used.
        RecordError: it is too short, or a channel never changes.
    """
    if BENCH_COLUMN in read_bytes(path)[:HEADER_BYTES]:
        return record_from_log(records.read_log(path))
    imu = recorded.read_imu_log(path, trusted).increments
    channels = [
        channel_from_increments(f"{kind.name}_{axis}", kind, imu.interval, values)
        for kind, triad in ((GYRO, imu.rotation), (ACCELEROMETER, imu.velocity))
        for axis, values in zip(AXES, triad.T, strict=True)
    ]
    return StaticRecord(path.name, tuple(channels))
