"""What a mapping says of one column of a campaign: where it is logged and in which unit."""

import math
from dataclasses import dataclass

from pyhrg.common.toml_table import TomlTable
from pyhrg.records.campaign_import.units import PLAIN, RATE, Unit, units_of
from pyhrg.records.columns import COLUMNS, Column

BY_STEM = {column.stem: column for column in COLUMNS}
"""A mapping's keys: names without units, since units are a lab's own."""
INTEGRATED = ("increments", "means", "samples")
"""Angles logged as turns since the row before, as rates averaged over the row, or as rates at
the row's end."""
LARGEST = 1e15


@dataclass(frozen=True)
class ColumnMapping:
    """SI = unit(scale * number + offset), then unwrapped, integrated and shifted as asked for."""

    place: str
    """Key of the mapping, for messages."""
    column: Column
    logged: str | int | None = None
    """Name or number, from 1, of the lab's column; None: a constant."""
    constant: float = math.nan
    unit_name: str = ""
    unit: Unit = PLAIN
    scale: float = 1.0
    offset: float = 0.0
    wraps_every: float = 0.0
    """SI; 0: it does not wrap."""
    integrate: str = ""
    """One of `INTEGRATED`, or empty: logged as it is."""
    from_zero: bool = False
    """Whether the first value is taken off."""
    time_format: str = ""
    """Of a clock's text, as in `datetime.strptime`, or `iso`."""


def read_columns(table: TomlTable) -> dict[str, ColumnMapping]:
    """Mappings by their campaign column's field.

    Raises:
        SpecificationError: an unknown column or key, a unit of another quantity.
    """
    table.check_known(tuple(BY_STEM))
    return {BY_STEM[stem].field: _read(table, BY_STEM[stem]) for stem in table.values}


def _read(table: TomlTable, column: Column) -> ColumnMapping:
    place = f"{table.prefix}{column.stem}"
    value = table.values[column.stem]
    if isinstance(value, int | float) and not isinstance(value, bool) and not column.unit:
        return ColumnMapping(place, column, constant=table.number(column.stem, 0, *_range(column)))
    entry = table.table(column.stem)
    if "constant" in entry.values:
        entry.check_known(("constant", "unit"))
        unit_name, unit = _unit(entry, column, "")
        constant = entry.number("constant", 0, -LARGEST, LARGEST)
        return ColumnMapping(place, column, constant=constant, unit_name=unit_name, unit=unit)
    return _logged(entry, place, column)


def _logged(entry: TomlTable, place: str, column: Column) -> ColumnMapping:
    entry.check_known(
        ("column", "unit", "scale", "offset", "from_zero")
        + (("wraps_every", "integrate") if column.unit == "deg" else ())
        + (("format",) if column.field == "time" else ())
    )
    name = entry.require("column", "the name of the lab's column, or its number from 1")
    if isinstance(name, bool) or not isinstance(name, str | int) or name == "":
        raise entry.error("column", name, "the name of the lab's column, or its number from 1")
    time_format = entry.text("format", "")
    integrate = entry.text("integrate", "", INTEGRATED) if "integrate" in entry.values else ""
    if integrate and "wraps_every" in entry.values:
        raise entry.error("wraps_every", entry.values["wraps_every"], "it or integrate, not both")
    unit_name, unit = ("", PLAIN) if time_format else _unit(entry, column, integrate)
    return ColumnMapping(
        place=place,
        column=column,
        logged=name,
        unit_name=unit_name,
        unit=unit,
        scale=_scale(entry),
        offset=entry.number("offset", 0.0, -LARGEST, LARGEST),
        wraps_every=entry.number("wraps_every", 0.0, 0.0, LARGEST) * unit.factor,
        integrate=integrate,
        from_zero=entry.flag("from_zero", False),
        time_format=time_format,
    )


def _range(column: Column) -> tuple[float, float]:
    return max(column.lowest, -LARGEST), min(column.highest, LARGEST)


def _scale(entry: TomlTable) -> float:
    scale = entry.number("scale", 1.0, -LARGEST, LARGEST)
    if scale == 0:
        raise entry.error("scale", scale, "a number other than 0")
    return scale


def _unit(entry: TomlTable, column: Column, integrate: str) -> tuple[str, Unit]:
    units = RATE if integrate in ("means", "samples") else units_of(column)
    if "unit" not in entry.values and column.unit:
        raise entry.missing("unit", " or ".join(units))
    name = entry.text("unit", "1", tuple(units))
    return name, units[name]
