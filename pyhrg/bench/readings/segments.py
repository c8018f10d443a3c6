"""Means over segments of a log while the table rests: the data points of every bias test."""

import math
from collections.abc import Iterator
from dataclasses import dataclass
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from pyhrg.bench.outcome import BenchError
from pyhrg.common.site import EARTH_RATE
from pyhrg.common.units import DEG
from pyhrg.records import Log

Array = NDArray[np.float64]

SEGMENT = 100.0
"""Averaging time of one data point, s (paper 4.1, item 3)."""
SAME_POSITION = 1 * DEG
"""A pattern that was moved by less, Earth's rate during a gap included, is where it was, rad."""
COLUMNS = ("table_angle", "axis_up", "virtual_rotation", "drive_on", "gyro_angle", "wave_angle")
"""Of a log, that a segment needs."""
WARM_UP = 30.0
"""Time from power-on to the first data point, s: the loops' transient lasts about one."""
AT_REST = 1e-3 * DEG
"""The table rests while it turns less than this in a row, rad."""


@dataclass(frozen=True)
class Segments:
    """Data points of one power-on, each (n,).

    rate: output rate less Earth's rate on the input axis, rad/s.
    pattern_angle, table_angle: means over the segment, rad.
    dwell: number of the position that the segment lies in; a gap doesn't make two of one.
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
        """How many positions hold a segment."""
        return len(np.unique(self.dwell))


def rests(log: Log, settle: float) -> list[slice]:
    """Rows of each stretch with the table at rest, drive on, no virtual rotation and no gap, from
    `settle` seconds after it began; the first row is the reading at which it begins."""
    turned = np.abs(np.diff(log.table_angle, prepend=log.table_angle[:1]))
    quiet = (turned < AT_REST) & (log.virtual_rotation == 0.0) & (log.drive_on > 0.5)
    found = []
    for stretch in log.stretches(*COLUMNS):
        rows = np.arange(len(quiet))[stretch]
        broken = np.flatnonzero(~quiet[rows])
        bounds = [-1, *broken.tolist(), len(rows)]
        for before, after in pairwise(bounds):
            first = max(before, 0) + math.ceil(settle / log.interval - 1e-9)
            if after > first + 1:
                found.append(slice(int(rows[first]), int(rows[after - 1]) + 1))
    return found


def segment_means(
    log: Log, latitude: float, settle: float, length: float = SEGMENT, warm_up: float = 0.0
) -> Segments:
    """Means of whole segments within the rests of a log.

    Args:
        log: one power-on.
        latitude: of the site, rad.
        settle: left out at the beginning of each rest, s.
        length: of a segment, s.
        warm_up: left out after power-on, s.

    Raises:
        BenchError: no rest is as long as a segment.
        LogError: a column that it needs has no value.
    """
    rows = round(length / log.interval)
    points: list[tuple[float, ...]] = []
    longest = 0.0
    late = int(np.searchsorted(log.time, warm_up - 1e-9))
    for number, rest in _numbered(rests(log, settle), log.wave_angle):
        first = max(rest.start, late)
        longest = max(longest, (rest.stop - first - 1) * log.interval)
        for begin in range(first, rest.stop - rows, rows):
            points.append((*_mean(log, latitude, begin, begin + rows), number))
    if not points:
        raise BenchError(
            f"{log.source}: no rest of the table holds a segment of {length:g} s after {settle:g} s"
            f" of settling; the longest has {longest:g} s"
        )
    rate, pattern, table, time, dwell = np.array(points).T
    return Segments(rate, pattern, table, dwell.astype(np.int64), time)


def _numbered(found: list[slice], wave_angle: Array) -> Iterator[tuple[int, slice]]:
    """Rests with the number of the position that each is at."""
    number, left_at = -1, math.inf
    for rest in found:
        number += abs(wave_angle[rest.start] - left_at) > SAME_POSITION
        left_at = wave_angle[rest.stop - 1]
        yield number, rest


def _mean(log: Log, latitude: float, begin: int, end: int) -> tuple[float, ...]:
    """Rate, pattern angle, table angle and time of the rows after `begin` up to `end`."""
    span = log.time[end] - log.time[begin]
    earth = EARTH_RATE * math.sin(latitude) * np.mean(log.axis_up[begin + 1 : end + 1])
    rate = (log.gyro_angle[end] - log.gyro_angle[begin]) / span - earth
    part = slice(begin, end + 1)
    pattern, table, time = (
        float(np.mean(values[part])) for values in (log.wave_angle, log.table_angle, log.time)
    )
    return float(rate), pattern, table, time
