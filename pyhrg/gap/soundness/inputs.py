"""A log's inputs made whole, so that they can be replayed; what is taken for granted is said."""

from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from pyhrg.gap.soundness.attitude import ACCELERATIONS
from pyhrg.gap.soundness.doubt import Believed, has, with_columns
from pyhrg.records import COLUMNS, Log, LogError
from pyhrg.records.columns import BY_FIELD

MOST_AT_START = 0.01
"""Share of rows that may be missing before the first one."""
MOST_MISSING = 0.2
"""Share of rows up to which the rest of a log is worth replaying."""
STEADY = 1e-3
"""Relative change of the table's rate about a gap that is none."""
STILL = 1e-6
"""Turn of the table that is none, rad."""
COMMANDS = ("axis_up", "virtual_rotation", "amplitude_setpoint", "phase_offset", "drive_on")
LINEAR = ("table_angle", "temperature", *ACCELERATIONS)


class InputError(LogError):
    """What was done to the gyro can't be told; the message names file, row, column."""


def whole(log: Log, believed: Believed) -> tuple[Log, list[str]]:
    """A log with every row from its start, its inputs known in each; outputs NaN where they are
    missing.

    A column that isn't there is taken to be as on a gyro at rest. Rows that are missing are filled
    where the table kept its rate and no command changed; a log is cut where that can't be told.

    Raises:
        InputError: too many rows are missing, or the start is; attitude is not there.
    """
    log, notes = _with_columns(log, believed)
    log, lost = _on_grid(log)
    cut, trouble = _cut(log, lost)
    if trouble:
        notes.append(trouble)
        log, lost = _first(log, cut), lost[:cut]
    known = np.flatnonzero(~lost)
    if len(known) < (1 - MOST_MISSING) * len(lost) or len(known) < 2:
        raise InputError(
            f"{log.source}: {np.sum(lost)} of {len(lost)} rows missing; expected at most "
            f"{MOST_MISSING:.0%}"
        )
    if lost.any():
        log = _filled(log, known)
        notes.append(f"{log.source}: {np.sum(lost)} missing rows: inputs filled in, outputs not")
    return log, notes


def _with_columns(log: Log, believed: Believed) -> tuple[Log, list[str]]:
    """Columns of inputs that aren't there, as on a gyro at rest."""
    if not has(log, "axis_up"):
        if not has(log, "acceleration_z"):
            raise InputError(
                f"{log.source}: columns axis_up and accel_z_m_s2 missing; expected one"
            )
        up = np.clip(np.round(log.acceleration_z / believed.site.gravity, 2), -1, 1)
        with_up, notes = _with_columns(replace(log, axis_up=up), believed)
        return with_up, [f"{log.source}: axis_up: not there, taken from accel_z_m_s2", *notes]
    ones = np.ones(len(log.time))
    level = believed.site.gravity * np.sqrt(np.clip(1 - log.axis_up**2, 0, None))
    defaults = {
        "table_angle": 0 * ones,
        "virtual_rotation": 0 * ones,
        "amplitude_setpoint": believed.device.amplitude * ones,
        "phase_offset": 0 * ones,
        "drive_on": ones,
        "temperature": believed.device.reference_temperature * ones,
        "acceleration_x": level,
        "acceleration_y": 0 * ones,
        "acceleration_z": believed.site.gravity * log.axis_up,
    }
    taken = {field: values for field, values in defaults.items() if not has(log, field)}
    names = ", ".join(BY_FIELD[field].name for field in taken)
    notes = [f"{log.source}: {names}: not there, taken as on a gyro at rest"] if taken else []
    return with_columns(log, taken), notes


def _on_grid(log: Log) -> tuple[Log, NDArray[np.bool_]]:
    """Rows at every interval from the start, NaN where there was none; whether inputs miss."""
    place = np.round(log.time / log.interval).astype(np.int64) - 1
    if place[0] < 0 or place[-1] >= len(place) / (1 - MOST_MISSING):
        raise InputError(
            f"{log.source}: time_s {log.time[0]:.6g} to {log.time[-1]:.6g} in {len(place)} rows; "
            f"expected {log.interval:g} to {len(place) * log.interval:g}, few rows missing"
        )
    if not np.array_equal(place, np.arange(len(place))):
        empty = np.full(place[-1] + 1, np.nan)
        columns = {column.field: empty.copy() for column in COLUMNS}
        for field, values in columns.items():
            values[place] = getattr(log, field)
        log = with_columns(log, columns)
    grid = np.arange(1, len(log.time) + 1) * log.interval
    late = np.where(np.isfinite(log.time), log.time, grid)
    inputs = np.stack([getattr(log, field) for field in (*COMMANDS, *LINEAR)])
    return replace(log, time=late), ~np.isfinite(inputs).all(axis=0)


def _cut(log: Log, lost: NDArray[np.bool_]) -> tuple[int, str]:
    """Rows up to which inputs can be told, and why not beyond."""
    edges = np.diff(np.concatenate([[0], lost.astype(np.int8), [0]]))
    begins, ends = np.flatnonzero(edges == 1).tolist(), np.flatnonzero(edges == -1).tolist()
    for first, end in zip(begins, ends, strict=True):
        if end == len(lost):
            return first, f"{log.source}: inputs missing from time_s {log.time[first]:g} to the end"
        if first == 0 and end > MOST_AT_START * len(lost):
            raise InputError(f"{log.source}: {end} rows are missing before the first one")
        if not (_steady(log, first, end) and _same_commands(log, first, end)):
            time = log.time[first]
            if first == 0:
                raise InputError(f"{log.source}: the start is missing, to time_s {log.time[end]:g}")
            reason = f"inputs missing from time_s {time:g} on, while they changed"
            return first, f"{log.source}: {reason}: cut there"
    return len(lost), ""


def _steady(log: Log, first: int, end: int) -> bool:
    """Whether the table kept its rate over rows that are missing; before the start it rested."""
    angle, interval = log.table_angle, log.interval
    if first == 0:
        return bool(abs(angle[end]) < STILL)
    across = (angle[end] - angle[first - 1]) / (end - first + 1) / interval
    before = (angle[first - 1] - (angle[first - 2] if first > 1 else 0.0)) / interval
    after = (angle[end + 1] - angle[end]) / interval if end + 1 < len(angle) else across
    allowed = STEADY * abs(across) + STILL / interval
    return bool(max(abs(before - across), abs(after - across)) <= allowed)


def _same_commands(log: Log, first: int, end: int) -> bool:
    return first == 0 or all(
        getattr(log, field)[first - 1] == getattr(log, field)[end] for field in COMMANDS
    )


def _first(log: Log, n: int) -> Log:
    return with_columns(log, {c.field: getattr(log, c.field)[:n] for c in COLUMNS})


def _filled(log: Log, known: NDArray[np.int64]) -> Log:
    rows = np.arange(len(log.time))
    columns = {}
    for field in LINEAR:
        columns[field] = np.interp(rows, known, getattr(log, field)[known])
    before = known[np.clip(np.searchsorted(known, rows, side="right") - 1, 0, None)]
    for field in COMMANDS:
        columns[field] = getattr(log, field)[before]
    return with_columns(log, columns)
