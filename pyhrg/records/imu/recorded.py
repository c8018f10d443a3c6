"""Any log of an IMU that is known, told by what is in the file."""

from pathlib import Path

from pyhrg.records.imu import psins
from pyhrg.records.imu.log import LogError, RecordedImu, content, decoded
from pyhrg.records.imu.table_log import PARQUET, read_csv, read_parquet, write

__all__ = ["LogError", "RecordedImu", "read", "write"]


def read(path: Path, trusted: bool = False) -> RecordedImu:
    """The log in a file: PSINS text, CSV or Parquet with the columns of `columns`, gzipped or not.

    Args:
        path: the file.
        trusted: whether units and axes are taken as stated though gravity or Earth's rate speak
            against them.

    Raises:
        LogError: unreadable or cut off; a column that is missing or stands there twice; a row with
            too few or too many fields; a field that is no finite number; time that stands, runs
            back or steps unevenly; too few rows; another unit, axis or column than stated.
    """
    data = content(path)
    if data.startswith(PARQUET):
        return read_parquet(str(path), data, trusted)
    lines = decoded(str(path), data)
    if lines and lines[0].startswith(psins.COMMENT):
        return psins.read(str(path), lines, trusted)
    return read_csv(str(path), lines, trusted)
