"""Times of a log: repeated rows, time that runs back, gaps."""

import numpy as np
from numpy.typing import NDArray

from pyhrg.common.arrays import Array, Mask
from pyhrg.records.columns import BY_FIELD, LogError
from pyhrg.records.table import Table

EVEN_STEP_RANGE = (0.5, 1.5)
"""Smallest and largest ratio of a time step to the interval that counts as one interval. Chosen."""
INTERVAL_TOLERANCE = 0.01
"""Largest relative difference between the stated interval and the median time step. Chosen."""


INTERVAL_RANGE = (1e-6, 1e6)
"""Shortest and longest interval, s. Chosen."""
MAX_WRONG_SHARE = 0.005
"""Largest share of rows that are left out because they contradict each other or are out of order.
Chosen: more is another recorder's log."""
RESTART_SHARE = 0.5
"""Share of a log's time so far, below which a time that runs back begins the log again. Chosen."""
MAX_SPARSENESS = 100
"""Largest ratio of the intervals that a log spans to its rows. Chosen: missing rows take memory."""
FREE_ROWS = 1_000_000
"""Intervals up to which the ratio is not looked at. Chosen: they fill no memory."""


def drop_wrong_rows(table: Table) -> Table:
    """The table without rows that have no time, repeat an earlier row in full, contradict another
    of the same time, or are out of order; each is noted.

    Raises:
        LogError: more than a few rows contradict each other or are out of order, or too few are
            left.
    """
    is_lost = np.isnan(table.columns["time"])
    table = table.add_note(is_lost, f"no {BY_FIELD['time'].name}, left out").keep_rows(~is_lost)
    is_repeated = _find_repeated_rows(table)
    table = table.add_note(is_repeated, "an earlier row again, left out").keep_rows(~is_repeated)
    table = _drop_few(table, _find_contradicting_rows(table), "two rows of one time, left out")
    table = _drop_few(table, _find_disordered_rows(table), "out of order, left out")
    if len(table.rows) < 2:
        raise LogError(f"{table.source}: {len(table.rows)} rows with a time; expected at least 2")
    return table


def _drop_few(table: Table, wrong: Mask, trouble: str) -> Table:
    """The table without wrong rows, with a note on them; many are refused."""
    if np.sum(wrong) > MAX_WRONG_SHARE * len(wrong):
        _refuse_disorder(table)
    return table.add_note(wrong, trouble).keep_rows(~wrong)


def _refuse_disorder(table: Table) -> None:
    """Raise the error on the first row that contradicts another, or whose time runs back."""
    time = table.columns["time"]
    values, (first, second) = _stack_values(table), _pair_rows_of_one_time(table)
    back = np.flatnonzero(np.diff(time) < 0)
    if len(back) == 1 and time[back[0] + 1] <= time[0] + (time[back[0]] - time[0]) * RESTART_SHARE:
        raise table.error(
            int(back[0]) + 1,
            "time",
            f"{time[back[0] + 1]:g} after {time[back[0]]:g}: the log begins again; expected a file "
            "for each part",
        )
    if len(first):
        differs = ~_are_equal(values[first[0]], values[second[0]])
        raise table.error(
            int(second[0]),
            list(table.columns)[int(np.argmax(differs))],
            f"differs from row {table.rows[first[0]]} at the same time; expected one row a time",
        )
    row = int(np.flatnonzero(np.diff(time) < 0)[0]) + 1
    raise table.error(
        row, "time", f"{time[row]:g} after {time[row - 1]:g}; expected time to increase"
    )


def _find_disordered_rows(table: Table) -> Mask:
    """Rows that come after a later one, and the later ones: which of them is wrong is not known."""
    time = table.columns["time"]
    if not len(time):
        return np.zeros(0, dtype=bool)
    later = np.minimum.accumulate(time[::-1])[::-1]
    return np.asarray((time < np.maximum.accumulate(time)) | (time > later))


def _find_contradicting_rows(table: Table) -> Mask:
    """Rows whose time another row has too, with other values."""
    wrong = np.zeros(len(table.rows), dtype=bool)
    for rows in _pair_rows_of_one_time(table):
        wrong[rows] = True
    return wrong


def _find_repeated_rows(table: Table) -> Mask:
    first, second = _pair_rows_of_one_time(table)
    values = _stack_values(table)
    is_repeated = np.zeros(len(values), dtype=bool)
    is_repeated[second[_are_equal(values[first], values[second]).all(axis=1)]] = True
    return is_repeated


def _pair_rows_of_one_time(table: Table) -> tuple[NDArray[np.int64], NDArray[np.int64]]:
    """Rows whose time the next one in time has too, and those next ones."""
    time = table.columns["time"]
    order = np.argsort(time, kind="stable")
    same = time[order[:-1]] == time[order[1:]]
    return order[:-1][same], order[1:][same]


def _stack_values(table: Table) -> Array:
    return np.stack(list(table.columns.values()), axis=-1)


def _are_equal(first: Array, second: Array) -> Mask:
    return np.isclose(first, second, rtol=0, atol=0, equal_nan=True)


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


def find_even_steps(time: Array, interval: float) -> Mask:
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
