"""Tables of a TOML or JSON file: values are checked as they are taken out.

Every message has the form "FILE: KEY: found WHAT, expected WHAT". A key of a number states its
unit, its range, and the field that it fills.
"""

import difflib
import math
import sys
from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

from pyhrg.common.errors import HrgError, quote
from pyhrg.common.reading.documents import read_json, read_toml

PROPOSALS = 4
"""Largest number of known keys that a message proposes where none resembles an unknown one.
Chosen."""


@dataclass(frozen=True)
class TomlTable:
    """A table of a file, whose methods refuse a value that they can't take.

    Attributes:
        source: the file, for messages.
        prefix: what messages put before a key of this table, such as `site.` or `mission 2: `.
        values: the table's content.
    """

    source: str
    prefix: str
    values: Mapping[str, Any]

    def error(self, key: str, found: object, expected: str) -> HrgError:
        """Make the error about a key's value."""
        return self._make_error(key, quote(found), expected)

    def missing(self, key: str, expected: str) -> HrgError:
        """Make the error about a key that is not there."""
        return self._make_error(key, "no such key", expected)

    def _make_error(self, key: str, found: str, expected: str) -> HrgError:
        return HrgError(f"{self.source}: {self.prefix}{key}: found {found}, expected {expected}")

    def check_known(self, names: Collection[str]) -> None:
        """Refuse keys outside `names`; the message proposes those that resemble an unknown key."""
        dotted = self.prefix.rpartition(": ")[2]
        for key in self.values:
            if key not in names:
                close = difflib.get_close_matches(key, names, n=1) or sorted(names)[:PROPOSALS]
                more = " or another" if len(close) == PROPOSALS < len(names) else ""
                names_meant = " or ".join(dotted + name for name in close)
                raise self._make_error(key, "an unknown key", f"{names_meant}{more}")

    def require(self, key: str, expected: str) -> Any:
        """A key's value as it stands."""
        if key not in self.values:
            raise self.missing(key, expected)
        return self.values[key]

    def table(self, key: str) -> "TomlTable":
        """A table within this one; empty if it is not there."""
        value = self.values.get(key, {})
        if not isinstance(value, dict):
            raise self.error(key, value, "a table")
        return replace(self, prefix=f"{self.prefix}{key}.", values=value)

    def tables(self, key: str) -> list["TomlTable"]:
        """The tables of an array (`[[key]]`); an empty list if it is not there."""
        values = self.values.get(key, [])
        if not isinstance(values, list):
            raise self.error(key, values, f"tables, [[{key}]]")
        for i, value in enumerate(values):
            if not isinstance(value, dict):
                raise self.error(f"{key}[{i}]", value, "a table")
        return [
            replace(self, prefix=f"{self.prefix}{key}[{i}].", values=value)
            for i, value in enumerate(values)
        ]

    def text(self, key: str, default: str | None, choices: Sequence[str] = ()) -> str:
        """A text, one of the choices if there are any; required where there is no default."""
        if default is None:
            self.require(key, " or ".join(choices) or "text")
        value = self.values.get(key, default)
        if not isinstance(value, str) or (choices and value not in choices):
            raise self.error(key, value, " or ".join(choices) or "text")
        return value

    def flag(self, key: str, default: bool) -> bool:
        """True or false."""
        value = self.values.get(key, default)
        if not isinstance(value, bool):
            raise self.error(key, value, "true or false")
        return value

    def finite_number(self, key: str, default: float | None = None) -> float:
        """A number; required where there is no default."""
        if default is None:
            self.require(key, "a number")
        return self._finite(key, self.values.get(key, default))

    def number(self, key: str, default: float | None, low: float, high: float) -> float:
        """A number from `low` to `high`, ends included; required where there is no default."""
        value = self.finite_number(key, default)
        if not low <= value <= high:
            raise self.error(key, self.values.get(key, default), describe_range(low, high))
        return value

    def whole_number(self, key: str, default: int | None, low: float, high: float) -> int:
        """A whole number from `low` to `high`, ends included; required without a default."""
        value = self.number(key, default, low, high)
        if value != int(value):
            raise self.error(key, value, "a whole number")
        return int(self.values.get(key, default))  # a float has not all digits of a large one

    def numbers(self, key: str, count: int | None, low: float, high: float) -> tuple[float, ...]:
        """An array of `count` numbers (None: any count) from `low` to `high`, ends included; empty
        where the key is missing."""
        values = self.values.get(key, [])
        if not isinstance(values, list) or count not in (None, len(values)):
            raise self.error(
                key, values, f"{'' if count is None else f'{count} '}numbers in brackets"
            )
        for i, value in enumerate(values):
            if not low <= self._finite(f"{key}[{i}]", value) <= high:
                raise self.error(f"{key}[{i}]", value, describe_range(low, high))
        return tuple(float(value) for value in values)

    def optional_number(self, key: str) -> float | None:
        """A finite number; None where it is null or not there."""
        return None if self.values.get(key) is None else self.finite_number(key)

    def texts(self, key: str) -> tuple[str, ...]:
        """An array of texts, which is required."""
        texts = self.require(key, "a list of texts")
        if not isinstance(texts, list) or not all(isinstance(text, str) for text in texts):
            raise self.error(key, texts, "a list of texts")
        return tuple(texts)

    def _finite(self, key: str, value: object) -> float:
        if isinstance(value, bool) or not isinstance(value, int | float):
            raise self.error(key, value, "a number")
        if not abs(value) <= sys.float_info.max:
            raise self.error(key, value, "a finite number")
        return float(value)


def describe_range(low: float, high: float) -> str:
    """A range in words; `high` may be infinite."""
    if low == high:
        return f"{low:g}, the only one there is"
    return f"a number of at least {low:g}" if math.isinf(high) else f"{low:g} to {high:g}"


def read_table(path: Path) -> TomlTable:
    """The whole content of a TOML file."""
    return TomlTable(str(path), "", read_toml(path))


def read_json_table(path: Path) -> TomlTable:
    """The whole content of a JSON file, whose objects are tables."""
    return TomlTable(str(path), "", read_json(path))


@dataclass(frozen=True)
class Key:
    """A number of a file: SI value = number * factor + offset.

    Attributes:
        name: key in the file, which ends in the unit.
        field: attribute of the dataclass that the number fills, SI.
        low, high: smallest and largest number allowed, in the file's unit.
        whole: whether the number counts something, without unit.
    """

    name: str
    field: str
    factor: float
    low: float
    high: float
    offset: float = 0.0
    whole: bool = False

    def to_si(self, value: float) -> float:
        """SI value of a number in the file's unit."""
        return value * self.factor + self.offset

    def from_si(self, value: float) -> float:
        """The shortest number in the file's unit that gives the SI value, or the nearest."""
        plain = (value - self.offset) / self.factor
        neighbours = (plain, math.nextafter(plain, -math.inf), math.nextafter(plain, math.inf))
        candidates = (float(f"{plain:.14g}"), *neighbours)
        return min(candidates, key=lambda candidate: abs(self.to_si(candidate) - value))

    def read(self, table: TomlTable) -> float:
        if self.whole:
            return table.whole_number(self.name, None, self.low, self.high)
        return self.to_si(table.number(self.name, None, self.low, self.high))


def read_fields(
    table: TomlTable, keys: Sequence[Key], other_keys: Collection[str] = ()
) -> dict[str, Any]:
    """SI values of the keys that a table states, by field; keys that it leaves out are absent. Of
    two keys with one field, a file states one; it may hold `other_keys` besides."""
    table.check_known([*(key.name for key in keys), *other_keys])
    values: dict[str, Any] = {}
    stated_by: dict[str, str] = {}
    for key in (key for key in keys if key.name in table.values):
        value = key.read(table)
        if key.field in values:
            twin = stated_by[key.field]
            raise table.error(
                key.name, table.values[key.name], f"it or {twin}, which says the same"
            )
        values[key.field] = value
        stated_by[key.field] = key.name
    return values
