"""Rows of the gyro's output and the terms that are fitted to them in the identification tests.

The terms are of first order in every imperfection; th is the detected pattern angle. Errors of
pick-offs are errors of the angle th, so that they need no duration. Errors of drives and damping
are rates (`pyhrg.theory`).
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from pyhrg.bench.estimation.harmonics import LARGEST_INFLATION, Fit, average_wave
from pyhrg.bench.estimation.row_fit import Part, compute_inflations, fit_rows
from pyhrg.bench.outcome import BenchError, Finding
from pyhrg.bench.readings.segments import AT_REST, split_rows
from pyhrg.common.arrays import Array
from pyhrg.common.site import Site
from pyhrg.records import Log
from pyhrg.records.campaign import Campaign

TRANSIENT = 3.0
"""Time after power-on and after each command that is not used, s; loops of 6 rad/s have settled to
1e-7 then."""
BIAS_TERMS = ("bias mean", "bias cos4", "bias sin4")
"""Names of the terms of the bias map."""
SHORTEST_ROWS = 20
"""Fewest rows of a stretch that is used."""


@dataclass(frozen=True)
class Rows:
    """n consecutive rows of a log.

    Attributes:
        log: log of one power-on.
        first, last: the rows are [first, last); `first` is at least 1, for the row before it gives
            the readings at their beginning.
    """

    log: Log
    first: int
    last: int

    def __len__(self) -> int:
        return self.last - self.first

    def ends(self, name: str) -> Array:
        """(n + 1,) readings of a column at the bounds of the rows."""
        return np.asarray(getattr(self.log, name)[self.first - 1 : self.last])

    def values(self, name: str) -> Array:
        """(n,) values of a column in the rows."""
        return np.asarray(getattr(self.log, name)[self.first : self.last])

    def increments(self, name: str) -> Array:
        """(n,) changes of a column over the rows."""
        return np.diff(self.ends(name))

    def mean_trig(self, trig: np.ufunc, order: int) -> Array:
        """(n,) mean over each row of `trig`, cosine or sine, of `order` times the pattern angle."""
        return average_wave(trig, order, self.ends("wave_angle"))


COMMANDS = ("axis_up", "virtual_rotation", "amplitude_setpoint", "phase_offset", "drive_on")
"""Columns of a log whose change begins a new stretch."""
ANGLES = ("gyro_angle", "wave_angle", "table_angle")
"""Columns of a log that every stretch must have."""


def find_steady_rows(log: Log, *names: str, at_rest: bool = False) -> list[Rows]:
    """Stretches without gap, with drive on and constant commands, after the transient.

    The columns `names` must have values too; `at_rest` asks for a table at rest.
    """
    log.require(*ANGLES, *COMMANDS, *names)
    wait = int(np.ceil(TRANSIENT / log.interval - 1e-9))
    held = np.stack([getattr(log, name) for name in COMMANDS])
    changed = np.any(np.diff(held, axis=1, prepend=held[:, :1]) != 0, axis=0)
    if at_rest:
        changed |= np.abs(np.diff(log.table_angle, prepend=log.table_angle[:1])) > AT_REST
    return [
        Rows(log, begin + max(wait, 1), end)
        for stretch in log.stretches(*ANGLES, *names)
        for begin, end in split_rows(stretch, changed[stretch])
        if end - begin - wait >= SHORTEST_ROWS and log.is_driven[begin]
    ]


def require_steady_rows(logs: Sequence[Log], *names: str, at_rest: bool = False) -> list[Rows]:
    """Steady stretches of several logs, at least one; arguments as `find_steady_rows`."""
    stretches = [rows for log in logs for rows in find_steady_rows(log, *names, at_rest=at_rest)]
    if not stretches:
        raise BenchError(
            f"{', '.join(log.source for log in logs)}: no stretch of {SHORTEST_ROWS} rows with the "
            f"drive on and without gap, {TRANSIENT:g} s after power-on and each command"
        )
    return stretches


def make_bias_columns(rows: Rows) -> dict[str, Array]:
    """(n,) columns of the bias map, mean and fourth harmonic: rad of output per rad/s of bias."""
    h = rows.log.interval
    return {
        BIAS_TERMS[0]: np.full(len(rows), h),
        BIAS_TERMS[1]: h * rows.mean_trig(np.cos, 4),
        BIAS_TERMS[2]: h * rows.mean_trig(np.sin, 4),
    }


def make_output_part(rows: Rows, site: Site, columns: Mapping[str, Array]) -> Part:
    """Output of rows, to be fitted by columns (n,) of what a unit of each term adds to it, rad."""
    earth = site.vertical_rate * rows.values("axis_up") * rows.log.interval
    error = rows.increments("gyro_angle") - rows.increments("table_angle") - earth
    return Part(columns, error, rows.log.interval)


def read_bryan_factor(campaign: Campaign) -> float:
    """Angular gain (Bryan factor) that the campaign states as nominal."""
    if "coriolis_factor" not in campaign.nominal:
        raise BenchError(f"{campaign.device}: campaign.json, nominal: coriolis_factor is missing")
    return float(campaign.nominal["coriolis_factor"])


@dataclass(frozen=True)
class Terms:
    """A fit of the terms that the records can separate.

    Attributes:
        refused: a sentence on each term that the records can't separate, by the term's name.
        parts: parts of the rows that the fit is made of.
    """

    fit: Fit
    refused: dict[str, str]
    parts: Sequence[Part]

    def finding(self, name: str, unit: str, label: str = "", factor: float = 1.0) -> Finding:
        """A term times a factor, with its interval; NaN with the reason where the term is refused.

        `label` names the finding, the term's name if empty; `factor` is finding over term.
        """
        label = label or name
        if name in self.refused:
            return Finding(label, np.nan, unit, note=self.refused[name])
        return self.fit.finding(name, label, unit, factor)


def fit_terms(parts: Sequence[Part], names: Sequence[str], reason: str) -> Terms:
    """Fit of terms in the order of importance; a term that earlier ones confound is refused.

    `names` has the most important term first; `reason` says what the records lack where a term is
    refused, and ends the sentence on it.
    """
    accepted: list[str] = []
    refused = {}
    for name in names:
        if max(compute_inflations(parts, [*accepted, name]).values()) <= LARGEST_INFLATION:
            accepted.append(name)
        else:
            others = " and ".join(accepted) or "zero"
            refused[name] = f"{name} can't be separated from {others}: {reason}"
    try:
        return Terms(fit_rows(parts, accepted), refused, parts)
    except ValueError as error:
        raise BenchError(f"{error}; {reason}") from error
