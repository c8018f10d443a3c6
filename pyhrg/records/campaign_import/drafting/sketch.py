"""What a log shows by itself: its layout, its names and units, and the texts of its values."""

import re
from codecs import BOM_UTF16_BE, BOM_UTF16_LE
from collections.abc import Collection, Sequence
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path

import numpy as np

from pyhrg.common.arrays import Array
from pyhrg.common.errors import HrgError
from pyhrg.common.reading.files import decode, read_unpacked
from pyhrg.records.campaign_import.layout import SEPARATORS, Layout
from pyhrg.records.columns import LogError

COMMENTS = ("#", "%", "!", "//")
"""Beginnings of a first line that is a comment; the first one stands where none is found."""
SEARCHED = ("semicolon", "tab", "bar", "comma")
"""Separators in the order in which a row of values is searched for them; else it is `space`."""

NINES = re.compile(r"[-+]?9{3,}([.,]0*)?")
"""Numbers that stand for a missing value."""
NOTHING = re.compile(r"n/?a|null|none|missing|-{1,3}|\?", re.IGNORECASE)
"""Words that do."""
PLACEHOLDER_RATIO = 3.0
"""Ratio of such a number to the largest other value of its column. Chosen."""


@dataclass(frozen=True)
class Sketch:
    """The layout of a log as keys of a mapping, and its cells.

    layout: value of each key, as TOML.
    names: of the columns, from the header.
    units: from a row of units below the header, as many; empty texts where there is none.
    rows: cells of each row of values.
    """

    layout: dict[str, str]
    names: tuple[str, ...]
    units: tuple[str, ...]
    rows: tuple[tuple[str, ...], ...]

    @cached_property
    def placeholders(self) -> frozenset[str]:
        """Texts that seem to stand for a missing value: words for nothing, and nothing but nines,
        in columns of numbers that are all far smaller."""
        texts = {text for row in self.rows for text in row}
        found = {text for text in texts if NOTHING.fullmatch(text)}
        for nines in sorted(text for text in texts if NINES.fullmatch(text)):
            value = abs(float(nines.replace(",", ".")))
            places = {i for row in self.rows for i, text in enumerate(row) if text == nines}
            sizes = [np.abs(self._parse(place, found)) for place in places]
            smaller = [size[size < value] for size in sizes]
            if all(len(own) and own.max() < value / PLACEHOLDER_RATIO for own in smaller):
                found.add(nines)
        return frozenset(found)

    def read_numbers(self, place: int) -> Array:
        """(n,) values of a column, without missing ones; n is 0 where one is no number."""
        return self._parse(place, self.placeholders)

    def _parse(self, place: int, missing: Collection[str]) -> Array:
        texts = [row[place] for row in self.rows if place < len(row)]
        known = [t for t in texts if t not in missing and t.lower() not in Layout.missing]
        is_comma = "comma" in self.layout["decimal"]
        try:
            return np.array([float(t.replace(",", ".") if is_comma else t) for t in known])
        except ValueError:
            return np.empty(0)


def read_sketch(path: Path) -> Sketch:
    """A log's sketch.

    Raises:
        LogError: the file can't be read, or has no header.
    """
    encoding, text = _decode(path)
    lines = text.splitlines()
    first = next((line.strip() for line in lines if line.strip()), "")
    comment = next((mark for mark in COMMENTS if first.startswith(mark)), COMMENTS[0])
    shown = [
        i for i, line in enumerate(lines) if line.strip() and not line.strip().startswith(comment)
    ]
    last = lines[shown[-1]] if shown else ""
    separator = next((name for name in SEARCHED if (SEPARATORS[name] or " ") in last), "space")
    comma = separator != "comma" and bool(re.search(r"\d,\d", last))
    rows = [_split(lines[i], separator) for i in shown]
    head = next((i for i, row in enumerate(rows) if _has_values(row, len(rows[-1]))), 0)
    named = [i for i in range(max(0, head - 2), head) if len(rows[i]) == len(rows[-1])]
    if not named or not re.search("[A-Za-z]", "".join(rows[named[0]])):
        raise LogError(f"{path}: found no row of names above the values, expected one")
    layout = {"separator": f'"{separator}"', "decimal": '"comma"' if comma else '"point"'}
    layout["comment"] = f'"{comment}"'
    if encoding:
        layout["encoding"] = f'"{encoding}"'
    if named[0] > 0:
        layout["lines_before_header"] = str(shown[named[0]])
    if len(named) > 1:
        layout["lines_after_header"] = "1"
    units = rows[named[1]] if len(named) > 1 else [""] * len(rows[-1])
    return Sketch(layout, tuple(rows[named[0]]), tuple(units), tuple(map(tuple, rows[head:])))


def _decode(path: Path) -> tuple[str, str]:
    """Encoding of a log's text, empty for UTF-8, and the text: one that is not UTF-8 is taken for
    the usual one of Windows in western Europe."""
    data = read_unpacked(path)
    if data.startswith((BOM_UTF16_LE, BOM_UTF16_BE)):
        return "utf-16", decode(path.name, data, "utf-16")
    try:
        return "", decode(path.name, data)
    except HrgError:
        return "cp1252", decode(path.name, data, "cp1252")


def _split(line: str, separator: str) -> list[str]:
    return [cell.strip().strip('"') for cell in line.split(SEPARATORS[separator])]


def _has_values(row: Sequence[str], width: int) -> bool:
    return len(row) == width and any(re.fullmatch(r"[-+]?[\d.,]+(e[-+]?\d+)?", c) for c in row)
