"""Tables of a TOML file, every key checked."""

import difflib
import math
from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from pyhrg.common.errors import HrgError


class SpecificationError(HrgError):
    """The file can't be used; the message names file, key, what was found and what expected."""


@dataclass(frozen=True)
class TomlTable:
    """A table and where it is from: the file, and the key with its dot."""

    source: str
    prefix: str
    values: Mapping[str, Any]

    def error(self, key: str, found: object, expected: str) -> SpecificationError:
        """What is wrong with a key of the table."""
        return SpecificationError(
            f"{self.source}: {self.prefix}{key}: found {found!r}, expected {expected}"
        )

    def missing(self, key: str, expected: str) -> SpecificationError:
        """That a key is not there."""
        return SpecificationError(
            f"{self.source}: {self.prefix}{key}: found no such key, expected {expected}"
        )

    def require(self, key: str, expected: str) -> Any:
        """What a key says.

        Raises:
            SpecificationError: it is not there.
        """
        if key not in self.values:
            raise self.missing(key, expected)
        return self.values[key]

    def tables(self, key: str) -> list["TomlTable"]:
        """An array of tables (`[[key]]`); none if it isn't there.

        Raises:
            SpecificationError: it is anything else.
        """
        found = self.values.get(key, [])
        if not isinstance(found, list) or not all(isinstance(value, dict) for value in found):
            raise self.error(key, found, f"tables, [[{key}]]")
        return [
            TomlTable(self.source, f"{self.prefix}{key}[{i}].", value)
            for i, value in enumerate(found)
        ]

    def check_known(self, names: Collection[str]) -> None:
        """Refuse keys that are none of these.

        Raises:
            SpecificationError: one is not.
        """
        for key in self.values:
            if key not in names:
                close = difflib.get_close_matches(key, names, n=1) or sorted(names)
                raise SpecificationError(
                    f"{self.source}: {self.prefix}{key}: found an unknown key, "
                    f"expected {' or '.join(self.prefix + name for name in close)}"
                )

    def table(self, key: str) -> "TomlTable":
        """A table within; empty if it isn't there.

        Raises:
            SpecificationError: it is no table.
        """
        value = self.values.get(key, {})
        if not isinstance(value, dict):
            raise self.error(key, value, "a table")
        return TomlTable(self.source, f"{self.prefix}{key}.", value)

    def text(self, key: str, default: str, choices: Sequence[str] = ()) -> str:
        """Text, one of the choices if there are any.

        Raises:
            SpecificationError: anything else.
        """
        value = self.values.get(key, default)
        if not isinstance(value, str) or (choices and value not in choices):
            raise self.error(key, value, " or ".join(choices) or "text")
        return value

    def flag(self, key: str, default: bool) -> bool:
        """True or false.

        Raises:
            SpecificationError: anything else.
        """
        value = self.values.get(key, default)
        if not isinstance(value, bool):
            raise self.error(key, value, "true or false")
        return value

    def number(self, key: str, default: float, low: float, high: float) -> float:
        """A number in a range, ends included.

        Raises:
            SpecificationError: anything else.
        """
        return self._number(key, self.values.get(key, default), low, high)

    def numbers(self, key: str, count: int, high: float) -> tuple[float, ...]:
        """So many numbers of at most a size.

        Raises:
            SpecificationError: anything else.
        """
        value = self.values[key]
        if not isinstance(value, list) or len(value) != count:
            raise self.error(key, value, f"{count} numbers in brackets")
        return tuple(self._number(f"{key}[{i}]", item, -high, high) for i, item in enumerate(value))

    def _number(self, key: str, value: object, low: float, high: float) -> float:
        if isinstance(value, bool) or not isinstance(value, int | float):
            raise self.error(key, value, "a number")
        if not (math.isfinite(value) and low <= value <= high):
            raise self.error(key, value, f"{low:g} to {high:g}")
        return float(value)
