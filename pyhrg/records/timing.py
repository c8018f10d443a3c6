"""Times of a log: repeated rows, time that runs back, gaps."""

import numpy as np
from numpy.typing import NDArray

from pyhrg.common.arrays import Array
from pyhrg.records.columns import BY_FIELD, LogError
from pyhrg.records.table import Table

EVEN_STEP_RANGE = (0.5, 1.5)
"""Smallest and largest ratio of a time step to the interval that counts as one interval. Chosen."""
INTERVAL_TOLERANCE = 0.01
"""Largest relative difference between the stated interval and the median time step. Chosen."""


INTERVAL_RANGE = (1e-6, 1e6)
"""Shortest and longest interval, s. Chosen."""
MAX_SPARSENESS = 100
"""Largest ratio of the intervals that a log spans to its rows. Chosen: missing rows take memory."""
FREE_ROWS = 1_000_000
"""Intervals up to which the ratio is not looked at. Chosen: they fill no memory."""


def drop_repeated_rows(table: Table) -> Table:
    """The table without rows that have no time or repeat an earlier row in full; both are noted."""
    is_lost = np.isnan(table.columns["time"])
    table = table.add_note(is_lost, f"no {BY_FIELD['time'].name}, left out").keep_rows(~is_lost)
    is_repeated = _find_repeated_rows(table)
    table = table.add_note(is_repeated, "an earlier row again, left out").keep_rows(~is_repeated)
    time = table.columns["time"]
    if len(time) < 2:
        raise LogError(f"{table.source}: {len(time)} rows with a time; expected at least 2")
    back = np.flatnonzero(np.diff(time) < 0)
    if len(back):
        row = int(back[0]) + 1
        raise table.error(
            row, "time", f"{time[row]:g} after {time[row - 1]:g}; expected time to increase"
        )
    return table


def _find_repeated_rows(table: Table) -> NDArray[np.bool_]:
    values = np.stack(list(table.columns.values()), axis=-1)
    order = np.argsort(table.columns["time"], kind="stable")
    first, second = order[:-1], order[1:]
    same_time = table.columns["time"][first] == table.columns["time"][second]
    first, second = first[same_time], second[same_time]
    equal = np.isclose(values[first], values[second], rtol=0, atol=0, equal_nan=True)
    different = np.flatnonzero(~equal.all(axis=1))
    if len(different):
        i = different[0]
        field = list(table.columns)[int(np.argmin(equal[i]))]
        raise table.error(
            int(second[i]),
            field,
            f"differs from row {table.rows[first[i]]} at the same time; expected one row a time",
        )
    is_repeated = np.zeros(len(values), dtype=bool)
    is_repeated[second] = True
    return is_repeated


def find_interval(table: Table, stated: float | None) -> float:
    """The sampling interval, s: the stated one, or else the median time step.

    Raises:
        LogError: the time steps contradict the stated interval, no log has such an interval, or
            almost all rows are missing between its first and its last time.
    """
    time = table.columns["time"]
    median_step = float(np.median(np.diff(time)))
    interval = median_step if stated is None else stated
    low, high = INTERVAL_RANGE
    if not low <= interval <= high:
        found = f"{table.source}: {BY_FIELD['time'].name} steps by {interval:g}"
        raise LogError(f"{found}; expected {low:g} to {high:g}")
    spanned, most = (time[-1] - time[0]) / interval, max(FREE_ROWS, MAX_SPARSENESS * len(time))
    if spanned > most:
        raise LogError(
            f"{table.source}: {BY_FIELD['time'].name}: {len(time)} rows span {spanned:.4g} times "
            f"{interval:g} s; expected at most {most:g}"
        )
    if abs(median_step - interval) > INTERVAL_TOLERANCE * interval:
        found = f"{table.source}: {BY_FIELD['time'].name} steps by {median_step:g}"
        raise LogError(f"{found}; expected {interval:g}")
    return interval


def find_even_steps(time: Array, interval: float) -> NDArray[np.bool_]:
    """(n - 1,) whether the step to the next row is one interval long."""
    steps = np.diff(time) / interval
    return (steps >= EVEN_STEP_RANGE[0]) & (steps <= EVEN_STEP_RANGE[1])


def note_gaps(table: Table, interval: float) -> Table:
    """The table with a sentence on gaps and one on rows that came too soon."""
    steps = np.diff(table.columns["time"]) / interval
    gap = np.append(False, steps > EVEN_STEP_RANGE[1])
    lost = round(float(np.sum(steps[gap[1:]] - 1)))
    table = table.add_note(gap, f"a gap before each, {lost} rows missing in all")
    return table.add_note(
        np.append(False, steps < EVEN_STEP_RANGE[0]),
        "less than half an interval after the row before",
    )
