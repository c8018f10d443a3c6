"""Rows of a fast log, joined to longer ones."""

from dataclasses import replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from pyhrg.common.arrays import Array
from pyhrg.records.columns import BY_FIELD, COLUMNS, LogError
from pyhrg.records.log import Log

AVERAGED_FIELDS = (
    *("acceleration_x", "acceleration_y", "acceleration_z", "virtual_rotation"),
    *("amplitude_force", "quadrature_force", "frequency_offset", "valid"),
)
"""Fields that are means over a row; all others are values at its end."""
HELD_FIELDS = tuple(
    c.field for c in COLUMNS if c.role == "command" and c.field not in AVERAGED_FIELDS
)
"""Commands that must be constant in a row."""
RATIO_TOLERANCE = 1e-3
"""Largest relative departure from a whole number of logged rows in a row. Chosen."""
MIN_ROWS = 2
"""Smallest number of rows of a log."""


def join_rows(log: Log, length: float) -> Log:
    """A log in longer rows, counted from time 0.

    A field that is a mean over a row is the mean of the logged rows in it; any other is as in the
    last of them. Rows in which a logged one is missing are left out. A value is missing where one
    that it is made of is missing. The length of the longer rows is in s.
    """
    count = round(length / log.interval)
    if count < 1 or abs(length / log.interval - count) > RATIO_TOLERANCE * count:
        raise LogError(
            f"{log.source}: rows of {log.interval:g} s; expected rows_s, {length:g}, to be a "
            "multiple (interval_s says what a row is where times are rounded)"
        )
    place = np.round(log.time / length * count).astype(np.int64) - 1
    rows = _find_whole_rows(place, count)
    if len(rows) < MIN_ROWS:
        raise LogError(
            f"{log.source}: {len(rows)} times {length:g} s without a missing row; "
            f"expected {MIN_ROWS}"
        )
    columns: dict[str, Any] = {c.field: _join_values(log, c.field, rows) for c in COLUMNS}
    columns["time"] = (place[rows[:, 0]] // count + 1) * length
    unused = len(log.time) - rows.size
    note = (f"{unused} rows that are not part of a whole {length:g} s: left out",) if unused else ()
    return replace(log, interval=length, exclusions=(*log.exclusions, *note), **columns)


def _find_whole_rows(place: NDArray[np.int64], count: int) -> NDArray[np.int64]:
    """(k, count) indices of the logged rows of each longer row that has all of them, from (n,) the
    number of each logged row since time 0."""
    known = np.flatnonzero(place >= 0)
    known = known[np.append(True, np.diff(place[known]) > 0)] if len(known) else known
    first = np.flatnonzero(place[known] % count == 0)
    first = first[first + count <= len(known)]
    first = first[place[known[first + count - 1]] == place[known[first]] + count - 1]
    return np.asarray(known[first[:, None] + np.arange(count)])


def _join_values(log: Log, field: str, rows: NDArray[np.int64]) -> Array:
    values = getattr(log, field)[rows]
    if field in AVERAGED_FIELDS:
        return np.asarray(values.mean(axis=1))
    if field in HELD_FIELDS:
        changed = np.fmax.reduce(values, axis=1) > np.fmin.reduce(values, axis=1)
        if changed.any():
            row = rows[int(np.argmax(changed))]
            raise LogError(
                f"{log.source}: column {BY_FIELD[field].name} changes between time_s "
                f"{log.time[row[0]]:g} and {log.time[row[-1]]:g}; expected it to be the same in a "
                "row: choose a shorter rows_s for this test, or an offset on time"
            )
    return np.asarray(values[:, -1])
