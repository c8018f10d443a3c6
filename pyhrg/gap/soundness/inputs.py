"""Completion of a log's inputs, so that every row can be replayed; each assumption is stated."""

from dataclasses import replace
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray
from scipy.interpolate import PchipInterpolator

from pyhrg.common.arrays import Array, Mask
from pyhrg.device.device import Device
from pyhrg.gap.replay.observations import COMMAND_COLUMNS
from pyhrg.gap.replay.reading_noise import estimate_scatter
from pyhrg.gap.soundness.attitude import ACCELERATIONS
from pyhrg.gap.soundness.exclusion import find_runs, replace_columns
from pyhrg.records import COLUMNS, Log, LogError
from pyhrg.records.missing_inputs import add_missing_inputs

MAX_MISSING_AT_START = 0.01
"""Largest share of rows that may be missing before the first one. Chosen."""
MAX_MISSING = 0.2
"""Largest share of missing rows with which a log is still replayed. Chosen."""
RATE_TOLERANCE = 1e-3
"""Relative change of the table's rate across missing rows that counts as none. Chosen."""
REST_TOLERANCE = 1e-6
"""Turn of the table that counts as none, rad. Chosen."""
NOISE_SIGMA = 10.0
"""Change of the table's turn in a row that noise of the encoder explains, in standard deviations of
its noise. Chosen: a change of rate is known from up to four readings."""
MAX_TURNING_GAP = 2.0
"""Longest time between two known rows over which the table's rate may change, s. Chosen: one row of
1 s is missing then. A pattern that turns another way by 3 deg for so long has an output that is off
by 0.04 arcsec with a bias of 0.1 deg/h in the fourth harmonic."""
LINEAR_INPUTS = ("temperature", *ACCELERATIONS)
"""Inputs that are interpolated linearly."""
CONTINUOUS_INPUTS = ("table_angle", *LINEAR_INPUTS)
"""All inputs that are interpolated: the table's angle by a cubic without overshoot."""


class CompleteInputs(NamedTuple):
    """A log whose inputs are known in every row, and how it came about.

    missing: (n,) rows whose inputs are filled in; sentences: one on each assumption.
    """

    log: Log
    missing: Mask
    sentences: list[str]


def complete_inputs(log: Log, nominal: Device) -> CompleteInputs:
    """A log with every row from its start and known inputs in each, and a sentence on each
    assumption. Raises a `LogError` where the start, the attitude or too many rows are missing.

    A missing column is that of a gyro at rest. Missing rows are filled where no command changed,
    and the table kept its rate or they are few; elsewhere the log is cut. Outputs of filled rows
    are NaN.
    """
    log, assumed = add_missing_inputs(log, nominal)
    notes = [f"{log.source}: {note}" for note in assumed]
    log, missing = _place_on_grid(log)
    cut, trouble = _find_cut(log, missing)
    if trouble:
        notes.append(trouble)
        log = log.section(slice(cut))
        missing = missing[:cut]
    known = np.flatnonzero(~missing)
    if trouble and len(known) < 2:
        raise LogError(f"{trouble}; no row is left")
    if len(known) < (1 - MAX_MISSING) * len(missing) or len(known) < 2:
        raise LogError(
            f"{log.source}: {np.sum(missing)} of {len(missing)} rows missing; expected at most "
            f"{MAX_MISSING:.0%}"
        )
    if missing.any():
        log = _fill_inputs(log, known)
        notes.append(f"{log.source}: {np.sum(missing)} missing rows: inputs filled in, outputs not")
    return CompleteInputs(log, missing, notes)


def _place_on_grid(log: Log) -> tuple[Log, Mask]:
    """Rows at every interval from the start, NaN where one is missing; (n,) whether inputs are
    missing."""
    place = np.round(log.time / log.interval).astype(np.int64) - 1
    if place[0] < 0 or place[-1] >= len(place) / (1 - MAX_MISSING):
        raise LogError(
            f"{log.source}: time_s {log.time[0]:.6g} to {log.time[-1]:.6g} in {len(place)} rows; "
            f"expected {log.interval:g} to {len(place) * log.interval:g}, few rows missing"
        )
    if not np.array_equal(place, np.arange(len(place))):
        empty = np.full(place[-1] + 1, np.nan)
        columns = {column.field: empty.copy() for column in COLUMNS}
        for field, values in columns.items():
            values[place] = getattr(log, field)
        log = replace_columns(log, columns)
    grid = np.arange(1, len(log.time) + 1) * log.interval
    time = np.where(np.isfinite(log.time), log.time, grid)
    inputs = np.stack([getattr(log, field) for field in (*COMMAND_COLUMNS, *CONTINUOUS_INPUTS)])
    return replace(log, time=time), ~np.isfinite(inputs).all(axis=0)


def _find_cut(log: Log, missing: Mask) -> tuple[int, str]:
    """Number of rows up to which inputs are known or can be filled in, and why not beyond."""
    for first, end in find_runs(missing):
        if end == len(missing):
            return first, f"{log.source}: inputs missing from time_s {log.time[first]:g} to the end"
        if first == 0 and end > MAX_MISSING_AT_START * len(missing):
            raise LogError(f"{log.source}: {end} rows are missing before the first one")
        if not _can_be_filled(log, first, end):
            time = log.time[first]
            if first == 0:
                raise LogError(f"{log.source}: the start is missing, to time_s {log.time[end]:g}")
            reason = f"inputs missing from time_s {time:g} on, while they changed"
            end = _find_steady_end(log.table_angle, missing, first)
            return end, f"{log.source}: {reason}: cut there"
    return len(missing), ""


def _find_steady_end(angle: Array, missing: Mask, end: int) -> int:
    """End of the rows up to `end` in and after which the table kept its rate, the last of them
    known: with no row after it, a change of the rate within a row is not known."""
    turns = np.diff(angle[:end], prepend=0.0)
    changes = np.abs(np.diff(turns)) > REST_TOLERANCE + RATE_TOLERANCE * np.abs(turns[1:])
    while end > 2 and changes[end - 2]:
        end -= 1
    end = max(end - 1, 1)
    while end > 1 and missing[end - 1]:
        end -= 1
    return end


def _can_be_filled(log: Log, first: int, end: int) -> bool:
    """Whether the inputs of missing rows follow from those around: no command changed, and of the
    table's angle none is missing, or only for a short time, or while it kept its rate."""
    commands = [getattr(log, field) for field in COMMAND_COLUMNS]
    if first and any(c[first - 1] != c[end] for c in commands):
        return False
    is_short = first > 0 and (end - first + 1) * log.interval <= MAX_TURNING_GAP
    is_known = bool(np.isfinite(log.table_angle[first:end]).all())
    return is_known or is_short or _keeps_rate(log, first, end)


def _keeps_rate(log: Log, first: int, end: int) -> bool:
    """Whether the table kept its rate over missing rows, also since power-on. The rate before them
    is that of the last two known rows; that after them counts if both rows are known."""
    angle, interval = np.append(0.0, log.table_angle), log.interval  # 0 at power-on
    first, end = first + 1, end + 1
    across = (angle[end] - angle[first - 1]) / (end - first + 1) / interval
    known = np.flatnonzero(np.isfinite(angle[:first]))
    last = known[-2] if len(known) > 1 else end
    before = (angle[first - 1] - angle[last]) / (first - 1 - last) / interval
    after = (angle[end + 1] - angle[end]) / interval if end + 1 < len(angle) else across
    after = after if np.isfinite(after) else across
    least = REST_TOLERANCE + NOISE_SIGMA * estimate_scatter(angle[np.isfinite(angle)])
    allowed = RATE_TOLERANCE * abs(across) + least / interval
    return bool(max(abs(before - across), abs(after - across)) <= allowed)


def _fill_inputs(log: Log, known: NDArray[np.int64]) -> Log:
    """Inputs of missing rows: interpolated, or as in the last known row."""
    rows, angle = np.arange(len(log.time)), log.table_angle
    before = known[np.clip(np.searchsorted(known, rows, side="right") - 1, 0, None)]
    columns = {name: getattr(log, name)[before] for name in COMMAND_COLUMNS}
    for name in LINEAR_INPUTS:
        columns[name] = np.interp(rows, known, getattr(log, name)[known])
    seen = np.flatnonzero(np.isfinite(angle))
    turns = PchipInterpolator(np.append(-1, seen), np.append(0.0, angle[seen]))
    columns["table_angle"] = np.where(np.isfinite(angle), angle, turns(rows))
    return replace_columns(log, columns)
