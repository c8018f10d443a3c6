"""The layout of a laboratory's text file, and its cells."""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from pyhrg.common.errors import quote
from pyhrg.common.reading.documents import parse_csv
from pyhrg.common.toml_table import TomlTable
from pyhrg.records.columns import LogError
from pyhrg.records.table import read_text

SEPARATORS = {"comma": ",", "semicolon": ";", "tab": "\t", "bar": "|", "space": None}
"""Separators by their names in a mapping; `space` is any run of blanks."""
DECIMALS = {"point": ".", "comma": ","}
DOMAIN_NAMES = ("idna", "punycode")
"""Encodings of names of the internet, which take hours for a file's text."""
MAX_SKIPPED_LINES = 10_000
"""Largest number of lines to pass over. Chosen."""


@dataclass(frozen=True)
class Layout:
    """The layout of a text file with one row an interval.

    separator: between cells; None: any run of blanks.
    decimal: decimal point or comma.
    comment: beginning of a line to be ignored; empty: there are none.
    encoding: of the text.
    header: whether a row of names stands above the values.
    lines_before_header: number of lines to pass over.
    lines_after_header: likewise, such as a line of units.
    missing: texts of a cell without a value, in lower case.
    """

    separator: str | None = ","
    decimal: str = "."
    comment: str = ""
    encoding: str = "utf-8-sig"
    header: bool = True
    lines_before_header: int = 0
    lines_after_header: int = 0
    missing: frozenset[str] = frozenset({"", "nan"})


@dataclass(frozen=True)
class Cells:
    """The cells of a file. source: its name; rows: (n,) numbers of its lines, from 1."""

    source: str
    layout: Layout
    names: tuple[str, ...]
    rows: NDArray[np.int64]
    cells: tuple[tuple[str, ...], ...]

    def place(self, column: str | int) -> int:
        """Index of a column in a row, by the column's name or its number from 1."""
        if isinstance(column, int):
            if not 1 <= column <= len(self.cells[0]):
                expected = f"expected 1 to {len(self.cells[0])}"
                raise LogError(f"{self.source}: column {quote(column)}: not there; {expected}")
            return column - 1
        if self.names.count(column) != 1:
            found = f"found {self.names.count(column) or 'no'} columns of that name"
            among = ", ".join(self.names) or "no header"
            raise LogError(f"{self.source}: column {column}: {found}; expected one among {among}")
        return self.names.index(column)

    def texts(self, column: str | int) -> list[str]:
        """(n,) cells of a column."""
        place = self.place(column)
        return [row[place].strip() for row in self.cells]

    def is_missing(self, text: str) -> bool:
        """Whether a cell's text stands for no value."""
        return text.lower() in self.layout.missing

    def numbers(
        self, column: str | int, states: Mapping[str, float] | None = None
    ) -> NDArray[np.float64]:
        """(n,) values of a column, NaN where there is none; `states` are the numbers of words."""
        texts = self.texts(column)
        return np.array([self._number(i, column, t, states or {}) for i, t in enumerate(texts)])

    def _number(
        self, index: int, column: str | int, text: str, states: Mapping[str, float]
    ) -> float:
        if text in states:
            return states[text]
        if self.is_missing(text):
            return np.nan
        decimal = self.layout.decimal
        try:
            return float(text if decimal == "." else text.replace(decimal, "."))
        except ValueError:
            raise LogError(
                f"{self.source}: row {self.rows[index]}, {column}: {quote(text)}; expected a "
                f"number with a decimal {'point' if decimal == '.' else 'comma'}"
            ) from None


def read_layout(table: TomlTable) -> Layout:
    table.check_known(
        (
            *("separator", "decimal", "comment", "encoding", "missing"),
            *("header", "lines_before_header", "lines_after_header"),
        )
    )
    separator = SEPARATORS[table.text("separator", "comma", tuple(SEPARATORS))]
    decimal = DECIMALS[table.text("decimal", "point", tuple(DECIMALS))]
    if separator == decimal:
        raise table.error("decimal", "comma", "another separator than comma beside it")
    missing = table.values.get("missing", [])
    if not isinstance(missing, list) or not all(isinstance(text, str) for text in missing):
        raise table.error("missing", missing, "texts in brackets")
    return Layout(
        separator,
        decimal,
        table.text("comment", ""),
        _read_encoding(table),
        table.flag("header", True),
        table.whole_number("lines_before_header", 0, 0, MAX_SKIPPED_LINES),
        table.whole_number("lines_after_header", 0, 0, MAX_SKIPPED_LINES),
        Layout.missing | {text.lower() for text in missing},
    )


def read_cells(path: Path, layout: Layout) -> Cells:
    lines = _split_lines(path.name, read_text(path, layout.encoding), layout)
    names: tuple[str, ...] = ()
    if layout.header:
        names = tuple(name.strip() for name in next(lines, (0, ()))[1])
    for _ in range(layout.lines_after_header):
        next(lines, None)
    rows_of_cells = tuple(lines)
    if not rows_of_cells:
        raise LogError(f"{path.name}: found no row of values")
    expected = len(names) or len(rows_of_cells[0][1])
    for row, cells in rows_of_cells:
        if len(cells) != expected:
            trouble = f"{len(cells)} cells; expected {expected} as in the first row"
            raise LogError(f"{path.name}: row {row}: {trouble}")
    rows = np.array([row for row, _ in rows_of_cells], dtype=np.int64)
    return Cells(path.name, layout, names, rows, tuple(cells for _, cells in rows_of_cells))


def _split_lines(source: str, text: str, layout: Layout) -> Iterator[tuple[int, tuple[str, ...]]]:
    """Yield number and cells of each line that has any."""
    for number, line in enumerate(text.splitlines(), 1):
        ignored = layout.comment and line.lstrip().startswith(layout.comment)
        if number <= layout.lines_before_header or not line.strip() or ignored:
            continue
        if layout.separator is None:
            yield number, tuple(line.split())
        else:
            place = f"{source}: line {number}"
            _, cells = next(parse_csv(place, line, layout.separator))
            yield number, tuple(cells)


def _read_encoding(table: TomlTable) -> str:
    name = table.text("encoding", Layout.encoding)
    try:
        if name.lower() not in DOMAIN_NAMES and "1,2".encode(name).decode(name) == "1,2":
            return name
    except Exception:  # codecs raise what they like
        pass
    raise table.error("encoding", name, "a text encoding, as utf-8 or latin-1")
