"""Fields of missions and manoeuvres: SI inside, a unit in the key outside, a range."""

import sys
from abc import ABC, abstractmethod
from collections.abc import Iterator
from dataclasses import MISSING, Field, dataclass, field, fields
from typing import Any, TypeGuard, TypeVar

from ins_eval.trajectories.errors import TrajectoryError
from pyhrg.common.errors import quote
from pyhrg.common.toml_table import TomlTable
from pyhrg.common.units import DEG

UNITS = {"deg": DEG, "deg_s": DEG, "m": 1.0, "m_s": 1.0, "s": 1.0, "": 1.0}
"""SI value of each unit that a key may end in; a number without one has none."""


class Kind(ABC):
    """The values that a field takes; those of files and inside are the same by default."""

    @property
    @abstractmethod
    def expected(self) -> str:
        """What is expected, in words."""

    @abstractmethod
    def holds(self, value: object) -> bool:
        """Whether a value inside is one of them."""

    def from_file(self, value: object) -> Any:
        """The value inside of a file's value."""
        return value

    def to_file(self, value: object) -> Any:
        """The file's value of a value inside."""
        return value


@dataclass(frozen=True)
class Quantity(Kind):
    """A number in a unit and its range, in that unit."""

    unit: str
    low: float
    high: float

    @property
    def expected(self) -> str:
        return f"{self.low:g} to {self.high:g}{' ' * bool(self.unit)}{self.unit.replace('_', '/')}"

    def from_file(self, value: object) -> Any:
        return value * UNITS[self.unit] if _is_number(value) else value

    def holds(self, value: object) -> bool:
        """Whether the SI value is a number within the range, rounding aside."""
        plain = self.to_file(value)
        slack = 1e-12 * max(abs(self.low), abs(self.high))
        return _is_number(plain) and self.low - slack <= plain <= self.high + slack

    def to_file(self, value: object) -> Any:
        return value / UNITS[self.unit] if _is_number(value) else value


@dataclass(frozen=True)
class Whole(Kind):
    """A whole number and its range."""

    low: int
    high: int

    @property
    def expected(self) -> str:
        return f"a whole number from {self.low} to {self.high}"

    def holds(self, value: object) -> bool:
        return type(value) is int and self.low <= value <= self.high


@dataclass(frozen=True)
class Choice(Kind):
    """One of some words."""

    words: tuple[str, ...]

    @property
    def expected(self) -> str:
        return " or ".join(f'"{word}"' for word in self.words)

    def holds(self, value: object) -> bool:
        return isinstance(value, str) and value in self.words


def quantity(unit: str, low: float, high: float, default: Any = MISSING) -> Any:
    """A field whose key in files is its name and unit; range and default in that unit."""
    kind = Quantity(unit, low, high)
    if default is not MISSING:
        default = kind.from_file(default)
    return field(default=default, metadata={"kind": kind})


def whole(low: int, high: int, default: Any = MISSING) -> Any:
    """A field that is a whole number; a default of None means that it may be left out."""
    return field(default=default, metadata={"kind": Whole(low, high)})


def choice(*words: str) -> Any:
    """A field that is one of some words, the first of them by default."""
    return field(default=words[0], metadata={"kind": Choice(words)})


def required_choice(*words: str) -> Any:
    """A field that is one of some words."""
    return field(metadata={"kind": Choice(words)})


def keys(table: type) -> Iterator[tuple[str, Field[Any], Kind]]:
    """Key in files, field, and kind of all fields of a dataclass that have one."""
    for f in fields(table):
        if kind := f.metadata.get("kind"):
            unit = getattr(kind, "unit", "")
            yield f"{f.name}_{unit}" if unit else f.name, f, kind


T = TypeVar("T", bound="Checked")


@dataclass(frozen=True, kw_only=True)
class Checked:
    """Refuses values out of range."""

    def __post_init__(self) -> None:
        for key, f, kind in keys(type(self)):
            value = getattr(self, f.name)
            if not (kind.holds(value) or (value is None and f.default is None)):
                found = kind.to_file(value)
                shown = f"{found:.10g}" if isinstance(found, float) else quote(found)
                raise TrajectoryError(f"{key}: found {shown}, expected {kind.expected}")


def build_from_table(kind: type[T], table: TomlTable, **others: Any) -> T:
    """Build a dataclass, whose fields of `quantity`, `whole` and `choice` are the keys, from a
    table of a file; `others` are fields that the file does not state."""
    known = {key: (field, unit) for key, field, unit in keys(kind)}
    table.check_known(known)
    for key, (f, unit) in known.items():
        if key not in table.values and f.name not in others and f.default is MISSING:
            raise table.missing(key, unit.expected)
    values = {
        known[key][0].name: known[key][1].from_file(table.values[key]) for key in table.values
    }
    try:
        return kind(**values, **others)
    except TrajectoryError as error:
        raise table.error_class(f"{table.source}: {table.prefix}{error}") from None


def _is_number(value: object) -> TypeGuard[float]:
    """Finite, and no truth value; whole numbers of a file may be beyond all floats."""
    if isinstance(value, bool) or not isinstance(value, int | float):
        return False
    return abs(value) <= sys.float_info.max
