"""Cycles of virtual rotation, one way and back, and rests of the same length to compare with.

They are read from stretches of a log at constant virtual rotation and table rate, and the error of
the output. At virtual rotation V (as an input rate), an input rate W of table and Earth and a
pattern angle th, the error of the output rate is W (s + harmonics of th) + B + harmonics of the
bias + V (-e + harmonics): scale-factor error s, bias B, gain error e of the virtual rotation. The
last part changes its sign with V, the bias does not.
"""

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from scipy import stats

from pyhrg.bench.estimation.angle_fit import Record, compute_largest_inflation
from pyhrg.bench.estimation.harmonics import LARGEST_INFLATION, average_wave, name_terms
from pyhrg.bench.outcome import BenchError, Finding
from pyhrg.bench.readings.segments import split_rows
from pyhrg.bench.readings.turns import SETTLE, TURN_TOLERANCE, Turn, find_rate_changes
from pyhrg.common.arrays import Mask
from pyhrg.common.site import Site
from pyhrg.common.units import DEG
from pyhrg.records import Log

BIAS, GAIN, SCALE = "bias", "virtual rotation", "scale factor"
"""Kinds of terms: independent of the rates, proportional to V, proportional to W."""
MAP_PERIODS = (180 * DEG, 90 * DEG)
"""Period of the bias map with a second harmonic, and without one; rad of pattern angle."""
SHORTEST_ROWS = 30
"""Fewest rows of a stretch that is used."""
ORDERS = (4, 2, 8)
"""Harmonics of the pattern angle, the most important first."""


@dataclass(frozen=True)
class Sweep(Turn):
    """A turn of the table, or a rest, at constant virtual rotation.

    Attributes:
        virtual_rotation: commanded rotation as an input rate, rad/s; 0 for a rest.
    """

    virtual_rotation: float

    @property
    def table_rate(self) -> float:
        """Mean rate of the table, rad/s; 0 at rest."""
        moved = abs(float(self.table_angle[-1] - self.table_angle[0]))
        return super().table_rate if moved > TURN_TOLERANCE * len(self.time) else 0.0

    def average_period(self) -> tuple[float, float] | None:
        """Mean error of the output rate, rad/s, over a whole period of the bias map, and that
        period, rad of pattern angle; None for a shorter stretch."""
        moved_by = np.abs(self.pattern_angle - self.pattern_angle[0])
        for period in MAP_PERIODS:
            if moved_by[-1] >= period:
                time, excess = (np.interp(period, moved_by, x) for x in (self.time, self.excess))
                return float(excess / (time - self.time[0])), period
        return None

    def record(self, orders: Sequence[int], kinds: Sequence[str]) -> Record:
        """Record for a fit of the excess: mean and harmonics (`orders`) of each kind of terms."""
        steps = np.diff(self.time)
        waves = {"": self.time - self.time[0]}
        for order in orders:
            for name, trig in zip(name_terms(order), (np.cos, np.sin), strict=True):
                mean = average_wave(trig, order, self.pattern_angle)
                waves[f" {name}"] = np.concatenate([[0.0], np.cumsum(mean * steps)])
        rates = {BIAS: 1.0, GAIN: self.virtual_rotation, SCALE: self.input_rate}
        pairs = ((kind, name) for kind in kinds for name in waves)
        columns = {f"{kind}{name}": rates[kind] * waves[name] for kind, name in pairs}
        return Record(self.interval, self.excess, columns)


def find_sweeps(log: Log, site: Site) -> list[Sweep]:
    """Sweeps of a log in order of time, from a settling time after each change."""
    log.require("table_angle", "axis_up", "virtual_rotation", "gyro_angle", "wave_angle")
    settle = math.ceil(SETTLE / log.interval)
    return [
        _read_sweep(log, site, slice(first + settle, after))
        for stretch in log.stretches("table_angle", "virtual_rotation", "gyro_angle", "wave_angle")
        for first, after in split_rows(stretch, _find_changes(log, stretch))
        if after - first > settle + SHORTEST_ROWS
    ]


def _find_changes(log: Log, rows: slice) -> Mask:
    """Mask of rows at which table rate or a command changes or the output is not valid."""
    turned = np.diff(log.table_angle[rows], prepend=log.table_angle[rows][:1])
    changed = find_rate_changes(turned)
    for values in (log.virtual_rotation, log.axis_up, log.drive_on):
        changed |= np.diff(values[rows], prepend=values[rows][:1]) != 0
    return np.asarray(changed | log.is_free[rows] | (log.valid[rows] < 0.999))


def _read_sweep(log: Log, site: Site, rows: slice) -> Sweep:
    time, table, pattern, gyro = (
        np.asarray(values[rows])
        for values in (log.time, log.table_angle, log.wave_angle, log.gyro_angle)
    )
    earth = site.vertical_rate * float(np.mean(log.axis_up[rows]))
    angle = table - table[0] + earth * (time - time[0])
    command, excess = float(log.virtual_rotation[rows][-1]), gyro - gyro[0] - angle
    return Sweep(log.source, log.interval, time, table, pattern, angle, excess, command)


def select_orders(sweeps: Sequence[Sweep], kinds: Sequence[str]) -> tuple[int, ...]:
    """Harmonics that the sweeps can separate, the same for all kinds of terms."""
    orders: tuple[int, ...] = ()
    for order in ORDERS:
        records = [sweep.record((*orders, order), kinds) for sweep in sweeps]
        if compute_largest_inflation(records) <= LARGEST_INFLATION:
            orders += (order,)
    return orders


@dataclass(frozen=True)
class Cycle:
    """One mean of the output at rest.

    Attributes:
        rate: mean output rate less Earth's rate, rad/s.
        length: averaging time, s.
        pattern_angle: pattern angle at the beginning, rad.
        gain: gain error of the virtual rotation; NaN for a rest.
        period: pattern angle that a sweep went through, rad; 0 for a rest.
    """

    rate: float
    length: float
    pattern_angle: float
    gain: float = np.nan
    period: float = 0.0


def pair_cycles(logs: Sequence[Sequence[Sweep]]) -> list[list[Cycle]]:
    """Cycles of each power-on at rest; where each turns one way only, of power-ons in pairs."""
    resting = [[s for s in log if s.table_rate == 0.0 and s.average_period()] for log in logs]
    runs = [cycles for log in resting if (cycles := _pairs(log))]
    if not runs and (crossed := _pairs([sweep for log in resting for sweep in log])):
        runs = [crossed]
    if not runs:
        turned = [abs(s.pattern_angle[-1] - s.pattern_angle[0]) / DEG for log in logs for s in log]
        sources = ", ".join(sorted({s.source for log in logs for s in log})) or "campaign"
        raise BenchError(
            f"{sources}: no virtual rotation at rest by a whole period of "
            f"{MAP_PERIODS[-1] / DEG:g} deg of pattern, one way and back; the longest turns it by "
            f"{max(turned, default=0):.3g}"
        )
    return runs


def _pairs(sweeps: Sequence[Sweep]) -> list[Cycle]:
    cycles = []
    rest = list(sweeps)
    while len(rest) > 1:
        forward, backward = rest[:2]
        if forward.virtual_rotation != -backward.virtual_rotation:
            rest = rest[1:]
            continue
        rest = rest[2:]
        (first, period), (second, back) = (
            x.average_period() or (0.0, 0.0) for x in (forward, backward)
        )
        gain = (second - first) / (2 * forward.virtual_rotation)
        length = (forward.time[-1] - forward.time[0]) + (backward.time[-1] - backward.time[0])
        start, mean = float(forward.pattern_angle[0]), (first + second) / 2
        cycles.append(Cycle(mean, length, start, gain, min(period, back)))
    return cycles


def find_averaging_time(runs: Sequence[Sequence[Cycle]]) -> float:
    """Mean length of a cycle, s."""
    return float(np.mean([cycle.length for run in runs for cycle in run]))


def cut_rests(logs: Sequence[Sequence[Sweep]], length: float) -> list[list[Cycle]]:
    """Means over `length` seconds, s, of the rests of each power-on; short ones are left out."""
    runs = [[mean for sweep in log for mean in _means(sweep, length)] for log in logs]
    if not any(runs):
        longest = max((s.time[-1] - s.time[0] for log in logs for s in log), default=0.0)
        raise BenchError(
            f"without virtual rotation the longest rest lasts {longest:g} s; a mean to compare "
            f"with a cycle takes {length:g} s"
        )
    return [run for run in runs if run]


def _means(sweep: Sweep, length: float) -> list[Cycle]:
    rows = round(length / sweep.interval)
    return [
        Cycle(
            rate=float(sweep.excess[i + rows] - sweep.excess[i]) / (rows * sweep.interval),
            length=rows * sweep.interval,
            pattern_angle=float(sweep.pattern_angle[i]),
        )
        for i in range(0, len(sweep.time) - rows, rows)
    ]


def find_pooled_deviation(name: str, runs: Sequence[Sequence[float]], note: str) -> Finding:
    """Standard deviation within power-ons, rad/s, chi-square interval."""
    squares = sum(float(np.sum((np.array(run) - np.mean(run)) ** 2)) for run in runs)
    freedom = sum(len(run) - 1 for run in runs)
    if freedom < 1:
        return Finding(name, np.nan, "deg/h", n=0, note=f"{note}: one mean a power-on shows none")
    value = float(np.sqrt(squares / freedom))
    high, low = np.sqrt(freedom / stats.chi2.ppf([0.025, 0.975], freedom))
    return Finding(name, value, "deg/h", value * float(low), value * float(high), freedom + 1, note)


def list_warnings(runs: Sequence[Sequence[Cycle]]) -> tuple[str, ...]:
    """What the cycles can't average out."""
    if min(cycle.period for run in runs for cycle in run) < MAP_PERIODS[0]:
        return (
            f"sweeps of {MAP_PERIODS[-1] / DEG:g} deg of pattern don't average a second harmonic "
            f"of the bias; {MAP_PERIODS[0] / DEG:g} deg would",
        )
    return ()
