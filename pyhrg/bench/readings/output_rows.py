"""Rows of the gyro's output against what may have moved it: terms of every identification fit.

First order in every imperfection, with th the detected pattern angle. Angles of pick-offs are an
angle error of th, so that they need no rate; drives and damping are rates (`theory`, docs).
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from pyhrg.bench.estimation.harmonics import LARGEST_INFLATION, Fit
from pyhrg.bench.estimation.row_fit import Part, inflations, row_fit
from pyhrg.bench.outcome import BenchError, Finding
from pyhrg.bench.readings.segments import AT_REST
from pyhrg.common.site import Site
from pyhrg.records import Log
from pyhrg.records.campaign import Campaign

Array = NDArray[np.float64]

TRANSIENT = 3.0
"""Left out after power-on and after each command, s: loops of 6 rad/s settle to 1e-7."""
BIAS = ("bias mean", "bias cos4", "bias sin4")
"""Terms of the bias map."""
FEWEST = 20
"""Rows that a stretch must have to be of use."""


@dataclass(frozen=True)
class Rows:
    """Consecutive rows of a log, each with the one before.

    log: of one power-on.
    first, last: rows [first, last), of which `first` is at least 1.
    """

    log: Log
    first: int
    last: int

    def __len__(self) -> int:
        return self.last - self.first

    def ends(self, name: str) -> Array:
        """(n + 1,) values at the bounds of the rows."""
        return np.asarray(getattr(self.log, name)[self.first - 1 : self.last])

    def held(self, name: str) -> Array:
        """(n,) values over the rows."""
        return np.asarray(getattr(self.log, name)[self.first : self.last])

    def increments(self, name: str) -> Array:
        """(n,) changes over the rows."""
        return np.diff(self.ends(name))

    def mean_trig(self, trig: Callable[[Array], Array], order: int) -> Array:
        """(n,) mean over each row of the cosine or sine of `order` times the pattern angle."""
        angle = self.ends("wave_angle")
        middle, swept = (angle[1:] + angle[:-1]) / 2, np.diff(angle)
        return trig(order * middle) * np.sinc(order * swept / (2 * np.pi))

    def earth_rate(self, site: Site) -> Array:
        """(n,) Earth's rate on the input axis, rad/s."""
        return site.vertical_rate * self.held("axis_up")


COMMANDS = ("axis_up", "virtual_rotation", "amplitude_setpoint", "phase_offset", "drive_on")
USED = ("gyro_angle", "wave_angle", "table_angle")


def steady(log: Log, *names: str, at_rest: bool = False) -> list[Rows]:
    """Stretches without gap, drive on, a transient after power-on and each command left out.

    Args:
        log: one power-on.
        names: further columns that must be there.
        at_rest: of the table alone.
    """
    log.require(*USED, *COMMANDS, *names)
    wait = int(np.ceil(TRANSIENT / log.interval - 1e-9))
    found = []
    for stretch in log.stretches(*USED, *names):
        rows = np.arange(len(log.time))[stretch]
        changed = np.zeros(len(rows), dtype=bool)
        for name in COMMANDS:
            held = getattr(log, name)[stretch]
            changed |= np.diff(held, prepend=held[:1]) != 0
        if at_rest:
            table = log.table_angle[stretch]
            changed |= np.abs(np.diff(table, prepend=table[:1])) > AT_REST
        bounds = [0, *np.flatnonzero(changed).tolist(), len(rows)]
        for begin, end in pairwise(bounds):
            if end - begin - wait >= FEWEST and log.drive_on[rows[begin]] > 0.5:
                found.append(Rows(log, int(rows[begin]) + max(wait, 1), int(rows[end - 1]) + 1))
    return found


def useful(logs: Sequence[Log], *names: str, at_rest: bool = False) -> list[Rows]:
    """Steady rows of all logs.

    Raises:
        BenchError: there are none.
    """
    found = [rows for log in logs for rows in steady(log, *names, at_rest=at_rest)]
    if not found:
        raise BenchError(
            f"{', '.join(log.source for log in logs)}: no stretch of {FEWEST} rows with the drive "
            f"on and without gap, {TRANSIENT:g} s after power-on and each command"
        )
    return found


def bias_columns(rows: Rows) -> dict[str, Array]:
    """Bias map: mean and fourth harmonic, in rad of output."""
    h = rows.log.interval
    return {
        BIAS[0]: np.full(len(rows), h),
        BIAS[1]: h * rows.mean_trig(np.cos, 4),
        BIAS[2]: h * rows.mean_trig(np.sin, 4),
    }


def output_error(rows: Rows, site: Site) -> Array:
    """(n,) increments of the output less table and Earth, rad."""
    earth = rows.earth_rate(site) * rows.log.interval
    return rows.increments("gyro_angle") - rows.increments("table_angle") - earth


def bryan_factor(campaign: Campaign) -> float:
    """That the gyro's output is made with.

    Raises:
        BenchError: the campaign doesn't say.
    """
    if "coriolis_factor" not in campaign.nominal:
        raise BenchError(f"{campaign.device}: campaign.json, nominal: coriolis_factor is missing")
    return float(campaign.nominal["coriolis_factor"])


@dataclass(frozen=True)
class Terms:
    """A fit of the terms that the records can tell apart, and a sentence on each other one."""

    fit: Fit
    refused: dict[str, str]
    parts: Sequence[Part]

    def finding(self, name: str, unit: str, label: str = "", factor: float = 1.0) -> Finding:
        """A term times a factor, with its interval; NaN and why where it is refused."""
        label = label or name
        if name in self.refused:
            return Finding(label, np.nan, unit, note=self.refused[name])
        low, high = sorted(factor * bound for bound in self.fit.interval(name))
        count = len(self.fit.residual)
        return Finding(label, factor * self.fit.value(name), unit, low, high, count)


def fitted(parts: Sequence[Part], names: Sequence[str], reason: str) -> Terms:
    """Fit terms in order of importance; later ones go where they can't be told from earlier ones.

    Args:
        names: of the terms, the most important first.
        reason: what the records would have to hold, for the sentence on a refused term.
    """
    seen: list[str] = []
    refused = {}
    for name in names:
        worst = max(inflations(parts, [*seen, name]).values())
        if worst > LARGEST_INFLATION:
            refused[name] = f"{name} can't be told from {' and '.join(seen) or 'zero'}: {reason}"
        else:
            seen.append(name)
    try:
        return Terms(row_fit(parts, seen), refused, parts)
    except ValueError as error:
        raise BenchError(f"{error}; {reason}") from error
