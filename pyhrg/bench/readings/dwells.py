"""Data points of a log while nothing moves but the pattern: independent of each other.

Neighbours share no sample, so that the noise of one angle reading is not in two rates.
"""

import math
from collections.abc import Sequence
from dataclasses import dataclass, fields
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from pyhrg.bench.outcome import BenchError
from pyhrg.bench.readings.segments import SEGMENT, rests
from pyhrg.common.site import EARTH_RATE
from pyhrg.records import Log

Array = NDArray[np.float64]

FORCES = ("acceleration_x", "acceleration_y", "acceleration_z")
JUMP = 0.5
"""Specific force that changes by more than this from row to row has been commanded to, m/s2."""


@dataclass(frozen=True)
class Points:
    """Data points, each (n,) but for the specific force.

    rate: output rate less Earth's rate on the input axis, rad/s.
    pattern_angle: mean, rad.
    acceleration: (n, 3) mean specific force, m/s2.
    time: middle since power-on, s.
    duration: s.
    first, last: rows of the log at whose ends the angle was read.
    dwell: number of the dwell, counted through the log.
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
        """Those chosen."""
        return Points(*(getattr(self, f.name)[chosen] for f in fields(self)))


def joined(parts: Sequence[Points]) -> Points:
    """Points of several logs, one after the other; rows and dwells stay those of their log."""
    return Points(*(np.concatenate([getattr(p, f.name) for p in parts]) for f in fields(Points)))


def points(
    log: Log,
    latitude: float,
    settle: float,
    length: float = SEGMENT,
    warm_up: float = 0.0,
    held: Sequence[str] = FORCES,
) -> Points:
    """Equal parts of about `length` seconds, at least, of each dwell.

    Args:
        log: one power-on.
        latitude: of the site, rad.
        settle: left out at the beginning of each dwell, s.
        length: least length of a part, s.
        warm_up: left out after power-on, s.
        held: columns that a dwell ends with a jump of.

    Raises:
        BenchError: no dwell is long enough.
    """
    log.require("axis_up", "gyro_angle", "wave_angle", "table_angle", *FORCES)
    found, longest = [], 0.0
    for number, dwell in enumerate(dwells(log, settle, warm_up, held)):
        rows = dwell.stop - dwell.start
        longest = max(longest, (rows - 1) * log.interval)
        parts = math.floor((rows * log.interval) / (length + log.interval) + 1e-9)
        if parts:
            size = rows // parts
            found += [
                _point(log, latitude, begin, begin + size - 1, number)
                for begin in range(dwell.start, dwell.start + parts * size, size)
            ]
    if not found:
        raise BenchError(
            f"{log.source}: nothing rests for {length:g} s after {settle:g} s of settling; the "
            f"longest dwell has {longest:g} s"
        )
    return Points(*(np.array(column) for column in zip(*found, strict=True)))


def dwells(log: Log, settle: float, warm_up: float, held: Sequence[str]) -> list[slice]:
    """Rows of each stretch with the table at rest and no jump of the columns in `held`."""
    late = int(np.searchsorted(log.time, log.time[0] + warm_up - 1e-9))
    skipped = math.ceil(settle / log.interval - 1e-9)
    jumps = np.zeros(len(log.time), dtype=bool)
    for name in held:
        values = getattr(log, name)
        jumps |= np.abs(np.diff(values, prepend=values[:1])) > JUMP
    found = []
    for rest in rests(log, 0.0):
        bounds = [rest.start, *(np.flatnonzero(jumps[rest]) + rest.start).tolist(), rest.stop]
        for begin, end in pairwise(bounds):
            first = max(begin + skipped, late)
            if end > first + 1:
                found.append(slice(int(first), int(end)))
    return found


def _point(log: Log, latitude: float, first: int, last: int, dwell: int) -> tuple[object, ...]:
    span = log.time[last] - log.time[first]
    part = slice(first + 1, last + 1)
    earth = EARTH_RATE * math.sin(latitude) * np.mean(log.axis_up[part])
    return (
        (log.gyro_angle[last] - log.gyro_angle[first]) / span - earth,
        np.mean(log.wave_angle[first : last + 1]),
        [np.mean(getattr(log, name)[part]) for name in FORCES],
        (log.time[first] + log.time[last]) / 2,
        span,
        first,
        last,
        dwell,
    )
