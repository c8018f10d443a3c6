"""Readings that are off by themselves, while all around is steady: a word lost on its way."""

from collections.abc import Iterator

import numpy as np
from numpy.lib.stride_tricks import sliding_window_view
from numpy.typing import NDArray
from scipy.ndimage import binary_dilation

from pyhrg.common.robust import robust_deviation
from pyhrg.gap.replay.observations import CHANNELS, FORCES, commanded, jolts, later, settling
from pyhrg.gap.replay.replay import replayable
from pyhrg.gap.soundness.attitude import ACCELERATIONS
from pyhrg.gap.soundness.doubt import Array, Believed, Doubt, has, with_columns
from pyhrg.records import Log
from pyhrg.records.columns import BY_FIELD

Mask = NDArray[np.bool_]

INPUTS = ("table_angle", "temperature", *ACCELERATIONS)
"""Measured by the bench, and smooth."""
LONGEST = 3
"""Readings that are off together."""
PASSES = 2
"""In which they are looked for: a glitch hides its neighbours."""
AROUND = 4
"""Steps from row to row, before and after, that are to be steady; as many in all at the least."""
BEFORE, AFTER = 2, 1
"""Of them, at the least."""
OTHERS = 2
"""Of them, that may be a glitch's of its own."""
OFF = 10.0
"""Deviations of steps from row to row."""
APART = 5.0
"""Of a glitch over the unsteadiest step around."""
TWICE = 2.0
"""Of a glitch over the largest step of all other rows, a few aside."""
REACH = 2 * AROUND + LONGEST
"""Rows in which a glitch can be seen."""
LEAST = 50
"""Rows below which a column's noise can't be told."""
FEW, SHARE = 3, 2e-3
"""Glitches of a column that are none if they are more: rows, or share of rows."""
TOLD = 3
"""Glitches of a column that are told one by one."""


def with_inputs_mended(log: Log) -> tuple[Log, list[str]]:
    """A log with glitches of what the bench measures filled in from those around, and what was."""
    notes = []
    for field in INPUTS:
        series = getattr(log, field)
        known = np.isfinite(series)
        found = glitches(series, known)
        if found.any():
            notes.append(f"{_told(log, field, found)}: filled in")
            log = with_columns(log, {field: _filled(series, found, known)})
    return log, notes


def doubts_of_glitches(log: Log, believed: Believed) -> list[Doubt]:
    """Of the gyro's readings while loops follow a steady table; inputs are whole."""
    if not has(log, "gyro_angle", "wave_angle"):
        return []
    inputs = replayable(log, believed.device)
    steady = later(log, commanded(log) | jolts(inputs), settling(believed.device))
    return list(_doubts(log, steady))


def _doubts(log: Log, rows: Mask) -> Iterator[Doubt]:
    for field in CHANNELS:
        series = getattr(log, field)
        driven = (log.drive_on > 0) | (field not in FORCES)
        found = glitches(series, rows & driven & np.isfinite(series))
        if found.any():
            fields = ("gyro_angle", "wave_angle") if field == "gyro_angle" else (field,)
            yield Doubt(fields, f"{_told(log, field, found)}: left out", found)


def _told(log: Log, field: str, found: Mask) -> str:
    """Row, what was found, and what those around it say."""
    column, series = BY_FIELD[field], getattr(log, field)
    said, around = (
        (values[found] - column.offset) / column.factor
        for values in (series, _filled(series, found, np.isfinite(series)))
    )
    each = [
        f"{one:.9g} at time_s {time:g}, expected {other:.9g} as around it"
        for one, other, time in zip(said, around, log.time[found], strict=True)
    ]
    more = [f"{len(each) - TOLD} more"] if len(each) > TOLD else []
    return f"{log.source}: column {column.name}: {'; '.join(each[:TOLD] + more)}"


def _filled(series: Array, found: Mask, known: Mask) -> Array:
    """A series with what was found in line with those known around it."""
    kept = np.flatnonzero(known & ~found)
    return np.where(found, np.interp(np.arange(len(series)), kept, series[kept]), series)


def glitches(series: Array, rows: Mask) -> Mask:
    """Rows that leave a series and come back at once, while all around it is steady.

    Args:
        series: (n,) any unit, a straight line and noise where nothing is wrong.
        rows: (n,) that may be looked at.

    Returns:
        (n,); none where they are many, or no larger than what is seen elsewhere: a noise of the
        gyro's own, or counts.
    """
    found = np.zeros(len(series), np.bool_)
    if np.sum(rows) < LEAST:
        return found
    mended, sizes = series, np.zeros(len(series))
    for _ in range(PASSES):
        for length in range(1, LONGEST + 1):
            new = _of_length(mended, rows, length)
            if new.any():
                sizes = np.where(found, sizes, new)
                found |= new > 0
                mended = _filled(series, found, rows)
        if not found.any():
            return found
    elsewhere = np.sort(_departures(series, rows & ~binary_dilation(found, iterations=REACH)))
    found &= sizes > TWICE * (elsewhere[-1 - 2 * FEW] if len(elsewhere) > 2 * FEW else 0.0)
    return found & (np.sum(found) <= max(FEW, SHARE * np.sum(rows)))


def _departures(series: Array, rows: Mask) -> Array:
    """Sizes of single steps less those around."""
    steps = _windows(series, rows, 0)
    steady, _, usable = _steady(steps, 0)
    away = np.abs(steps[:, AROUND] - steady)
    return np.asarray(away[usable & np.isfinite(away)])


def _windows(series: Array, rows: Mask, length: int) -> Array:
    """(n, w) steps to a glitch of so many rows from each row on, in it, from it, and around; NaN
    where one is not of rows that may be looked at."""
    steps = np.where(rows[1:] & rows[:-1], np.diff(series), np.nan)
    before, after = np.full(AROUND + 1, np.nan), np.full(AROUND + length, np.nan)
    return sliding_window_view(np.concatenate([before, steps, after]), 2 * AROUND + length + 1)


def _steady(steps: Array, length: int) -> tuple[Array, Array, Mask]:
    """Of windows: median of the steps around, the largest distance from it but for a few, and
    whether there are enough of them."""
    around = np.delete(steps, np.s_[AROUND : AROUND + length + 1], axis=1)
    known = np.isfinite(around)
    usable = known.sum(axis=1) >= AROUND
    usable &= (known[:, :AROUND].sum(axis=1) >= BEFORE) & (known[:, AROUND:].sum(axis=1) >= AFTER)
    ordered = np.sort(around, axis=1)
    last = np.maximum(known.sum(axis=1) - 1, 0)
    median = (_at(ordered, last // 2) + _at(ordered, (last + 1) // 2)) / 2
    apart = np.sort(np.abs(around - median[:, None]), axis=1)
    return median, _at(apart, np.maximum(last - OTHERS, 0)), usable


def _at(values: Array, columns: NDArray[np.int64]) -> Array:
    """(n,) one of each row's."""
    return np.asarray(np.take_along_axis(values, columns[:, None], 1)[:, 0])


def _of_length(series: Array, rows: Mask, length: int) -> Array:
    """(n,) sizes of glitches of so many rows; 0 where there are none."""
    steps = _windows(series, rows, length)
    inside = steps[:, AROUND : AROUND + length + 1]
    steady, unsteady, usable = _steady(steps, length)
    away, back = inside[:, 0] - steady, steady - inside[:, -1]
    left = inside.sum(axis=1) - (length + 1) * steady
    size = np.where(away * back > 0, np.minimum(np.abs(away), np.abs(back)), 0.0)
    usable &= np.isfinite(left)
    least = np.maximum(OFF * _deviation(away[usable]), APART * unsteady)
    sizes = np.zeros(len(series))
    for first in np.flatnonzero(usable & (size > least) & (np.abs(left) < size / 2)):
        sizes[first : first + length] = size[first]
    return sizes


def _deviation(values: Array) -> float:
    """Standard deviation of noise, or of all but a few where half of the values are one."""
    sizes = np.sort(np.abs(values))
    if not len(sizes):
        return 0.0
    if sizes[len(sizes) // 2] > 0:
        return robust_deviation(sizes)
    rest = sizes[: -int(max(2 * FEW, 2 * SHARE * len(sizes)))]
    return float(np.sqrt(np.mean(rest**2))) if len(rest) else 0.0
