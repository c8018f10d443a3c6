"""Stretches in which a channel of the gyro stands still although it can't: they are left out."""

import numpy as np
from numpy.typing import NDArray

from pyhrg.common.units import DEG
from pyhrg.records.columns import COLUMNS
from pyhrg.records.table import Array, Table

FAST = 0.1 * DEG
"""Table rate that no dead zone holds and no bias hides, rad/s."""
SHORTEST_WHILE_TURNING = 3
"""Equal angles in a row that a turning table makes impossible."""
SHORTEST = 5
"""Equal values in a row that may be a saturated stretch at all."""
FALSE_ALARMS = 1e-6
"""Stretches as long that chance may give in a log."""


def without_saturation(table: Table, interval: float) -> Table:
    """Values of saturated stretches made NaN and noted.

    An angle is saturated where it repeats while the table turns. Any channel is, where it repeats
    for longer than the rest of the log under the same commands makes credible: its steps repeat
    with a share p, so that r repeats in a row out of n come about n p^r times by chance. A value
    that a channel has most of the time (a gyro without noise, a force that is off) is left alone,
    and so is one that merely waits for its next quantum: it enters and leaves by one or two.
    """
    turning = np.append(False, np.abs(np.diff(table.columns["table_angle"])) > FAST * interval)
    state = _states(table, turning)
    for column in COLUMNS:
        if column.role != "response":
            continue
        values = table.columns[column.field]
        stuck = _improbable(values, state)
        if column.field == "gyro_angle" or (
            column.field == "wave_angle" and not np.any(table.columns["virtual_rotation"])
        ):
            stuck |= _still(values, turning)
        table = table.noted(stuck, f"{column.name} stands still: saturated, left out")
        table = table.emptied(column.field, stuck)
    return table


def _states(table: Table, turning: NDArray[np.bool_]) -> NDArray[np.int64]:
    """(n,) number of the commanded state that each row is in."""
    state = turning.astype(np.int64)
    for column in COLUMNS:
        if column.role == "command":
            state = _coded(state, table.columns[column.field])
    return state


def _coded(state: NDArray[np.int64], values: Array) -> NDArray[np.int64]:
    """(n,) number of the pair of state and value that each row has."""
    codes = np.unique(values, return_inverse=True)[1]
    return np.unique(state * (codes.max() + 1) + codes, return_inverse=True)[1]


def _runs(same: NDArray[np.bool_]) -> tuple[NDArray[np.int64], NDArray[np.int64]]:
    """First and last row of each run of rows that equal the row before."""
    edges = np.diff(np.concatenate([[0], same.astype(np.int8), [0]]))
    return np.flatnonzero(edges == 1), np.flatnonzero(edges == -1)


def _marked(
    n: int, first: NDArray[np.int64], last: NDArray[np.int64], chosen: NDArray[np.bool_]
) -> NDArray[np.bool_]:
    edges = np.zeros(n + 1, dtype=np.int64)
    np.add.at(edges, first[chosen], 1)
    np.add.at(edges, last[chosen] + 1, -1)
    return np.cumsum(edges)[:-1] > 0


def _still(values: Array, turning: NDArray[np.bool_]) -> NDArray[np.bool_]:
    first, last = _runs((np.diff(values) == 0) & turning[1:])
    return _marked(len(values), first, last, last - first + 1 >= SHORTEST_WHILE_TURNING)


def _improbable(values: Array, state: NDArray[np.int64]) -> NDArray[np.bool_]:
    """Repeats of one value are held to how often the other values of the same state repeat."""
    inside = state[1:] == state[:-1]
    same = (np.diff(values) == 0) & inside
    first, last = _runs(same)
    if not len(first):
        return np.zeros(len(values), dtype=bool)
    level = _coded(state, values)
    here = np.bincount(level[1:][same])[level[first]]
    repeats = np.bincount(state[1:][same])[state[first]] - here
    others = np.bincount(state[1:][inside])[state[first]] - here
    share = (repeats + 1) / (others + 2)
    stuck = (
        (last - first + 1 >= SHORTEST)
        & (others >= here)
        & (others * share ** (last - first) < FALSE_ALARMS)
        & _jumps(values, first, last)
    )
    return _marked(len(values), first, last, stuck)


def _jumps(values: Array, first: NDArray[np.int64], last: NDArray[np.int64]) -> NDArray[np.bool_]:
    """Whether each run is entered or left by more than two quanta of the channel."""
    size = np.nan_to_num(np.abs(np.diff(values)))
    quantum = np.min(np.diff(np.unique(values[np.isfinite(values)])), initial=np.inf)
    edges = np.concatenate([[0.0], size, [0.0]])
    return np.maximum(edges[first], edges[last + 1]) > 2 * quantum
