"""Mean rates over parts of a log at rest: the data points of the bias tests (paper 4.1)."""

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, fields
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from pyhrg.bench.outcome import BenchError
from pyhrg.common.arrays import Array, Mask
from pyhrg.common.site import Site
from pyhrg.common.units import DEG
from pyhrg.records import Log

SEGMENT = 100.0
"""Averaging time of one data point, s (paper 4.1, item 3)."""
SAME_POSITION = 1 * DEG
"""Largest change of pattern angle between two rests, rad, at which they are one position; Earth's
rate moves the pattern less than this during a gap."""
COLUMNS = ("table_angle", "axis_up", "virtual_rotation", "drive_on", "gyro_angle", "wave_angle")
"""Columns of a log that a rest or a turn must have."""
FORCES = ("acceleration_x", "acceleration_y", "acceleration_z")
"""Columns of the specific force."""
COMMAND_JUMP = 0.5
"""Change of a specific force from row to row, m/s2, above which it is a new command."""
WARM_UP = 30.0
"""Time from power-on to the first data point, s; the loops' transient lasts about 1 s."""
AT_REST = 1e-3 * DEG
"""Largest turn of the table within a row, rad, at which it rests."""


@dataclass(frozen=True)
class Points:
    """n data points; arrays are (n,) except the specific force.

    Attributes:
        rate: mean output rate less Earth's rate on the input axis, rad/s.
        pattern_angle, table_angle: means, rad.
        acceleration: (n, 3) mean specific force, m/s2.
        time: middle of the part, since power-on, s.
        duration: duration of the part, s.
        first, last: rows of the log between whose angle readings the rate is taken.
        dwell: number of the dwell or position in the log.
    """

    rate: Array
    pattern_angle: Array
    table_angle: Array
    acceleration: Array
    time: Array
    duration: Array
    first: NDArray[np.int64]
    last: NDArray[np.int64]
    dwell: NDArray[np.int64]

    def __len__(self) -> int:
        return len(self.rate)

    def part(self, chosen: Mask | NDArray[np.int64]) -> "Points":
        """The points that a mask (n,) or their numbers choose."""
        return Points(*(getattr(self, f.name)[chosen] for f in fields(self)))

    @property
    def dwells(self) -> int:
        """Number of dwells or positions that have a point."""
        return len(np.unique(self.dwell))


def join_points(parts: Sequence[Points]) -> Points:
    """Points of several logs, one after the other; their row and dwell numbers don't change."""
    return Points(*(np.concatenate([getattr(p, f.name) for p in parts]) for f in fields(Points)))


def split_rows(part: slice, broken: Mask) -> Iterator[tuple[int, int]]:
    """Parts of rows, first and one after the last, each of which begins where the mask (n,) of the
    n rows is true, the first at their beginning."""
    inside = part.start + np.flatnonzero(broken)
    return pairwise([part.start, *inside.tolist(), part.stop])


def find_rests(log: Log, settle: float) -> list[slice]:
    """Rows of each stretch without gap, with the table at rest, the drive on and no virtual
    rotation, from `settle` seconds after its beginning. The first row gives the reading at which it
    begins."""
    turned = np.abs(np.diff(log.table_angle, prepend=log.table_angle[:1]))
    quiet = (turned < AT_REST) & (log.virtual_rotation == 0.0) & log.is_driven
    skipped = math.ceil(settle / log.interval - 1e-9)
    return [
        slice(before + skipped, after)
        for stretch in log.stretches(*COLUMNS)
        for before, after in split_rows(stretch, ~quiet[stretch])
        if after > before + skipped + 1
    ]


def read_segments(
    log: Log, site: Site, settle: float, length: float = SEGMENT, warm_up: float = WARM_UP
) -> Points:
    """Data points of a log: means over whole segments of `length` seconds within its rests.

    `settle` seconds at the beginning of each rest and `warm_up` seconds after power-on are not
    used. Rests are numbered by position; a gap in the log doesn't begin another.
    """
    rows = round(length / log.interval)
    late = int(np.searchsorted(log.time, warm_up - 1e-9))
    points = []
    number, last_angle = -1, math.inf
    for rest in find_rests(log, settle):
        number += abs(log.wave_angle[rest.start] - last_angle) > SAME_POSITION
        last_angle = log.wave_angle[rest.stop - 1]
        first = max(rest.start, late)
        points += [
            _read_point(log, site, begin, begin + rows, number)
            for begin in range(first, rest.stop - rows, rows)
        ]
    if not points:
        longest = max((rest.stop - rest.start for rest in find_rests(log, 0.0)), default=0)
        raise BenchError(
            f"{log.source}: no rest of the table holds a segment of {length:g} s after {settle:g} s"
            f" of settling and {warm_up:g} s from power-on; the longest rest lasts "
            f"{longest * log.interval:.6g} s"
        )
    return Points(*map(np.array, zip(*points, strict=True)))


def read_points(
    log: Log,
    site: Site,
    settle: float,
    warm_up: float = 0.0,
    held: Sequence[str] = FORCES,
) -> Points:
    """Data points of a log: each dwell is divided into equal parts of `SEGMENT` or more, as many as
    there can be. Neighbours share no angle reading, so that their noises are independent.

    `settle` seconds at the beginning of each dwell and `warm_up` seconds after power-on are not
    used; jumps of the columns `held` end a dwell.
    """
    log.require("axis_up", "gyro_angle", "wave_angle", "table_angle", *FORCES)
    points, longest = [], 0.0
    for number, dwell in enumerate(_find_dwells(log, settle, warm_up, held)):
        rows = dwell.stop - dwell.start
        longest = max(longest, (rows - 1) * log.interval)
        parts = math.floor((rows * log.interval) / (SEGMENT + log.interval) + 1e-9)
        size = rows // max(parts, 1)
        points += [
            _read_point(log, site, begin, begin + size - 1, number)
            for begin in range(dwell.start, dwell.start + parts * size, size)
        ]
    if not points:
        raise BenchError(
            f"{log.source}: nothing rests for {SEGMENT:g} s after {settle:g} s of settling; the "
            f"longest dwell has {longest:g} s"
        )
    return Points(*map(np.array, zip(*points, strict=True)))


def _find_dwells(log: Log, settle: float, warm_up: float, held: Sequence[str]) -> Iterator[slice]:
    """Rows of each stretch in which the table rests and no column of `held` jumps."""
    late = int(np.searchsorted(log.time, log.time[0] + warm_up - 1e-9))
    skipped = math.ceil(settle / log.interval - 1e-9)
    jumps = np.zeros(len(log.time), dtype=bool)
    for name in held:
        values = getattr(log, name)
        jumps |= np.abs(np.diff(values, prepend=values[:1])) > COMMAND_JUMP
    for rest in find_rests(log, 0.0):
        for begin, end in split_rows(rest, jumps[rest]):
            first = max(begin + skipped, late)
            if end > first + 1:
                yield slice(first, end)


def _read_point(log: Log, site: Site, first: int, last: int, dwell: int) -> tuple[object, ...]:
    whole, after = slice(first, last + 1), slice(first + 1, last + 1)
    swept, span = log.gyro_angle[last] - log.gyro_angle[first], log.time[last] - log.time[first]
    return (
        swept / span - site.vertical_rate * _average(log.axis_up[after]),
        _average(log.wave_angle[whole]),
        _average(log.table_angle[whole]),
        [_average(getattr(log, name)[after]) for name in FORCES],
        (log.time[first] + log.time[last]) / 2,
        span,
        first,
        last,
        dwell,
    )


def _average(values: Array) -> float:
    """The mean as `np.mean` gives it, which takes several times as long for so few values."""
    return float(np.add.reduce(values)) / len(values)
