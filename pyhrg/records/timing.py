"""The times of a log: rows that came twice, time that runs back, gaps."""

import numpy as np
from numpy.typing import NDArray

from pyhrg.records.columns import BY_FIELD, LogError
from pyhrg.records.table import Array, Table

EVEN = (0.5, 1.5)
"""Time steps over the interval, from and to, that are one interval long."""
AGREEMENT = 0.01
"""Largest relative difference between the interval as stated and as found."""


def ordered(table: Table) -> Table:
    """Only rows that have a time, each once.

    A row that is repeated in full (a buffer sent twice) is dropped and noted.

    Raises:
        LogError: the same time with different values, or time that runs back.
    """
    lost = np.isnan(table.columns["time"])
    table = table.noted(lost, f"no {BY_FIELD['time'].name}, left out").kept(~lost)
    again = _repeated(table)
    table = table.noted(again, "an earlier row again, left out").kept(~again)
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


def _repeated(table: Table) -> NDArray[np.bool_]:
    """Rows that an earlier one equals."""
    values = np.stack(list(table.columns.values()), axis=-1)
    order = np.argsort(table.columns["time"], kind="stable")
    first, second = order[:-1], order[1:]
    same_time = table.columns["time"][first] == table.columns["time"][second]
    first, second = first[same_time], second[same_time]
    equal = (values[first] == values[second]) | (np.isnan(values[first]) & np.isnan(values[second]))
    different = np.flatnonzero(~equal.all(axis=1))
    if len(different):
        i = different[0]
        field = list(table.columns)[int(np.argmin(equal[i]))]
        raise table.error(
            int(second[i]),
            field,
            f"differs from row {table.rows[first[i]]} at the same time; expected one row a time",
        )
    again = np.zeros(len(values), dtype=bool)
    again[second] = True
    return again


def interval_of(table: Table, stated: float | None) -> float:
    """The sampling interval, s: as stated, else the median time step.

    Raises:
        LogError: the time steps contradict what is stated.
    """
    found = float(np.median(np.diff(table.columns["time"])))
    if stated is None:
        return found
    if abs(found - stated) > AGREEMENT * stated:
        raise LogError(
            f"{table.source}: {BY_FIELD['time'].name} steps by {found:g}; expected {stated:g}"
        )
    return stated


def even_steps(time: Array, interval: float) -> NDArray[np.bool_]:
    """(n - 1,) whether each step to the next row is one interval."""
    steps = np.diff(time) / interval
    return (steps >= EVEN[0]) & (steps <= EVEN[1])


def with_gaps_noted(table: Table, interval: float) -> Table:
    """With a sentence on gaps and on rows that came too soon."""
    steps = np.diff(table.columns["time"]) / interval
    gap = np.append(False, steps > EVEN[1])
    lost = round(float(np.sum(steps[gap[1:]] - 1)))
    table = table.noted(gap, f"a gap before each, {lost} rows missing in all")
    return table.noted(
        np.append(False, steps < EVEN[0]), "less than half an interval after the row before"
    )
