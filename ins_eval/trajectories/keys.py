"""Fields of missions and manoeuvres: SI inside; in files a unit in the key, and a range."""

import sys
from collections.abc import Callable, Iterator
from dataclasses import MISSING, Field, dataclass, field, fields
from typing import Any, TypeGuard, TypeVar

from ins_eval.trajectories.errors import TrajectoryError
from pyhrg.common.errors import HrgError, quote
from pyhrg.common.toml_table import TomlTable
from pyhrg.common.units import ARCSEC, DEG

UNITS = {"arcsec": ARCSEC, "deg": DEG, "deg_s": DEG, "m": 1.0, "m_s": 1.0, "s": 1.0, "": 1.0}
"""SI value of each unit that a key may end in; a number without one has none."""


@dataclass(frozen=True)
class Kind:
    """The values that a field takes.

    Attributes:
        expected: what they are, in words.
        holds: whether a file's value is one of them.
        unit: of a quantity in a file, a key of `UNITS`; None of other values, which are the same in
            files and inside.
    """

    expected: str
    holds: Callable[[Any], bool]
    unit: str | None = None

    def from_file(self, value: Any) -> Any:
        """The value inside of a file's value."""
        return value if self.unit is None or not _is_number(value) else value * UNITS[self.unit]

    def to_file(self, value: Any) -> Any:
        """The file's value of a value inside."""
        return value if self.unit is None or not _is_number(value) else value / UNITS[self.unit]


def quantity(unit: str, low: float, high: float, default: Any = MISSING) -> Any:
    """A field whose key in files is its name and unit; range and default in that unit. The range
    allows for rounding."""
    slack = 1e-12 * max(abs(low), abs(high))
    kind = Kind(
        f"{low:g} to {high:g}{' ' * bool(unit)}{unit.replace('_', '/')}",
        lambda value: _is_number(value) and low - slack <= value <= high + slack,
        unit,
    )
    if default is not MISSING:
        default = kind.from_file(default)
    return field(default=default, metadata={"kind": kind})


def whole(low: int, high: int, default: Any = MISSING) -> Any:
    """A field that is a whole number; a default of None means that it may be left out."""
    kind = Kind(
        f"a whole number from {low} to {high}",
        lambda value: type(value) is int and low <= value <= high,
    )
    return field(default=default, metadata={"kind": kind})


def choice(*words: str, required: bool = False) -> Any:
    """A field that is one of some words, the first of them by default unless it is required."""
    expected = " or ".join(f'"{word}"' for word in words)
    kind = Kind(expected, lambda value: isinstance(value, str) and value in words)
    return field(default=MISSING if required else words[0], metadata={"kind": kind})


def keys(table: type) -> Iterator[tuple[str, Field[Any], Kind]]:
    """Key in files, field, and kind of all fields of a dataclass that have one."""
    for f in fields(table):
        if kind := f.metadata.get("kind"):
            yield f"{f.name}_{kind.unit}" if kind.unit else f.name, f, kind


T = TypeVar("T", bound="Checked")


@dataclass(frozen=True, kw_only=True)
class Checked:
    """Refuses values out of range."""

    def __post_init__(self) -> None:
        for key, f, kind in keys(type(self)):
            value = kind.to_file(getattr(self, f.name))
            if not (kind.holds(value) or (value is None and f.default is None)):
                shown = f"{value:.10g}" if isinstance(value, float) else quote(value)
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
        raise HrgError(f"{table.source}: {table.prefix}{error}") from None


def _is_number(value: object) -> TypeGuard[float]:
    """Finite, and no truth value; whole numbers of a file may be beyond all floats."""
    if isinstance(value, bool) or not isinstance(value, int | float):
        return False
    return abs(value) <= sys.float_info.max
