"""Rows of a fast log joined to longer ones, as a campaign's log defines them."""

from dataclasses import replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from pyhrg.records import COLUMNS, Log, LogError
from pyhrg.records.columns import BY_FIELD

Array = NDArray[np.float64]

MEANS = (
    *("acceleration_x", "acceleration_y", "acceleration_z", "virtual_rotation"),
    *("amplitude_force", "quadrature_force", "frequency_offset", "valid"),
)
"""Means over a row; all else is taken at its end."""
HELD = tuple(c.field for c in COLUMNS if c.role == "command" and c.field not in MEANS)
"""Commands that hold over a row."""
WHOLE = 1e-3
"""Distance from a whole number, relative, of rows in a row."""
LEAST = 2
"""Rows of a log."""


def joined(log: Log, length: float) -> Log:
    """A log in rows of a length, counted from time 0: what is a mean over a row is the mean of
    those logged in it, all else is as in the last. Rows in which a logged one is missing are left
    out; a value is missing where one that it is made of is.

    Args:
        log: in shorter rows.
        length: s.

    Raises:
        LogError: the length is no multiple of the logged rows', a command changes within a row,
            fewer than two rows are whole.
    """
    count = round(length / log.interval)
    if count < 1 or abs(length / log.interval - count) > WHOLE * count:
        raise LogError(
            f"{log.source}: rows of {log.interval:g} s; expected rows_s, {length:g}, to be a "
            "multiple (interval_s says what a row is where times are rounded)"
        )
    place = np.round(log.time / length * count).astype(np.int64) - 1
    rows = _whole(place, count)
    if len(rows) < LEAST:
        raise LogError(
            f"{log.source}: {len(rows)} times {length:g} s without a missing row; expected {LEAST}"
        )
    columns: dict[str, Any] = {c.field: _of_rows(log, c.field, rows) for c in COLUMNS}
    columns["time"] = (place[rows[:, 0]] // count + 1) * length
    lost = len(log.time) - rows.size
    left = (f"{lost} rows that are not part of a whole {length:g} s: left out",) if lost else ()
    return replace(log, interval=length, exclusions=(*log.exclusions, *left), **columns)


def _whole(place: NDArray[np.int64], count: int) -> NDArray[np.int64]:
    """(k, count) logged rows of each row that has all of them.

    Args:
        place: (n,) of the logged rows, from 0.
        count: of logged rows in a row.
    """
    known = np.flatnonzero(place >= 0)
    known = known[np.append(True, np.diff(place[known]) > 0)] if len(known) else known
    first = np.flatnonzero(place[known] % count == 0)
    first = first[first + count <= len(known)]
    first = first[place[known[first + count - 1]] == place[known[first]] + count - 1]
    return np.asarray(known[first[:, None] + np.arange(count)])


def _of_rows(log: Log, field: str, rows: NDArray[np.int64]) -> Array:
    values = getattr(log, field)[rows]
    if field in MEANS:
        return np.asarray(values.mean(axis=1))
    if field in HELD:
        changed = np.fmax.reduce(values, axis=1) > np.fmin.reduce(values, axis=1)
        if changed.any():
            row = rows[int(np.argmax(changed))]
            raise LogError(
                f"{log.source}: column {BY_FIELD[field].name} changes between time_s "
                f"{log.time[row[0]]:g} and {log.time[row[-1]]:g}; expected it to be the same in a "
                "row: choose a shorter rows_s for this test, or an offset on time"
            )
    return np.asarray(values[:, -1])
