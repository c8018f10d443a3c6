"""Logs in the text format of KF-GINS (Wuhan University): no header, columns in white space."""

from pyhrg.records.imu.log import ROTATION, TIME, VELOCITY, RecordedImu, parse_numbers
from pyhrg.records.imu.table_log import MAX_INTERVAL, build_log

COLUMNS = (TIME, *ROTATION.columns, *VELOCITY.columns)
"""Seconds of the GNSS week at the end of the interval, increments along x forward, y right, z down;
further columns, such as an odometer's, are ignored."""


def is_kf_gins(lines: list[str]) -> bool:
    """Whether the first two lines of a file are numbers of this format, with time increasing."""
    try:
        first, second = ([float(field) for field in line.split()] for line in lines[:2])
    except ValueError:
        return False
    return min(len(first), len(second)) >= len(COLUMNS) and 0 < second[0] - first[0] <= MAX_INTERVAL


def read_kf_gins(source: str, lines: list[str], trusted: bool = False) -> RecordedImu:
    """The log of a file's lines; for `trusted` see `read_imu_log`."""
    places = range(len(COLUMNS)) if len(lines[0].split()) > len(COLUMNS) else None
    values = parse_numbers(source, lines, 1, COLUMNS, places=places)
    return build_log(source, (ROTATION, VELOCITY), values, range(1, len(values) + 1), trusted)
