"""Any log of an IMU that is known, told by what is in the file."""

from pathlib import Path

from ins_eval.imu import psins
from ins_eval.imu.log import LogError, RecordedImu, content, decoded

__all__ = ["LogError", "RecordedImu", "read"]


def read(path: Path) -> RecordedImu:
    """The log in a file, gzipped or not.

    Raises:
        LogError: unreadable, in no known format, or with something in it that can't be.
    """
    lines = decoded(str(path), content(path))
    if lines and lines[0].startswith(psins.COMMENT):
        return psins.read(str(path), lines)
    raise LogError(f"{path}: found no known format, expected a PSINS log")
