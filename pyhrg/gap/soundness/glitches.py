"""Readings that are off by themselves, while all around is steady: a word lost on its way."""

from collections.abc import Iterator

import numpy as np
from numpy.lib.stride_tricks import sliding_window_view
from numpy.typing import NDArray
from scipy.ndimage import binary_dilation

from pyhrg.gap.observations import CHANNELS, commanded, jolts, later, settling
from pyhrg.gap.replay import replayable
from pyhrg.gap.soundness.doubt import Array, Believed, Doubt, has
from pyhrg.records import Log
from pyhrg.records.columns import BY_FIELD

Mask = NDArray[np.bool_]

LONGEST = 3
"""Readings that are off together."""
AROUND = 4
"""Steps from row to row, before and after, that are to be steady."""
OFF = 10.0
"""Deviations of steps from row to row."""
APART = 5.0
"""Of a glitch over the unsteadiest step around."""
TWICE = 2.0
"""Of a glitch over the largest step of all other rows."""
REACH = 2 * AROUND + LONGEST
"""Rows in which a glitch can be seen."""
MAD = 1.4826
"""Standard deviation over the median of magnitudes, of normal numbers."""
FEW, SHARE = 3, 2e-3
"""Glitches of a column that are none if they are more: rows, or share of rows."""
TOLD = 3
"""Glitches of a column that are told one by one."""


def doubts_of_temperature_glitches(log: Log) -> list[Doubt]:
    """Of the thermometer's."""
    return list(_doubts(log, {"temperature": np.ones(len(log.time), np.bool_)}))


def doubts_of_glitches(log: Log, believed: Believed) -> list[Doubt]:
    """Of the gyro's readings while loops follow a steady table; inputs are whole."""
    if not has(log, "gyro_angle", "wave_angle"):
        return []
    inputs = replayable(log, believed.device)
    steady = later(log, commanded(log) | jolts(inputs), settling(believed.device))
    return list(_doubts(log, dict.fromkeys(CHANNELS, steady)))


def _doubts(log: Log, where: dict[str, Mask]) -> Iterator[Doubt]:
    for field, rows in where.items():
        series = getattr(log, field)
        found = glitches(series, rows & np.isfinite(series))
        if found.any():
            fields = ("gyro_angle", "wave_angle") if field == "gyro_angle" else (field,)
            yield Doubt(fields, _told(log, field, found), found)


def _told(log: Log, field: str, found: Mask) -> str:
    """Row, what was found, and what those around it say."""
    column, series = BY_FIELD[field], getattr(log, field)
    kept = np.flatnonzero(np.isfinite(series) & ~found)
    rows = np.flatnonzero(found)
    said, around = (
        (values - column.offset) / column.factor
        for values in (series[rows], np.interp(rows, kept, series[kept]))
    )
    each = [
        f"{one:.9g} at time_s {time:g}, expected {other:.9g} as around it"
        for one, other, time in zip(said, around, log.time[rows], strict=True)
    ]
    more = [f"{len(each) - TOLD} more"] if len(each) > TOLD else []
    return f"{log.source}: column {column.name}: {'; '.join(each[:TOLD] + more)}: left out"


def glitches(series: Array, rows: Mask) -> Mask:
    """Rows that leave a series and come back at once, while all around it is steady.

    Args:
        series: (n,) any unit, a straight line and noise where nothing is wrong.
        rows: (n,) that may be looked at.

    Returns:
        (n,); none where they are many, or no larger than what is seen elsewhere: a noise of the
        gyro's own, or counts.
    """
    sizes = np.zeros(len(series))
    for length in range(1, LONGEST + 1):
        sizes += _of_length(series, rows & (sizes == 0), length)
    found = sizes > 0
    if not found.any():
        return found
    near = binary_dilation(found, iterations=REACH)
    elsewhere = np.max(np.abs(_departures(series, rows & ~near)), initial=0.0)
    found &= sizes > TWICE * elsewhere
    return found & (np.sum(found) <= max(FEW, SHARE * np.sum(rows)))


def _departures(series: Array, rows: Mask) -> Array:
    """Of single steps from those around, where all are of rows that may be looked at."""
    steps, usable = _windows(series, rows, 0)
    return np.asarray((steps[:, AROUND] - np.median(_around(steps, 0), axis=1))[usable])


def _windows(series: Array, rows: Mask, length: int) -> tuple[Array, Mask]:
    """(k, w) steps of a glitch of so many rows and around it, from each row on; (k,) whether all
    are of rows that may be looked at."""
    width = 2 * AROUND + length + 1
    if len(series) <= width:
        return np.empty((0, width)), np.empty(0, np.bool_)
    steps = sliding_window_view(np.diff(series), width)
    usable = sliding_window_view(rows, width + 1).all(axis=1)
    return steps, np.asarray(usable)


def _around(steps: Array, length: int) -> Array:
    return np.delete(steps, np.s_[AROUND : AROUND + length + 1], axis=1)


def _of_length(series: Array, rows: Mask, length: int) -> Array:
    """(n,) sizes of glitches of so many rows; 0 where there are none."""
    steps, usable = _windows(series, rows, length)
    around = _around(steps, length)
    steady = np.median(around, axis=1)
    unsteady = np.max(np.abs(around - steady[:, None]), axis=1)
    away, back = steps[:, AROUND] - steady, steady - steps[:, AROUND + length]
    left = np.sum(steps[:, AROUND : AROUND + length + 1], axis=1) - (length + 1) * steady
    size = np.where(away * back > 0, np.minimum(np.abs(away), np.abs(back)), 0.0)
    deviation = _deviation(away[usable])
    is_glitch = usable & (size > np.maximum(OFF * deviation, APART * unsteady))
    is_glitch &= (np.abs(left) < size / 2) & (deviation > 0)
    sizes = np.zeros(len(series))
    for place in np.flatnonzero(is_glitch):
        first = place + AROUND + 1
        sizes[first : first + length] = size[place]
    return sizes


def _deviation(values: Array) -> float:
    """Standard deviation of noise, or of all but a few where half of the values are one."""
    sizes = np.sort(np.abs(values))
    if not len(sizes) or sizes[len(sizes) // 2] > 0:
        return MAD * float(np.median(sizes)) if len(sizes) else 0.0
    rest = sizes[: -int(max(2 * FEW, 2 * SHARE * len(sizes)))]
    return float(np.sqrt(np.mean(rest**2))) if len(rest) else 0.0
