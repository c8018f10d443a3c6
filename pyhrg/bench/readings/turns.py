"""Stretches of a log at a steady table rate: the data of the scale-factor tests.

Temperature tests and annual tests read the scale factor from turns in both directions, over whole
periods of the pattern: its mean over the circumference, and its fourth harmonic. The scale factor
over the circumference has procedures of its own (`pyhrg.bench.scale_factor`).
"""

import math
from dataclasses import dataclass

import numpy as np

from pyhrg.bench.outcome import BenchError
from pyhrg.bench.readings.segments import COLUMNS, split_rows
from pyhrg.common.arrays import Array, Mask
from pyhrg.common.site import Site
from pyhrg.common.units import ARCSEC, DEG
from pyhrg.records import Log

SETTLE = 2.0
"""Time after the table has reached its rate that is not used, s."""
PERIOD = 90 * DEG
"""Period of the scale-factor map's fourth harmonic in the pattern angle, rad."""
TURN_TOLERANCE = 5 * ARCSEC
"""Allowance for the encoder, rad. The rate is steady where the turns of successive rows differ by
no more than this plus `RATE_TOLERANCE` of a turn."""
RATE_TOLERANCE = 0.005
"""Largest relative change of a steady table rate from row to row."""
WHOLE_PERIOD = 1 - 1e-6
"""Share of a period that counts as the whole, to allow for rounding."""


@dataclass(frozen=True)
class Turn:
    """A stretch at one table rate; arrays are (n,), at the ends of its rows, angles in rad.

    Attributes:
        source: the log.
        interval: length of the log's rows, s.
        time: time at the ends of the rows, s.
        input_angle: rotation of the input axis since the beginning, Earth's included.
        excess: change of the gyro angle since the beginning, less the input angle.
    """

    source: str
    interval: float
    time: Array
    table_angle: Array
    pattern_angle: Array
    input_angle: Array
    excess: Array

    @property
    def table_rate(self) -> float:
        """Mean rate of the table, rad/s."""
        return float((self.table_angle[-1] - self.table_angle[0]) / (self.time[-1] - self.time[0]))

    @property
    def input_rate(self) -> float:
        """Mean rate of table and Earth on the input axis, rad/s."""
        return float((self.input_angle[-1] - self.input_angle[0]) / (self.time[-1] - self.time[0]))

    @property
    def periods(self) -> float:
        """Change of the pattern angle, in periods of the scale-factor map."""
        return abs(float(self.pattern_angle[-1] - self.pattern_angle[0])) / PERIOD

    def whole_periods(self, each: int = 0) -> tuple[Array, Array, Array]:
        """Time, input angle and excess (m,) at the bounds of whole periods, interpolated linearly.

        Bounds are `each` periods apart; 0 gives two bounds, as far apart as possible.
        """
        moved = np.abs(self.pattern_angle - self.pattern_angle[0])
        whole = math.floor(self.periods + 1e-6)
        bounds = np.arange(0, whole + 1, each or max(whole, 1)) * PERIOD
        values = (self.time, self.input_angle, self.excess)
        time, angle, excess = (np.interp(bounds, moved, value) for value in values)
        return time, angle, excess


def find_turns(log: Log, site: Site) -> list[Turn]:
    """Steady stretches of at least one period, in order of time."""
    stretches = _find_all(log, site)
    whole = [turn for turn in stretches if turn.periods >= WHOLE_PERIOD]
    if not whole:
        longest = max((turn.periods for turn in stretches), default=0.0) * PERIOD / DEG
        raise BenchError(
            f"{log.source}: no stretch at a steady rate turns the pattern by {PERIOD / DEG:g} deg, "
            f"a period of the scale-factor map; the longest turns it by {longest:.3g} deg"
        )
    return whole


def list_short_turns(log: Log, site: Site) -> list[str]:
    """A sentence on each steady stretch that is shorter than one period."""
    return [
        f"{log.source}: {turn.time[0]:.6g} to {turn.time[-1]:.6g} s at {turn.table_rate / DEG:.3g} "
        f"deg/s left out: the pattern turned by {turn.periods * PERIOD / DEG:.3g} deg, less than "
        f"the {PERIOD / DEG:g} deg of a period"
        for turn in _find_all(log, site)
        if turn.periods < WHOLE_PERIOD
    ]


def _find_all(log: Log, site: Site) -> list[Turn]:
    log.require(*COLUMNS)
    return [_read_turn(log, site, rows) for rows in _find_steady(log)]


def _find_steady(log: Log) -> list[slice]:
    """Rows of each stretch without gap, with drive on, no virtual rotation and a steady rate."""
    turned = np.diff(log.table_angle, prepend=log.table_angle[:1])
    moving = (np.abs(turned) > TURN_TOLERANCE) & (log.virtual_rotation == 0.0)
    moving &= log.is_driven & ~(log.valid < 0.999)
    unsteady = find_rate_changes(turned)
    settle = math.ceil(SETTLE / log.interval)
    return [
        slice(first + settle, after)
        for stretch in log.stretches(*COLUMNS)
        for first, after in split_rows(stretch, (~moving | unsteady)[stretch])
        if after - first > settle + 8
    ]


def find_rate_changes(turned: Array) -> Mask:
    """(n,) whether the table's turn in a row, rad, differs from that in the row before, first 0."""
    change = np.abs(np.diff(turned, prepend=0.0))
    return np.asarray(change > TURN_TOLERANCE + RATE_TOLERANCE * np.abs(turned))


def _read_turn(log: Log, site: Site, rows: slice) -> Turn:
    time, table, pattern, gyro, axis_up = (
        np.asarray(values[rows])
        for values in (log.time, log.table_angle, log.wave_angle, log.gyro_angle, log.axis_up)
    )
    # axis_up of a row is valid from the end of the row before to the end of this row
    earth = site.vertical_rate * np.cumsum(axis_up) * log.interval
    angle = table - table[0] + earth - earth[0]
    excess = gyro - gyro[0] - angle
    return Turn(log.source, log.interval, time, table, pattern, angle, excess)


SLOWEST = math.radians(1.0)
"""Smallest table rate of a spin, rad/s."""


@dataclass(frozen=True)
class Spin:
    """A stretch at a constant table rate.

    Attributes:
        rate: rate of the table, rad/s.
        scale_factor: gyro angle over table angle, without Earth's rate.
        harmonic: complex amplitude of the scale-factor error over the pattern angle th, which is
            the real part of harmonic exp(-4i th).
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
