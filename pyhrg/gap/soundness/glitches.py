"""Glitches: up to three readings that depart and return at once while all around is steady."""

import numpy as np
from numpy.lib.stride_tricks import sliding_window_view
from numpy.typing import NDArray
from scipy.ndimage import binary_dilation

from pyhrg.common.arrays import Array, Mask
from pyhrg.common.robust import estimate_robust_deviation
from pyhrg.device.device import Device
from pyhrg.gap.replay.inputs.inputs import prepare_inputs
from pyhrg.gap.replay.loop_response import FORCES
from pyhrg.gap.replay.observations import (
    CHANNELS,
    compute_settling_time,
    find_command_changes,
    find_table_acceleration,
    find_undisturbed_rows,
)
from pyhrg.gap.soundness.angles import compute_departure
from pyhrg.gap.soundness.exclusion import (
    Exclusion,
    replace_columns,
)
from pyhrg.gap.soundness.inputs import CONTINUOUS_INPUTS
from pyhrg.records import Log
from pyhrg.records.columns import BY_FIELD

MAX_LENGTH = 3
"""Longest glitch, rows. Chosen."""
PASSES = 2
"""Passes of the search: a glitch hides its neighbours. Chosen."""
CONTEXT = 4
"""Steps from row to row on either side that must be steady; as many must be known in all.
Chosen."""
MIN_BEFORE, MIN_AFTER = 2, 1
"""Fewest known steps before and after a glitch. Chosen."""
MAX_UNSTEADY_STEPS = 2
"""Steps around a glitch that may belong to another glitch. Chosen."""
MIN_SIZE_SIGMA = 10.0
"""Smallest glitch, in standard deviations of the steps from row to row. Chosen."""
MIN_SIZE_LOCAL = 5.0
"""Smallest glitch, in the largest departure of the steps around it. Chosen."""
MIN_SIZE_ELSEWHERE = 2.0
"""Smallest glitch, in the largest step of all other rows, a few excepted. Chosen."""
MIN_SIZE_SHARE = 1e-12
"""Smallest glitch, in the largest value of the series. Chosen: above the rounding of numbers."""
REACH = 2 * CONTEXT + MAX_LENGTH
"""Rows that a glitch influences: derived from the window's length."""
MIN_CONTRADICTION = 1e-5
"""Smallest contradiction between output and pattern angle, in units of what rounding and timing of
a coarse log explain. Chosen: above the rounding of numbers."""
MIN_ROWS = 50
"""Fewest rows in which glitches are looked for. Chosen."""
MAX_GLITCHES, MAX_GLITCH_SHARE = 6, 0.02
"""More glitches than the larger of this number and this share of the rows count as noise: none is
reported. Chosen."""
MAX_REPORTED = 3
"""Glitches of a column that are reported one by one."""


def mend_inputs(log: Log) -> tuple[Log, list[str]]:
    """A log whose measured inputs are interpolated across glitches, and a sentence for each
    column."""
    notes = []
    for field in CONTINUOUS_INPUTS:
        series = getattr(log, field)
        known = np.isfinite(series)
        glitches = find_glitches(series, known)
        if glitches.any():
            notes.append(f"{_describe(log, field, glitches)}: filled in")
            log = replace_columns(log, {field: _interpolate(series, glitches, known)})
    return log, notes


def check_glitches(log: Log, nominal: Device) -> list[Exclusion]:
    """Exclude glitches of the gyro's outputs in a log of complete inputs, in rows with settled
    loops and a steady table."""
    if not log.has_values("gyro_angle", "wave_angle"):
        return []
    inputs = prepare_inputs(log, nominal)
    changed = find_command_changes(log) | find_table_acceleration(inputs)
    steady = find_undisturbed_rows(log, changed, compute_settling_time(nominal))
    driven = log.is_driven
    exclusions = []
    for field in CHANNELS:
        series = getattr(log, field)
        known = np.isfinite(series)
        if not known.any():
            continue
        filled = _interpolate(series, ~known, known)
        glitches = find_glitches(filled, steady & (driven | (field not in FORCES)))
        if field == "gyro_angle":  # less the table's angle it is steady while the table is not
            glitches |= find_glitches(filled - log.table_angle, driven)
            glitches |= _find_contradictions(log, nominal)
        glitches &= known
        if glitches.any():
            fields = ("gyro_angle", "wave_angle") if field == "gyro_angle" else (field,)
            sentence = f"{_describe(log, field, glitches)}: left out"
            exclusions.append(Exclusion(fields, sentence, glitches))
    return exclusions


def _find_contradictions(log: Log, nominal: Device) -> Mask:
    """(n,) rows whose output angle is not what its definition makes of the pattern angle. None
    where there would be many: the two columns were then sampled at different times."""
    departure = compute_departure(log, nominal.bryan_factor, log.gyro_angle, log.wave_angle)
    sigma = _estimate_deviation(departure[np.isfinite(departure)])
    glitches = np.abs(departure) > max(MIN_SIZE_SIGMA * sigma, MIN_CONTRADICTION)
    return _keep_if_few(glitches, len(glitches))


def _describe(log: Log, field: str, glitches: Mask) -> str:
    """File, column, and for each glitch the reading and what was expected."""
    column, series = BY_FIELD[field], getattr(log, field)
    readings, expected = (
        (values[glitches] - column.offset) / column.factor
        for values in (series, _interpolate(series, glitches, np.isfinite(series)))
    )
    each = [
        f"{value:.9g} at time_s {time:g}, expected {other:.9g} as around it"
        for value, other, time in zip(readings, expected, log.time[glitches], strict=True)
    ]
    more = [f"{len(each) - MAX_REPORTED} more"] if len(each) > MAX_REPORTED else []
    return f"{log.source}: column {column.name}: {'; '.join(each[:MAX_REPORTED] + more)}"


def _interpolate(series: Array, glitches: Mask, known: Mask) -> Array:
    """A series with glitches replaced by interpolation between known rows."""
    kept = np.flatnonzero(known & ~glitches)
    return np.where(glitches, np.interp(np.arange(len(series)), kept, series[kept]), series)


def find_glitches(series: Array, rows: Mask) -> Mask:
    """(n,) rows that depart from a series and return at once, while all around is steady.

    A sound series is a straight line plus noise around each row. None is found if there would
    be many, or if steps elsewhere are as large: then they are noise of the gyro, or quantization.
    """
    glitches = np.zeros(len(series), np.bool_)
    if np.sum(rows) < MIN_ROWS:
        return glitches
    mended, sizes = series, np.zeros(len(series))
    for _ in range(PASSES):
        for length in range(1, MAX_LENGTH + 1):
            new = _measure_glitches(mended, rows, length)
            if new.any():
                sizes = np.where(glitches, sizes, new)
                glitches |= new > 0
                mended = _interpolate(series, glitches, rows)
        if not glitches.any():
            return glitches
    unaffected = rows & ~binary_dilation(glitches, iterations=REACH)
    steps = _window_steps(series, unaffected, 0)
    median, _, usable = _summarize_context(steps, 0)
    departures = np.abs(steps[:, CONTEXT] - median)  # of single steps from those around
    elsewhere = np.sort(departures[usable & np.isfinite(departures)])
    excepted = 2 * MAX_GLITCHES
    largest = elsewhere[-1 - excepted] if len(elsewhere) > excepted else 0.0
    glitches &= sizes > MIN_SIZE_ELSEWHERE * largest
    return _keep_if_few(glitches, int(np.sum(rows)))


def _keep_if_few(glitches: Mask, rows: int) -> Mask:
    """The glitches among so many rows, or none: if there are many, they are noise."""
    return glitches & (np.sum(glitches) <= max(MAX_GLITCHES, MAX_GLITCH_SHARE * rows))


def _window_steps(series: Array, rows: Mask, length: int) -> Array:
    """(n, w) steps into, within, out of and around a glitch of this length that begins in each row.

    A step is NaN if it is not between two rows that are searched.
    """
    steps = np.where(rows[1:] & rows[:-1], np.diff(series), np.nan)
    before, after = np.full(CONTEXT + 1, np.nan), np.full(CONTEXT + length, np.nan)
    return sliding_window_view(np.concatenate([before, steps, after]), 2 * CONTEXT + length + 1)


def _summarize_context(steps: Array, length: int) -> tuple[Array, Array, Mask]:
    """For each window: median of the steps around, their largest departure from it but a few, and
    whether enough are known."""
    around = np.delete(steps, np.s_[CONTEXT : CONTEXT + length + 1], axis=1)
    known = np.isfinite(around)
    usable = known.sum(axis=1) >= CONTEXT
    usable &= known[:, :CONTEXT].sum(axis=1) >= MIN_BEFORE
    usable &= known[:, CONTEXT:].sum(axis=1) >= MIN_AFTER
    ordered = np.sort(around, axis=1)
    last = np.maximum(known.sum(axis=1) - 1, 0)
    median = (_take_columns(ordered, last // 2) + _take_columns(ordered, (last + 1) // 2)) / 2
    departures = np.sort(np.abs(around - median[:, None]), axis=1)
    largest = _take_columns(departures, np.maximum(last - MAX_UNSTEADY_STEPS, 0))
    return median, largest, usable


def _take_columns(values: Array, columns: NDArray[np.int64]) -> Array:
    """(n,) one column of each row."""
    return np.asarray(np.take_along_axis(values, columns[:, None], 1)[:, 0])


def _measure_glitches(series: Array, rows: Mask, length: int) -> Array:
    """(n,) sizes of glitches of this length, in each of their rows; 0 elsewhere."""
    steps = _window_steps(series, rows, length)
    inside = steps[:, CONTEXT : CONTEXT + length + 1]
    median, unsteadiness, usable = _summarize_context(steps, length)
    away, back = inside[:, 0] - median, median - inside[:, -1]
    remaining = inside.sum(axis=1) - (length + 1) * median
    size = np.where(away * back > 0, np.minimum(np.abs(away), np.abs(back)), 0.0)
    usable &= np.isfinite(remaining)
    sigma = _estimate_deviation(away[usable])
    rounding = MIN_SIZE_SHARE * float(np.abs(series[rows]).max())
    least = np.maximum(max(MIN_SIZE_SIGMA * sigma, rounding), MIN_SIZE_LOCAL * unsteadiness)
    sizes = np.zeros(len(series))
    for first in np.flatnonzero(usable & (size > least) & (np.abs(remaining) < size / 2)):
        sizes[first : first + length] = size[first]
    return sizes


def _estimate_deviation(values: Array) -> float:
    """Robust standard deviation; without the few largest values if half of all are zero."""
    sizes = np.sort(np.abs(values))
    if not len(sizes):
        return 0.0
    if sizes[len(sizes) // 2] > 0:
        return estimate_robust_deviation(sizes)
    excepted = int(max(2 * MAX_GLITCHES, 2 * MAX_GLITCH_SHARE * len(sizes)))
    kept = sizes[:-excepted]
    return float(np.sqrt(np.mean(kept**2))) if len(kept) else 0.0
