"""Recorded IMU logs, with the place and the attitude that they state."""

from dataclasses import dataclass
from pathlib import Path

from ins_eval.common.arrays import Array
from ins_eval.common.rotation import mat_from_euler
from pyhrg.records.columns import LogError
from pyhrg.records.imu import recorded
from pyhrg.records.imu.increments import Increments
from pyhrg.records.imu.table_log import write_imu_log

__all__ = ["ImuRecord", "LogError", "read_record", "write_imu_log"]


@dataclass(frozen=True)
class ImuRecord:
    """A recorded log of an IMU.

    increments: body axes forward, right, down; position: (3,) latitude, longitude, rad, height, m,
    None if the log does not state it; mat_nb: (3, 3) attitude at the start as the log states it,
    which is coarse, or None; source: the file.
    """

    increments: Increments
    position: Array | None
    mat_nb: Array | None
    source: str


def read_record(path: str | Path, trusted: bool = False) -> ImuRecord:
    """Read a recorded IMU log: PSINS text, CSV or Parquet, gzipped or not.

    Args:
        path: the file; the formats are in docs/imus.md.
        trusted: whether units and axes are taken as stated, even if gravity or Earth's rate
            contradict them.

    Raises:
        LogError: an unreadable file, or one with wrong or contradictory content.
    """
    log = recorded.read_imu_log(Path(path), trusted)
    mat_nb = None if log.attitude is None else mat_from_euler(*log.attitude)
    return ImuRecord(log.increments, log.position, mat_nb, log.source)
