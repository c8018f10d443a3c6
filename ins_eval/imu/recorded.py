"""The front door of recorded IMU logs."""

from pathlib import Path

from pyhrg.records.imu.log import RecordedImu
from pyhrg.records.imu.recorded import read_imu_log


def read_record(path: str | Path, trusted: bool = False) -> RecordedImu:
    """Read a recorded IMU log: PSINS text, CSV or Parquet, gzipped or not.

    Args:
        path: the file; the formats are in docs/imus.md.
        trusted: whether units and axes are taken as stated, even if gravity or Earth's rate
            contradict them.

    Raises:
        HrgError: an unreadable file, or one with wrong or contradictory content.
    """
    return read_imu_log(Path(path), trusted)
