"""Tables of a study file: keys, units and ranges of the settings of gyros, bench and drift.

Each table is of a dataclass (`experiment.KINDS`), each key of one of its fields; what a file leaves
out is as the dataclass has it.
"""

import math
from collections.abc import Mapping
from dataclasses import dataclass

from pyhrg.common.toml_table import TomlTable
from pyhrg.common.units import DEG_PER_H, HOUR

UNITS = {"deg_h": DEG_PER_H, "days": 24 * HOUR, "K": 1.0, "": 1.0}
Settings = Mapping[str, float]
"""Fields of a dataclass, SI."""


@dataclass(frozen=True)
class Key:
    """Of a field: its unit and range, in that unit; whole: a count."""

    field: str
    unit: str
    low: float
    high: float
    whole: bool = False

    @property
    def name(self) -> str:
        """As in files."""
        return f"{self.field}_{self.unit}" if self.unit else self.field

    def read(self, table: TomlTable) -> float:
        """SI.

        Raises:
            SpecificationError: no such number.
        """
        if self.whole and type(table.values[self.name]) is not int:
            raise table.error(self.name, table.values[self.name], "a whole number")
        value = table.number(self.name, math.nan, self.low, self.high)
        return int(value) if self.whole else value * UNITS[self.unit]

    def shown(self, value: float) -> float:
        """The file's number for an SI value."""
        return value / UNITS[self.unit]


_POPULATION = (Key("smallest", "deg_h", 1e-4, 100), Key("largest", "deg_h", 1e-4, 100))
_PLAN = (
    Key("runs", "", 1, 100, whole=True),
    Key("positions", "", 16, 720, whole=True),  # nine terms of a map
    Key("segments", "", 1, 36, whole=True),
    Key("fixed_segments", "", 2, 360, whole=True),
    Key("periods", "", 1, 100, whole=True),
)
SECTIONS: Mapping[str, tuple[Key, ...]] = {
    "trimmed": _POPULATION,
    "raw": _POPULATION,
    "calibration": _PLAN,
    "bench": _PLAN,
    "drift": (
        Key("age", "days", 0, 7300),
        Key("coolest", "K", -80, 80),
        Key("warmest", "K", -80, 80),
    ),
}
"""By name: gyros that the maker calibrates by their mean, and by their map; the maker's tests and
the bench's; what happens from calibration to flight."""
ORDERED = (
    ("trimmed", "smallest", "largest"),
    ("raw", "smallest", "largest"),
    ("drift", "coolest", "warmest"),
)
"""Ends of ranges."""


def settings(top: TomlTable) -> dict[str, Settings]:
    """Of the tables that are there.

    Raises:
        SpecificationError: an unknown key, a value out of range, a range without its other end or
            upside down.
    """
    read = {
        name: _section(top.table(name), SECTIONS[name]) for name in SECTIONS if name in top.values
    }
    for name, low, high in ORDERED:
        if name in read:
            _check_ends(top.table(name), read[name], low, high)
    return read


def _section(table: TomlTable, known: tuple[Key, ...]) -> Settings:
    table.check_known([key.name for key in known])
    return {key.field: key.read(table) for key in known if key.name in table.values}


def _check_ends(table: TomlTable, found: Settings, low: str, high: str) -> None:
    keys = {key.field: key.name for key in SECTIONS[table.prefix.removesuffix(".")]}
    for one, other in ((low, high), (high, low)):
        if one in found and other not in found:
            raise table.missing(keys[other], f"a number beside {keys[one]}")
    if low in found and found[low] > found[high]:
        raise table.error(keys[high], table.values[keys[high]], f"{keys[low]} or more")
