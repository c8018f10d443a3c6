"""The log of an IMU, and the numbers of its text files."""

import io
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from pyhrg.common.arrays import Array
from pyhrg.common.errors import describe_briefly, quote
from pyhrg.common.reading.limits import LARGEST_NUMBER
from pyhrg.records.columns import LogError
from pyhrg.records.imu.increments import Increments

MIN_ROWS = 10
"""Smallest number of rows of a log. Chosen: fewer show neither an interval nor a unit."""


@dataclass(frozen=True)
class RecordedImu:
    """A log of an IMU.

    increments: body axes forward, right, down; position: (3,) latitude, longitude, rad, and
    height, m; None if the log states none; attitude: (3,) coarse roll, pitch and yaw at the
    start, rad; None if the log states none; source: the file.
    """

    increments: Increments
    position: Array | None
    attitude: Array | None
    source: str

    __repr__ = describe_briefly


def parse_numbers(
    source: str,
    lines: Sequence[str],
    first_row: int,
    names: Sequence[str],
    delimiter: str | None = None,
    places: Sequence[int] | None = None,
    least: int = MIN_ROWS,
) -> Array:
    """Values (n, m) of m named fields in n lines (at least `least`), all of them finite.

    For messages, the first line is `first_row` of the file, which begins with row 1. The delimiter
    None is white space; `places` are the indices of the m fields in a line that has others.
    """
    if len(lines) < least:
        raise LogError(f"{source}: found {len(lines)} rows of values, expected at least {least}")
    text = io.StringIO("\n".join(lines))
    try:
        table = np.loadtxt(text, delimiter=delimiter, comments=None, usecols=places, ndmin=2)
    except ValueError:  # a field is no number, or lines differ in length
        table = np.empty((0, 0))
    if table.shape != (len(lines), len(names)):
        table = _parse_field_by_field(source, lines, first_row, names, delimiter, places)
    check_finite(source, table, first_row, names)
    return table


def check_finite(source: str, table: Array, first_row: int, names: Sequence[str]) -> None:
    """Refuse values (n, m) that are not finite, or larger than anything measured."""
    is_wrong = ~(np.abs(table) <= LARGEST_NUMBER)
    if is_wrong.any():
        row, column = np.argwhere(is_wrong)[0]
        value = table[row, column]
        expected = (
            f"at most {LARGEST_NUMBER:g} in size" if np.isfinite(value) else "a finite number"
        )
        raise make_field_error(source, first_row + row, names[column], f"{value}", expected)


def check_lengths(source: str, lines: Sequence[str], first_row: int, names: Sequence[str]) -> None:
    """Refuse lines with another number of fields, by their commas, than of names."""
    for row, line in enumerate(lines, first_row):
        if line.count(",") != len(names) - 1:
            raise _make_length_error(source, row, line.count(",") + 1 if line.strip() else 0, names)


def make_field_error(source: str, row: int, field: str, found: str, expected: str) -> LogError:
    return LogError(f"{source}: row {row}, {field}: found {found}, expected {expected}")


def _make_length_error(source: str, row: int, found: int, names: Sequence[str]) -> LogError:
    return LogError(
        f"{source}: row {row}: found {found} fields, expected {len(names)}: {', '.join(names)}"
    )


def _parse_field_by_field(
    source: str,
    lines: Sequence[str],
    first_row: int,
    names: Sequence[str],
    delimiter: str | None,
    places: Sequence[int] | None,
) -> Array:
    """The values, field by field, so that a message can name what is wrong."""
    table = np.empty((len(lines), len(names)))
    for i, line in enumerate(lines):
        fields = line.split(delimiter)
        if places is None and len(fields) != len(names):
            raise _make_length_error(source, first_row + i, len(fields), names)
        chosen_fields = fields if places is None else [fields[place] for place in places]
        for j, (name, field) in enumerate(zip(names, chosen_fields, strict=True)):
            try:
                table[i, j] = float(field)
            except ValueError:
                found = quote(field.strip()) if field.strip() else "nothing"
                raise make_field_error(source, first_row + i, name, found, "a number") from None
    return table
