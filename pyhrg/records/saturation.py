"""Finds stretches in which a channel of the gyro stands still although it can't; they are left
out."""

import numpy as np
from numpy.typing import NDArray

from pyhrg.common.arrays import Array, Mask
from pyhrg.common.units import DEG
from pyhrg.records.columns import COLUMNS
from pyhrg.records.table import Table

MOVING_TABLE_RATE = 0.1 * DEG
"""Table rate above which the table turns, rad/s. Chosen: no dead zone holds against it and no bias
hides it."""
MIN_RUN_WHILE_TURNING = 3
"""Smallest number of successive equal angles that a turning table makes impossible."""
MIN_RUN = 5
"""Smallest number of successive equal values that is looked at. Chosen."""
FALSE_ALARM_COUNT = 1e-6
"""A run is saturated if fewer runs as long are expected by chance in the log. Chosen."""


def remove_saturation(table: Table, interval: float) -> Table:
    """The table without the values of saturated stretches, which are noted.

    An angle is saturated where it repeats while the table turns. Any channel is saturated where a
    run of equal values is improbably long, given how often values repeat in the other rows under
    the same commands: if a share p of n steps repeats the value before, then r repeats in
    succession are expected n p^r times by chance. Two kinds of runs are left alone: a value that a
    channel has most of the time (a gyro without noise, a force that is off), and a run that is
    entered and left by one or two quantization steps, as in a channel that changes slowly.
    """
    turning = np.append(
        False, np.abs(np.diff(table.columns["table_angle"])) > MOVING_TABLE_RATE * interval
    )
    state = turning.astype(np.int64)  # numbers what a row is in: its commands, and whether it turns
    for column in COLUMNS:
        if column.role == "command":
            state = _number_pairs(state, table.columns[column.field])
    for column in COLUMNS:
        if column.role != "response":
            continue
        values = table.columns[column.field]
        is_stuck = _find_improbable_runs(values, state)
        is_turned = column.field == "wave_angle" and not table.columns["virtual_rotation"].any()
        if column.field == "gyro_angle" or is_turned:
            first, last = find_runs((np.diff(values) == 0) & turning[1:])
            is_long = last - first + 1 >= MIN_RUN_WHILE_TURNING
            is_stuck |= _mark_runs(len(values), first, last, is_long)
        table = table.add_note(is_stuck, f"{column.name} stands still: saturated, left out")
        table = table.clear_values(column.field, is_stuck)
    return table


def _number_pairs(state: NDArray[np.int64], values: Array) -> NDArray[np.int64]:
    """(n,) number of the pair of state and value in each row."""
    codes = np.unique(values, return_inverse=True)[1]
    return np.unique(state * (codes.max() + 1) + codes, return_inverse=True)[1]


def find_runs(same: Mask) -> tuple[NDArray[np.int64], NDArray[np.int64]]:
    """First and last row of each run, from (n - 1,) whether a row equals the row before."""
    edges = np.diff(np.concatenate([[0], same.astype(np.int8), [0]]))
    return np.flatnonzero(edges == 1), np.flatnonzero(edges == -1)


def _mark_runs(n: int, first: NDArray[np.int64], last: NDArray[np.int64], chosen: Mask) -> Mask:
    edges = np.zeros(n + 1, dtype=np.int64)
    np.add.at(edges, first[chosen], 1)
    np.add.at(edges, last[chosen] + 1, -1)
    return np.cumsum(edges)[:-1] > 0


def _find_improbable_runs(values: Array, state: NDArray[np.int64]) -> Mask:
    """(n,) rows of runs that are improbable by how often other values of the same state repeat."""
    inside = state[1:] == state[:-1]
    same = (np.diff(values) == 0) & inside
    first, last = find_runs(same)
    if not len(first):
        return np.zeros(len(values), dtype=bool)
    level = _number_pairs(state, values)
    here = np.bincount(level[1:][same])[level[first]]
    repeats = np.bincount(state[1:][same])[state[first]] - here
    others = np.bincount(state[1:][inside])[state[first]] - here
    share = (repeats + 1) / (others + 2)
    is_stuck = (
        (last - first + 1 >= MIN_RUN)
        & (others >= here)
        & (others * share ** (last - first) < FALSE_ALARM_COUNT)
        & _is_jump(values, first, last)
    )
    return _mark_runs(len(values), first, last, is_stuck)


def _is_jump(values: Array, first: NDArray[np.int64], last: NDArray[np.int64]) -> Mask:
    """(m,) whether a run is entered or left by more than two quantization steps of the channel."""
    size = np.nan_to_num(np.abs(np.diff(values)))
    quantization_step = np.min(np.diff(np.unique(values[np.isfinite(values)])), initial=np.inf)
    edges = np.concatenate([[0.0], size, [0.0]])
    return np.maximum(edges[first], edges[last + 1]) > 2 * quantization_step
