"""A log's file as a table of numbers: CSV, gzipped or not, every field checked."""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from pyhrg.common.arrays import Array, Mask
from pyhrg.common.errors import quote
from pyhrg.common.reading.documents import iterate_lines, parse_csv
from pyhrg.common.reading.files import decode, read_unpacked
from pyhrg.records.columns import BY_FIELD, COLUMNS, Column, LogError, find_mislabelled_column

Numbers = tuple[NDArray[np.int64], dict[str, Array]]
"""(n,) numbers of the rows, and (n,) columns by their name in the file."""

MAX_STRETCHES_NAMED = 8
"""Largest number of stretches of rows that a message names one by one. Chosen."""
ABSENT_COLUMN = "no column "
"""Beginning of a sentence on a column that a log does not have."""


@dataclass(frozen=True)
class Table:
    """Rows of a log while they are being checked.

    Attributes:
        source: name of the file, for messages.
        rows: (n,) row in the file; the header is row 1.
        columns: (n,) values by field, SI; NaN where there is no value.
        notes: what was left out so far, a sentence each.
    """

    source: str
    rows: NDArray[np.int64]
    columns: dict[str, Array]
    notes: tuple[str, ...] = ()

    def error(self, row: int, field: str, trouble: str) -> LogError:
        """Make the error about a field at an index of the table."""
        return LogError(f"{self.source}: row {self.rows[row]}, {BY_FIELD[field].name}: {trouble}")

    def add_note(self, chosen: Mask, trouble: str) -> "Table":
        """The table with a sentence on the chosen rows; the table itself where none is chosen."""
        if not chosen.any():
            return self
        note = f"{describe_rows(self.rows[chosen])}: {trouble}"
        return replace(self, notes=(*self.notes, note))

    def keep_rows(self, chosen: Mask) -> "Table":
        columns = {field: values[chosen] for field, values in self.columns.items()}
        return replace(self, rows=self.rows[chosen], columns=columns)

    def clear_values(self, field: str, chosen: Mask) -> "Table":
        """The table without a column's values in the chosen rows."""
        values = np.where(chosen, np.nan, self.columns[field])
        return replace(self, columns=self.columns | {field: values})


def describe_rows(rows: NDArray[np.int64]) -> str:
    """Rows in words: `rows 17, 203-210`."""
    stretches = np.split(rows, np.flatnonzero(np.diff(rows) > 1) + 1)
    texts = [
        f"{p[0]}-{p[-1]}" if len(p) > 1 else f"{p[0]}" for p in stretches[:MAX_STRETCHES_NAMED]
    ]
    more = f" and more, {len(rows)} rows in all" if len(stretches) > MAX_STRETCHES_NAMED else ""
    return f"row{'s' if len(rows) > 1 else ''} {', '.join(texts)}{more}"


def read_table(path: Path) -> Table:
    """The rows of a log's file, in SI, with notes on missing and unknown columns."""
    text = read_text(path)
    first_line = text.partition("\n")[0].rstrip("\r")
    _, names = next(parse_csv(path.name, first_line), (1, []))
    header = [name.strip() for name in names]
    _check_header(path, header)
    rows, values = _parse_plain(text, header) or _parse_field_by_field(path, text, header)
    if len(rows) < 2:
        raise LogError(f"{path.name}: {len(rows)} rows of values; expected at least 2")
    columns = {column.field: np.full(len(rows), np.nan) for column in COLUMNS}
    for column in COLUMNS:
        if column.name in header:
            check_range(path.name, column, rows, values[column.name])
            columns[column.field] = column.factor * values[column.name] + column.offset
    names = [column.name for column in COLUMNS]
    expected = [column.name for column in COLUMNS if not column.optional]
    notes = [f"{ABSENT_COLUMN}{name}" for name in expected if name not in header]
    notes += [f"column {name}: not known, ignored" for name in header if name not in names]
    return Table(path.name, rows, columns, tuple(notes))


def fold_absent_columns(notes: Sequence[str]) -> list[str]:
    """The notes on a log, with one sentence on all columns that are not there."""
    absent = [note for note in notes if note.startswith(ABSENT_COLUMN)]
    others = [note for note in notes if not note.startswith(ABSENT_COLUMN)]
    names = ", ".join(note.removeprefix(ABSENT_COLUMN) for note in absent)
    return [ABSENT_COLUMN + names, *others] if absent else others


def merge_sources(sentences: Iterable[str]) -> list[str]:
    """Sentences that each begin with a source and a colon; those that say the same of several
    sources become one, which names them all."""
    sources: dict[str, dict[str, None]] = {}
    for sentence in sentences:
        source, colon, text = sentence.partition(": ")
        sources.setdefault(colon + (text or sentence), {})[source if colon else ""] = None
    return [", ".join(named) + text for text, named in sources.items()]


def read_text(path: Path, encoding: str = "utf-8-sig") -> str:
    """A log's text, decompressed if it is gzipped, whatever its name."""
    return decode(path, read_unpacked(path), encoding)


def _check_header(path: Path, header: list[str]) -> None:
    names = [column.name for column in COLUMNS]
    for name in header:
        meant = find_mislabelled_column(name)
        if name in names and header.count(name) > 1:
            raise LogError(f"{path.name}: column {name} stands there more than once")
        if name not in names and meant and meant.name not in header:
            raise LogError(f"{path.name}: column {name}; expected {meant.name}")
    if names[0] not in header:
        raise LogError(f"{path.name}: column {names[0]} is missing; found {', '.join(header)}")


def _parse_plain(text: str, header: list[str]) -> Numbers | None:
    """Rows and columns of a file in which every field is a number; None for any other file."""
    if "\n\n" in text or "\n\r" in text or not text.partition("\n")[2].strip():
        return None
    try:
        table = np.loadtxt(iterate_lines(text), delimiter=",", comments=None, skiprows=1, ndmin=2)
    except ValueError:
        return None
    if table.shape[1] != len(header) or not len(table):
        return None
    return np.arange(2, len(table) + 2), dict(zip(header, table.T, strict=True))


def _parse_field_by_field(path: Path, text: str, header: list[str]) -> Numbers:
    """Rows and columns of a file with empty fields or rows, or text in unknown columns."""
    lines = list(parse_csv(path.name, text))[1:]
    for number, row in lines:
        if len(row) != len(header):
            raise LogError(
                f"{path.name}: row {number}: {len(row)} fields; expected {len(header)} as in row 1"
            )
    return np.array([number for number, _ in lines], dtype=np.int64), {
        name: np.array([_parse_number(path, name, number, row[place]) for number, row in lines])
        for place, name in enumerate(header)
        if any(name == column.name for column in COLUMNS)
    }


def _parse_number(path: Path, name: str, row: int, text: str) -> float:
    try:
        return float(text.strip() or "nan")
    except ValueError:
        raise LogError(
            f"{path.name}: row {row}, {name}: {quote(text)}; expected a number"
        ) from None


def check_range(source: str, column: Column, rows: NDArray[np.int64], values: Array) -> None:
    """Refuse values (n,) in the file's unit that are out of a column's range."""
    is_wrong = (values < column.lowest) | (values > column.highest)
    if is_wrong.any():
        i = int(np.argmax(is_wrong))
        expected = f"{column.lowest:g} to {column.highest:g}"
        raise LogError(
            f"{source}: row {rows[i]}, {column.name}: {values[i]:.9g}; expected {expected}"
        )
