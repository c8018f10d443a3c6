"""Scale factor from turns of the table in both directions, over whole periods of the pattern.

A plain measure for temperatures and years; the scale factor over the circumference is measured by
its own procedures.
"""

import math
from dataclasses import dataclass
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from pyhrg.bench.outcome import BenchError
from pyhrg.records import Log

Array = NDArray[np.float64]

SLOWEST = math.radians(1.0)
"""Rate from which the table turns, rad/s."""


@dataclass(frozen=True)
class Spin:
    """One stretch at a constant rate.

    scale_factor: gyro angle over table angle, Earth's rate taken out.
    first, last: rows of the log.
    """

    rate: float
    scale_factor: float
    first: int
    last: int


def spins(log: Log, vertical_rate: float) -> list[Spin]:
    """Stretches of constant table rate, each fitted over whole quarter turns of the pattern.

    Args:
        log: one power-on.
        vertical_rate: Earth's rate on local up, rad/s.
    """
    rates = np.diff(log.table_angle, prepend=log.table_angle[:1]) / log.interval
    steady = np.abs(rates) > SLOWEST
    steady[1:] &= np.abs(np.diff(rates)) < 1e-3 * np.abs(rates[1:]) + 1e-7
    found = []
    for stretch in log.stretches("gyro_angle", "wave_angle", "table_angle"):
        rows = np.arange(len(steady))[stretch]
        bounds = [-1, *np.flatnonzero(~steady[rows]).tolist(), len(rows)]
        for before, after in pairwise(bounds):
            if after - before > 3:
                part = slice(int(rows[before + 1]), int(rows[after - 1]) + 1)
                found += [s for s in [_spin(log, part, vertical_rate)] if s]
    return found


def _spin(log: Log, part: slice, vertical_rate: float) -> Spin | None:
    """Fit of the gyro's angle by the table's and the fourth harmonic; None under one period."""
    pattern = log.wave_angle[part]
    periods = math.floor(abs(pattern[-1] - pattern[0]) / (math.pi / 2))
    if periods < 1:
        return None
    whole = np.abs(pattern - pattern[0]) <= periods * math.pi / 2
    rows = np.arange(part.start, part.stop)[whole]
    earth = vertical_rate * log.interval * np.cumsum(log.axis_up)[rows]
    table, pattern = log.table_angle[rows], log.wave_angle[rows]
    error = log.gyro_angle[rows] - earth - table
    columns = [np.ones_like(table), table - table[0], np.cos(4 * pattern), np.sin(4 * pattern)]
    if len(rows) <= len(columns):
        return None
    slope = float(np.linalg.lstsq(np.column_stack(columns), error, rcond=None)[0][1])
    rate = (table[-1] - table[0]) / (log.time[rows[-1]] - log.time[rows[0]])
    return Spin(float(rate), 1 + slope, int(rows[0]), int(rows[-1]))


def pairs(found: list[Spin], source: str) -> list[tuple[Spin, Spin]]:
    """Neighbours in opposite directions at one rate: their mean is free of bias.

    Raises:
        BenchError: none.
    """
    chosen = []
    rest = list(found)
    while len(rest) > 1:
        one, other = rest[0], rest[1]
        if abs(one.rate + other.rate) < 0.01 * abs(one.rate):
            chosen.append((one, other))
            rest = rest[2:]
        else:
            rest = rest[1:]
    if not chosen:
        raise BenchError(
            f"{source}: no two neighbouring spins in opposite directions over a whole period of "
            f"the pattern; {len(found)} spins found"
        )
    return chosen


def pair_scale_factor(pair: tuple[Spin, Spin]) -> float:
    """Mean of both directions, less one: the scale-factor error."""
    return (pair[0].scale_factor + pair[1].scale_factor) / 2 - 1
