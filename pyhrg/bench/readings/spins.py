"""Scale factor from turns of the table in both directions, over whole periods of the pattern: its
mean over the circumference, and its fourth harmonic.

Temperature tests and annual tests use it; the scale factor over the circumference has procedures of
its own (`pyhrg.bench.scale_factor`).
"""

import math
from dataclasses import dataclass

import numpy as np

from pyhrg.bench.outcome import BenchError
from pyhrg.bench.readings.segments import split_rows
from pyhrg.records import Log

SLOWEST = math.radians(1.0)
"""Smallest table rate of a spin, rad/s."""


@dataclass(frozen=True)
class Spin:
    """A stretch at a constant table rate.

    rate: of the table, rad/s.
    scale_factor: gyro angle over table angle, without Earth's rate.
    harmonic: of the scale-factor error over the pattern angle th: it is the real part of
        harmonic exp(-4i th).
    first, last: rows of the log.
    """

    rate: float
    scale_factor: float
    harmonic: complex
    first: int
    last: int


def find_spins(log: Log, vertical_rate: float) -> list[Spin]:
    """Spins of a log, each fitted over whole quarter turns of the pattern."""
    rates = np.diff(log.table_angle, prepend=log.table_angle[:1]) / log.interval
    steady = np.abs(rates) > SLOWEST
    steady[1:] &= np.abs(np.diff(rates)) < 1e-3 * np.abs(rates[1:]) + 1e-7
    parts = (
        slice(begin if steady[begin] else begin + 1, end)
        for stretch in log.stretches("gyro_angle", "wave_angle", "table_angle")
        for begin, end in split_rows(stretch, ~steady[stretch])
        if end > begin
    )
    measured = [_measure_spin(log, p, vertical_rate) for p in parts if p.stop - p.start > 2]
    return [spin for spin in measured if spin]


def _measure_spin(log: Log, part: slice, vertical_rate: float) -> Spin | None:
    """Spin from a fit of the gyro angle by the table angle and the fourth harmonic of the pattern
    angle; None for less than one period of the harmonic."""
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
    _, slope, cosine, sine = np.linalg.lstsq(np.column_stack(columns), error, rcond=None)[0]
    turned = float(table[-1] - table[0])
    rate = turned / (log.time[rows[-1]] - log.time[rows[0]])
    # derivative of the angle's harmonic by the table angle
    harmonic = -4j * complex(cosine, sine) * float(pattern[-1] - pattern[0]) / turned
    return Spin(float(rate), 1 + float(slope), harmonic, int(rows[0]), int(rows[-1]))


def pair_spins(spins: list[Spin], source: str) -> list[tuple[Spin, Spin]]:
    """Pairs of successive spins in opposite directions at one rate; their mean is free of bias."""
    pairs = []
    remaining = list(spins)
    while len(remaining) > 1:
        first, second = remaining[0], remaining[1]
        if abs(first.rate + second.rate) < 0.01 * abs(first.rate):
            pairs.append((first, second))
            remaining = remaining[2:]
        else:
            remaining = remaining[1:]
    if not pairs:
        raise BenchError(
            f"{source}: no two neighbouring spins in opposite directions over a whole period of "
            f"the pattern; {len(spins)} spins found"
        )
    return pairs


def compute_scale_factor_error(pair: tuple[Spin, Spin]) -> float:
    """Scale-factor error: mean over both directions, less one."""
    return (pair[0].scale_factor + pair[1].scale_factor) / 2 - 1


def compute_scale_factor_harmonic(pair: tuple[Spin, Spin]) -> complex:
    """Fourth harmonic of the scale-factor error, of both directions: a bias map's cancels."""
    return (pair[0].harmonic + pair[1].harmonic) / 2
