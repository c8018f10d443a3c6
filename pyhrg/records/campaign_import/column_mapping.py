"""The mapping of one column: where a laboratory logs it, and in which unit."""

import math
from collections.abc import Mapping
from dataclasses import dataclass, field
from datetime import UTC, datetime

from pyhrg.common.toml_table import TomlTable
from pyhrg.records.campaign_import.units import BY_COLUMN_UNIT, PLAIN, RATE, Unit
from pyhrg.records.columns import COLUMNS, Column

BY_STEM = {column.stem: column for column in COLUMNS}
"""Columns by their keys in a mapping: names without units, since units are the laboratory's."""
INTEGRATION_KINDS = ("increments", "means", "samples")
"""How an angle may be logged otherwise: as increments since the row before, as rates averaged over
the row, or as rates sampled at its end."""
LARGEST_FACTOR = 1e15
"""Largest size of a number in a mapping. Chosen."""
EXAMPLE_TIME = datetime(2001, 2, 3, 4, 5, 6, tzinfo=UTC)
NO_TIME = datetime.strptime("", "")
"""What a text is read as that has no field of a time."""


@dataclass(frozen=True)
class ColumnMapping:
    """SI value = unit(scale * number + offset), then unwrapped, integrated and shifted.

    place: key in the mapping, for messages.
    column: the column of a campaign's log.
    logged: name of the laboratory's column or its number from 1; None: a constant.
    constant: value of a constant.
    unit_name: name of the unit, as in the mapping.
    wraps_every: period of a wrapped angle, SI; 0: it does not wrap.
    integrate: one of `INTEGRATION_KINDS`; empty: the angle itself is logged.
    from_zero: whether the first value is subtracted.
    time_format: of a clock's text, as in `datetime.strptime`, or `iso`.
    states: number that each word of the column stands for; empty where it holds numbers.
    """

    place: str
    column: Column
    logged: str | int | None = None
    constant: float = math.nan
    unit_name: str = ""
    unit: Unit = PLAIN
    scale: float = 1.0
    offset: float = 0.0
    wraps_every: float = 0.0
    integrate: str = ""
    from_zero: bool = False
    time_format: str = ""
    states: Mapping[str, float] = field(default_factory=dict)


def read_columns(table: TomlTable) -> dict[str, ColumnMapping]:
    """Mappings of a table's columns, by field of `Log`."""
    table.check_known(tuple(BY_STEM))
    return {BY_STEM[stem].field: _read_column(table, BY_STEM[stem]) for stem in table.values}


def _read_column(table: TomlTable, column: Column) -> ColumnMapping:
    place = f"{table.prefix}{column.stem}"
    value = table.values[column.stem]
    if isinstance(value, int | float) and not isinstance(value, bool) and not column.unit:
        low, high = max(column.lowest, -LARGEST_FACTOR), min(column.highest, LARGEST_FACTOR)
        constant = table.number(column.stem, 0, low, high)
        return ColumnMapping(place, column, constant=constant)
    entry = table.table(column.stem)
    if "constant" in entry.values:
        entry.check_known(("constant", "unit"))
        unit_name, unit = _read_unit(entry, column, "")
        constant = entry.number("constant", 0, -LARGEST_FACTOR, LARGEST_FACTOR)
        return ColumnMapping(place, column, constant=constant, unit_name=unit_name, unit=unit)
    return _read_logged_column(entry, place, column)


def _read_logged_column(entry: TomlTable, place: str, column: Column) -> ColumnMapping:
    entry.check_known(
        ("column", "unit", "scale", "offset", "from_zero")
        + (("wraps_every", "integrate") if column.unit == "deg" else ())
        + (("format",) if column.field == "time" else ())
        + (() if column.unit else ("states",))
    )
    name = entry.require("column", "the name of the lab's column, or its number from 1")
    if isinstance(name, bool) or not isinstance(name, str | int) or name == "":
        raise entry.error("column", name, "the name of the lab's column, or its number from 1")
    time_format = _read_time_format(entry)
    integrate = ""
    if "integrate" in entry.values:
        integrate = entry.text("integrate", None, INTEGRATION_KINDS)
    if integrate and "wraps_every" in entry.values:
        raise entry.error("wraps_every", entry.values["wraps_every"], "it or integrate, not both")
    scale = entry.number("scale", 1.0, -LARGEST_FACTOR, LARGEST_FACTOR)
    if scale == 0:
        raise entry.error("scale", scale, "a number other than 0")
    states = entry.table("states")
    unit_name, unit = ("", PLAIN) if time_format else _read_unit(entry, column, integrate)
    return ColumnMapping(
        place=place,
        column=column,
        logged=name,
        unit_name=unit_name,
        unit=unit,
        scale=scale,
        offset=entry.number("offset", 0.0, -LARGEST_FACTOR, LARGEST_FACTOR),
        wraps_every=entry.number("wraps_every", 0.0, 0.0, LARGEST_FACTOR) * unit.factor,
        integrate=integrate,
        from_zero=entry.flag("from_zero", False),
        time_format=time_format,
        states={word: states.finite_number(word) for word in states.values},
    )


def _read_time_format(entry: TomlTable) -> str:
    """The format of a clock, empty where none is stated; one that can't be read back is refused."""
    name = entry.text("format", "")
    if name in ("", "iso"):
        return name
    try:
        is_read = datetime.strptime(EXAMPLE_TIME.strftime(name), name) != NO_TIME
    except Exception:  # a repeated field is an error of regular expressions, others of values
        is_read = False
    if not is_read:
        raise entry.error("format", name, "iso, or fields of datetime.strptime, each once")
    return name


def _read_unit(entry: TomlTable, column: Column, integrate: str) -> tuple[str, Unit]:
    units = RATE if integrate in ("means", "samples") else BY_COLUMN_UNIT[column.unit]
    if "unit" not in entry.values and column.unit:
        raise entry.missing("unit", " or ".join(units))
    name = entry.text("unit", "1", tuple(units))
    return name, units[name]
