"""From a laboratory's numbers to SI values: angles are unwrapped, rates integrated."""

import math
from datetime import datetime

import numpy as np

from pyhrg.common.arrays import Array
from pyhrg.common.errors import HrgError, quote
from pyhrg.common.units import HOUR
from pyhrg.records.campaign_import.column_mapping import EXAMPLE_TIME, NO_TIME, ColumnMapping
from pyhrg.records.campaign_import.layout import Cells
from pyhrg.records.columns import LogError
from pyhrg.records.timing import find_even_steps

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
        numbers = cells.numbers(mapping.logged, mapping.states)
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
    return _pass_midnight(np.array(seconds), mapping.time_format)


def _pass_midnight(seconds: Array, form: str) -> Array:
    """(n,) times of a clock without a date, s, that rise through midnight: from row to row by less
    than half a day."""
    is_known = np.isfinite(seconds)
    if (
        form != "iso"
        and datetime.strptime(EXAMPLE_TIME.strftime(form), form).date() == NO_TIME.date()
    ):
        seconds[is_known] = np.unwrap(seconds[is_known], period=24 * HOUR)
    return seconds


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
    is_uneven = np.append(False, ~find_even_steps(time, interval))
    if (is_missing | is_uneven).any():
        row = int(np.argmax(is_missing | is_uneven))
        step = time[row] - time[row - 1]
        lack = f"{step:.6g} s after the row before, not {interval:g} s"
        if is_missing[row] or not np.isfinite(step):
            lack = "no value" if is_missing[row] else "no time"
        raise LogError(
            f"{cells.source}: row {cells.rows[row]}, {mapping.logged}: {lack}; "
            f"{mapping.place}.integrate adds up all rows: cut the log there, and make each part a "
            "test"
        )
    steps = np.diff(time, prepend=time[0] - interval)
    if mapping.integrate == "increments":
        return np.cumsum(values)
    if mapping.integrate == "samples":
        values = (values + np.append(values[0], values[:-1])) / 2
    return np.cumsum(values * steps)
