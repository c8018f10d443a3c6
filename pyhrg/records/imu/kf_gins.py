"""Logs in the text format of KF-GINS (Wuhan University): no header, columns in white space."""

from pyhrg.records.imu.log import ROTATION, TIME, VELOCITY, RecordedImu, parse_numbers
from pyhrg.records.imu.table_log import build_log

COLUMNS = (TIME, *ROTATION.columns, *VELOCITY.columns)
"""Seconds of the GNSS week at the end of the interval, increments along x forward, y right, z down;
further columns, such as an odometer's, are ignored."""


def is_kf_gins(line: str) -> bool:
    """Whether the first line of a file is one of this format."""
    fields = line.split()
    if len(fields) < len(COLUMNS):
        return False
    try:
        return all(isinstance(float(field), float) for field in fields)
    except ValueError:
        return False


def read_kf_gins(source: str, lines: list[str], trusted: bool = False) -> RecordedImu:
    """The log of a file's lines; for `trusted` see `read_imu_log`."""
    places = range(len(COLUMNS)) if len(lines[0].split()) > len(COLUMNS) else None
    values = parse_numbers(source, lines, 1, COLUMNS, places=places)
    return build_log(source, (ROTATION, VELOCITY), values, 1, trusted)
