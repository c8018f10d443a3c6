"""Mean rates over parts of a log in which table and specific force are constant.

Neighbouring data points share no angle reading, so that their noises are independent.
"""

import math
from collections.abc import Sequence
from dataclasses import dataclass, fields
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from pyhrg.bench.outcome import BenchError
from pyhrg.bench.readings.segments import SEGMENT, find_rests, read_mean_rate
from pyhrg.common.arrays import Array
from pyhrg.records import Log

FORCES = ("acceleration_x", "acceleration_y", "acceleration_z")
"""Columns of the specific force."""
COMMAND_JUMP = 0.5
"""Change of a specific force from row to row, m/s2, above which it is a new command."""


@dataclass(frozen=True)
class Points:
    """n data points; arrays are (n,) except the specific force.

    rate: mean output rate less Earth's rate on the input axis, rad/s.
    pattern_angle: mean, rad.
    acceleration: (n, 3) mean specific force, m/s2.
    time: middle of the part, since power-on, s.
    duration: of the part, s.
    first, last: rows of the log between whose angle readings the rate is taken.
    dwell: number of the dwell in the log.
    """

    rate: Array
    pattern_angle: Array
    acceleration: Array
    time: Array
    duration: Array
    first: NDArray[np.int64]
    last: NDArray[np.int64]
    dwell: NDArray[np.int64]

    def __len__(self) -> int:
        return len(self.rate)

    def part(self, chosen: NDArray[np.bool_]) -> "Points":
        """The points that a mask (n,) chooses."""
        return Points(*(getattr(self, f.name)[chosen] for f in fields(self)))


def join_points(parts: Sequence[Points]) -> Points:
    """Points of several logs, one after the other; their row and dwell numbers don't change."""
    return Points(*(np.concatenate([getattr(p, f.name) for p in parts]) for f in fields(Points)))


def read_points(
    log: Log,
    latitude: float,
    settle: float,
    length: float = SEGMENT,
    warm_up: float = 0.0,
    held: Sequence[str] = FORCES,
) -> Points:
    """Data points of a log: each dwell is divided into equal parts, as many as `length` allows.

    `settle` seconds at the beginning of each dwell and `warm_up` seconds after power-on are not
    used; jumps of the columns `held` end a dwell.
    """
    log.require("axis_up", "gyro_angle", "wave_angle", "table_angle", *FORCES)
    rows_of_points, longest = [], 0.0
    for number, dwell in enumerate(find_dwells(log, settle, warm_up, held)):
        rows = dwell.stop - dwell.start
        longest = max(longest, (rows - 1) * log.interval)
        parts = math.floor((rows * log.interval) / (length + log.interval) + 1e-9)
        if parts:
            size = rows // parts
            rows_of_points += [
                _read_point(log, latitude, begin, begin + size - 1, number)
                for begin in range(dwell.start, dwell.start + parts * size, size)
            ]
    if not rows_of_points:
        raise BenchError(
            f"{log.source}: nothing rests for {length:g} s after {settle:g} s of settling; the "
            f"longest dwell has {longest:g} s"
        )
    return Points(*(np.array(column) for column in zip(*rows_of_points, strict=True)))


def find_dwells(log: Log, settle: float, warm_up: float, held: Sequence[str]) -> list[slice]:
    """Rows of each stretch in which the table rests and no column of `held` jumps, from `settle`
    seconds after its beginning and `warm_up` seconds after power-on."""
    late = int(np.searchsorted(log.time, log.time[0] + warm_up - 1e-9))
    skipped = math.ceil(settle / log.interval - 1e-9)
    jumps = np.zeros(len(log.time), dtype=bool)
    for name in held:
        values = getattr(log, name)
        jumps |= np.abs(np.diff(values, prepend=values[:1])) > COMMAND_JUMP
    stretches = []
    for rest in find_rests(log, 0.0):
        bounds = [rest.start, *(np.flatnonzero(jumps[rest]) + rest.start).tolist(), rest.stop]
        for begin, end in pairwise(bounds):
            first = max(begin + skipped, late)
            if end > first + 1:
                stretches.append(slice(int(first), int(end)))
    return stretches


def _read_point(log: Log, latitude: float, first: int, last: int, dwell: int) -> tuple[object, ...]:
    part = slice(first + 1, last + 1)
    return (
        read_mean_rate(log, latitude, first, last),
        np.mean(log.wave_angle[first : last + 1]),
        [np.mean(getattr(log, name)[part]) for name in FORCES],
        (log.time[first] + log.time[last]) / 2,
        log.time[last] - log.time[first],
        first,
        last,
        dwell,
    )
