"""Keys of a file that state numbers: each with its unit, its range, and the field that it fills."""

import math
from collections.abc import Collection, Sequence
from dataclasses import dataclass
from typing import Any

from pyhrg.common.toml_table import TomlTable


@dataclass(frozen=True)
class Key:
    """A number of a file: SI value = number * factor + offset.

    name: key in the file, which ends in the unit; field: attribute of the dataclass that the number
    fills, SI; low, high: smallest and largest number allowed, in the file's unit; whole: whether
    the number counts something, without unit.
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
