"""Logs in the text format of PSINS (Yan Gongmin): counts, with axes right, forward, up."""

import numpy as np

from pyhrg.common.arrays import Array
from pyhrg.common.units import ARCSEC, DEG
from pyhrg.records.columns import LogError
from pyhrg.records.imu.log import Increments, Quantity, RecordedImu, make_field_error, parse_numbers
from pyhrg.records.imu.plausibility import Readings, check_plausibility

COMMENT = "%"
ATTITUDE = ("pitch0(deg)", "roll0(deg)", "yaw0(deg)", "VE0(m/s)", "VN0(m/s)", "VU0(m/s)")
PLACE = (
    "latitude0(deg)",
    "longitude0(deg)",
    "height0(m)",
    "t0(s)",
    "sampling-interval(ms)",
    "g(m/s^2)",
)
SCALES = ("gf_x", "gf_y", "gf_z", "af_x", "af_y", "af_z")
COUNTS = ("g_x", "g_y", "g_z", "a_x", "a_y", "a_z")
KINDS = (Quantity("g", "", 1.0, True), Quantity("a", "", 1.0, True))
RANGES = {
    "latitude0(deg)": (-90.0, 90.0),
    "longitude0(deg)": (-360.0, 360.0),
    "height0(m)": (-1e4, 1e5),
    "sampling-interval(ms)": (0.1, 1000.0),
    "g(m/s^2)": (9.7, 9.9),
    **dict.fromkeys(SCALES, (1e-6, 1e6)),
}
FORWARD_RIGHT_DOWN = np.array([[0.0, 1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, -1.0]])
"""Rotation matrix from axes right, forward, up to body axes."""


def read_psins(source: str, lines: list[str], trusted: bool = False) -> RecordedImu:
    """The log of a file's lines; for `trusted` see `read_imu_log`.

    The file has comments, attitude (yaw counter-clockwise from north), place and interval, scale
    factors (arcsec and ug s per count), then the counts of each interval.
    """
    rows = [row for row, line in enumerate(lines) if line.strip() and line[0] != COMMENT]
    if len(rows) < 4:
        raise LogError(f"{source}: found {len(rows)} rows, expected three of header and counts")
    attitude, place, scales = (
        _read_header(source, lines[row], row + 1, names)
        for row, names in zip(rows, (ATTITUDE, PLACE, SCALES), strict=False)
    )
    pitch, roll, yaw = DEG * attitude[:3]
    latitude, longitude, height, start, interval_ms, gravity = place
    counts = parse_numbers(source, lines[rows[3] :], rows[3] + 1, COUNTS)
    units = scales * np.repeat([ARCSEC, 1e-6 * gravity], 3)
    rotation, velocity = (x @ FORWARD_RIGHT_DOWN.T for x in np.split(counts * units, 2, axis=1))
    interval = 1e-3 * interval_ms
    if not trusted:
        check_plausibility(
            Readings(source, interval, *KINDS, rotation / interval, velocity / interval, z="up")
        )
    return RecordedImu(
        Increments(interval, rotation, velocity, start),
        np.array([DEG * latitude, DEG * longitude, height]),
        np.array([roll, pitch, -yaw]),
        source,
    )


def _read_header(source: str, line: str, row: int, names: tuple[str, ...]) -> Array:
    values = parse_numbers(source, [line], row, names, least=1)[0]
    for name, value in zip(names, values, strict=True):
        low, high = RANGES.get(name, (-np.inf, np.inf))
        if not low <= value <= high:
            raise make_field_error(source, row, name, f"{value:g}", f"{low:g} to {high:g}")
    return values
