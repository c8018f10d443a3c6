"""From a laboratory's numbers to SI values: angles are unwrapped, rates integrated, rows of a fast
log joined to longer ones.
"""

import math
from dataclasses import replace
from datetime import datetime
from typing import Any

import numpy as np
from numpy.typing import NDArray

from pyhrg.common.arrays import Array
from pyhrg.common.errors import HrgError, quote
from pyhrg.records.campaign_import.column_mapping import ColumnMapping
from pyhrg.records.campaign_import.layout import Cells
from pyhrg.records.columns import BY_FIELD, COLUMNS, LogError
from pyhrg.records.log import Log
from pyhrg.records.timing import find_even_steps

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


MAX_UNWRAPPED_STEP = 0.4
"""Largest step of a wrapped angle, as a share of its period, whose direction is certain. Chosen;
half a period is the limit."""


def read_times(mapping: ColumnMapping | None, cells: Cells, interval: float | None) -> Array:
    """(n,) ends of the rows' intervals, s; counted from the stated interval, s, where no column has
    them. Where none is stated, it is the median time step."""
    if mapping is None:
        if interval is None:
            raise LogError(f"{cells.source}: found no column of times mapped and no interval_s")
        return interval * np.arange(1.0, len(cells.rows) + 1)
    clock = _read_clock(mapping, cells) if mapping.time_format else convert_to_si(mapping, cells)
    if not (mapping.from_zero or mapping.time_format):
        return clock
    known = clock[np.isfinite(clock)]
    if len(known) < 2:
        raise LogError(f"{cells.source}: {len(known)} times; expected at least 2")
    return clock - known[0] + (interval or float(np.median(np.diff(known))))


def convert_to_si(mapping: ColumnMapping, cells: Cells) -> Array:
    """(n,) values of a column in SI, neither unwrapped nor integrated; NaN where there is none."""
    if mapping.logged is None:
        value = mapping.unit.factor * mapping.constant + mapping.unit.offset
        return np.full(len(cells.rows), value)
    try:
        numbers = cells.numbers(mapping.logged)
    except HrgError as error:
        raise LogError(f"{error} ({mapping.place})") from error
    return mapping.unit.factor * (mapping.scale * numbers + mapping.offset) + mapping.unit.offset


def convert_column(mapping: ColumnMapping, cells: Cells, time: Array, interval: float) -> Array:
    """(n,) a field of `Log`, SI."""
    values = convert_to_si(mapping, cells)
    if mapping.wraps_every:
        values = _unwrap(mapping, cells, values, time, interval)
    if mapping.integrate:
        values = _integrate(mapping, cells, values, time, interval)
    known = np.flatnonzero(np.isfinite(values))
    return values - values[known[0]] if mapping.from_zero and len(known) else values


def _read_clock(mapping: ColumnMapping, cells: Cells) -> Array:
    """(n,) times since the first one, s, from the texts of a clock."""
    assert mapping.logged is not None
    texts = cells.texts(mapping.logged)
    stamps = [
        None if cells.is_missing(text) else _parse_time(mapping, cells, i, text)
        for i, text in enumerate(texts)
    ]
    first = next((stamp for stamp in stamps if stamp is not None), None)
    if first is None:
        raise LogError(f"{cells.source}: {mapping.logged}: found no time ({mapping.place})")
    try:
        seconds = [math.nan if s is None else (s - first).total_seconds() for s in stamps]
    except TypeError as error:
        raise LogError(f"{cells.source}: {mapping.logged}: some times have a time zone") from error
    return np.array(seconds)


def _parse_time(mapping: ColumnMapping, cells: Cells, index: int, text: str) -> datetime:
    try:
        if mapping.time_format == "iso":
            return datetime.fromisoformat(text)
        return datetime.strptime(text, mapping.time_format)
    except ValueError:
        raise LogError(
            f"{cells.source}: row {cells.rows[index]}, {mapping.logged}: {quote(text)}; expected "
            f"a time as {mapping.place}.format says, {mapping.time_format!r}"
        ) from None


def _unwrap(
    mapping: ColumnMapping, cells: Cells, values: Array, time: Array, interval: float
) -> Array:
    """(n,) a continuous angle."""
    known = np.flatnonzero(np.isfinite(values) & np.isfinite(time))
    period = mapping.wraps_every
    turned = np.diff(values[known])
    turned -= period * np.round(turned / period)
    rate = np.abs(turned) / np.diff(time[known]).clip(interval)
    nearby = np.maximum(rate, np.maximum(np.append(0, rate[:-1]), np.append(rate[1:], 0)))
    uncertain = nearby * np.diff(time[known]) > MAX_UNWRAPPED_STEP * period
    if uncertain.any():
        row = cells.rows[known[int(np.argmax(uncertain)) + 1]]
        raise LogError(
            f"{cells.source}: row {row}, {mapping.logged}: turns by almost half of "
            f"{mapping.place}.wraps_every or more since the row before; its way round is uncertain"
        )
    result = np.full(len(values), np.nan)
    if len(known):
        result[known] = values[known[0]] + np.append(0.0, np.cumsum(turned))
    return result


def _integrate(
    mapping: ColumnMapping, cells: Cells, values: Array, time: Array, interval: float
) -> Array:
    """(n,) angles from increments or rates; a sampled rate is constant in the first row."""
    is_missing = ~np.isfinite(values)
    is_missing[1:] |= ~find_even_steps(time, interval)
    if is_missing.any():
        row = cells.rows[int(np.argmax(is_missing))]
        raise LogError(
            f"{cells.source}: row {row}, {mapping.logged}: no value, "
            f"or no even time step before it; expected none missing in what "
            f"{mapping.place}.integrate adds up"
        )
    steps = np.diff(time, prepend=time[0] - interval)
    if mapping.integrate == "increments":
        return np.cumsum(values)
    if mapping.integrate == "samples":
        values = (values + np.append(values[0], values[:-1])) / 2
    return np.cumsum(values * steps)
