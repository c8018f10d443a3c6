"""Means over segments of a log at rest: the data points of the bias tests (paper 4.1)."""

import math
from collections.abc import Iterator
from dataclasses import dataclass
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from pyhrg.bench.outcome import BenchError
from pyhrg.common.arrays import Array
from pyhrg.common.site import EARTH_RATE
from pyhrg.common.units import DEG
from pyhrg.records import Log

SEGMENT = 100.0
"""Averaging time of one data point, s (paper 4.1, item 3)."""
SAME_POSITION = 1 * DEG
"""Largest change of pattern angle between two rests, rad, at which they are one position; Earth's
rate moves the pattern less than this during a gap."""
COLUMNS = ("table_angle", "axis_up", "virtual_rotation", "drive_on", "gyro_angle", "wave_angle")
"""Columns of a log that a rest or a turn must have."""
WARM_UP = 30.0
"""Time from power-on to the first data point, s; the loops' transient lasts about 1 s."""
AT_REST = 1e-3 * DEG
"""Largest turn of the table within a row, rad, at which it rests."""


@dataclass(frozen=True)
class Segments:
    """n data points of one power-on; arrays are (n,).

    rate: mean output rate less Earth's rate on the input axis, rad/s.
    pattern_angle, table_angle: means over the segment, rad.
    dwell: number of the segment's position; a gap in the log doesn't begin another position.
    time: middle of the segment, s.
    """

    rate: Array
    pattern_angle: Array
    table_angle: Array
    dwell: NDArray[np.int64]
    time: Array

    def __len__(self) -> int:
        return len(self.rate)

    @property
    def dwells(self) -> int:
        """Number of positions that have a segment."""
        return len(np.unique(self.dwell))


def find_rests(log: Log, settle: float) -> list[slice]:
    """Rows of each stretch without gap, with the table at rest, the drive on and no virtual
    rotation, from `settle` seconds after its beginning. The first row gives the reading at which it
    begins."""
    turned = np.abs(np.diff(log.table_angle, prepend=log.table_angle[:1]))
    quiet = (turned < AT_REST) & (log.virtual_rotation == 0.0) & (log.drive_on > 0.5)
    stretches = []
    for stretch in log.stretches(*COLUMNS):
        rows = np.arange(len(quiet))[stretch]
        broken = np.flatnonzero(~quiet[rows])
        bounds = [-1, *broken.tolist(), len(rows)]
        for before, after in pairwise(bounds):
            first = max(before, 0) + math.ceil(settle / log.interval - 1e-9)
            if after > first + 1:
                stretches.append(slice(int(rows[first]), int(rows[after - 1]) + 1))
    return stretches


def read_segments(
    log: Log, latitude: float, settle: float, length: float = SEGMENT, warm_up: float = 0.0
) -> Segments:
    """Data points of a log: means over whole segments within its rests.

    `settle` seconds at the beginning of each rest and `warm_up` seconds after power-on are not
    used; a segment has `length` seconds.
    """
    rows = round(length / log.interval)
    points: list[tuple[float, ...]] = []
    longest = 0.0
    late = int(np.searchsorted(log.time, warm_up - 1e-9))
    for number, rest in _number(find_rests(log, settle), log.wave_angle):
        first = max(rest.start, late)
        longest = max(longest, (rest.stop - first - 1) * log.interval)
        for begin in range(first, rest.stop - rows, rows):
            points.append((*_read_segment(log, latitude, begin, begin + rows), number))
    if not points:
        raise BenchError(
            f"{log.source}: no rest of the table holds a segment of {length:g} s after {settle:g} s"
            f" of settling; the longest has {longest:g} s"
        )
    rate, pattern, table, time, dwell = np.array(points).T
    return Segments(rate, pattern, table, dwell.astype(np.int64), time)


def _number(rests: list[slice], wave_angle: Array) -> Iterator[tuple[int, slice]]:
    """Rests, each with the number of its position."""
    number, last_angle = -1, math.inf
    for rest in rests:
        number += abs(wave_angle[rest.start] - last_angle) > SAME_POSITION
        last_angle = wave_angle[rest.stop - 1]
        yield number, rest


def _read_segment(log: Log, latitude: float, begin: int, end: int) -> tuple[float, ...]:
    """Rate, pattern angle, table angle and time of the rows after `begin` up to `end`."""
    part = slice(begin, end + 1)
    pattern, table, time = (
        float(np.mean(values[part])) for values in (log.wave_angle, log.table_angle, log.time)
    )
    return read_mean_rate(log, latitude, begin, end), pattern, table, time


def read_mean_rate(log: Log, latitude: float, begin: int, end: int) -> float:
    """Mean output rate less Earth's rate on the input axis, rad/s, between two angle readings."""
    earth = EARTH_RATE * math.sin(latitude) * np.mean(log.axis_up[begin + 1 : end + 1])
    swept, span = log.gyro_angle[end] - log.gyro_angle[begin], log.time[end] - log.time[begin]
    return float(swept / span - earth)
