"""Cycles of virtual rotation, one way and back, and rests of the same length to compare with."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from scipy import stats

from pyhrg.bench.outcome import BenchError, Finding
from pyhrg.bench.readings.sweeps import MAP_PERIODS, Sweep
from pyhrg.common.units import DEG


@dataclass(frozen=True)
class Cycle:
    """One mean of the output at rest.

    rate: rad/s, Earth's taken out.
    length: averaging time, s.
    pattern_angle: at the beginning, rad.
    gain: error of the virtual rotation; NaN without.
    period: of pattern that a sweep went through, rad; 0 without.
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


def _pairs(found: Sequence[Sweep]) -> list[Cycle]:
    cycles = []
    rest = list(found)
    while len(rest) > 1:
        one, other = rest[:2]
        if one.virtual_rotation != -other.virtual_rotation:
            rest = rest[1:]
            continue
        rest = rest[2:]
        (first, period), (second, back) = (x.average_period() or (0.0, 0.0) for x in (one, other))
        gain = (second - first) / (2 * one.virtual_rotation)
        length = (one.time[-1] - one.time[0]) + (other.time[-1] - other.time[0])
        start, mean = float(one.pattern_angle[0]), (first + second) / 2
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
