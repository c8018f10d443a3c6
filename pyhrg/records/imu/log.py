"""The log of an IMU: increments, the columns of a log as a table (CSV, Parquet), and the numbers of
its text files."""

import io
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from pyhrg.common.arrays import Array
from pyhrg.common.errors import describe_briefly, quote
from pyhrg.common.reading.limits import LARGEST_NUMBER
from pyhrg.common.units import DEG, STANDARD_GRAVITY
from pyhrg.records.columns import LogError

AXES = ("x", "y", "z")
"""Body axes: forward, right, down."""
TIME = "time_s"


@dataclass(frozen=True)
class Quantity:
    """Three columns of one quantity: SI value = factor * value.

    Attributes:
        integral: whether a value is the integral over the interval (an increment) or the mean over
            it.
    """

    name: str
    unit: str
    factor: float
    integral: bool

    def column(self, axis: str) -> str:
        """Name of an axis's column in the file."""
        return "_".join(filter(None, (self.name, axis, self.unit)))

    @property
    def columns(self) -> tuple[str, ...]:
        """Names of the columns of x, y and z."""
        return tuple(self.column(axis) for axis in AXES)


ROTATION = Quantity("rotation", "rad", 1.0, True)
VELOCITY = Quantity("velocity", "m_s", 1.0, True)
GYROS = (
    ROTATION,
    Quantity("rotation", "deg", DEG, True),
    Quantity("gyro", "rad_s", 1.0, False),
    Quantity("gyro", "deg_s", DEG, False),
)
ACCELEROMETERS = (
    VELOCITY,
    Quantity("accelerometer", "m_s2", 1.0, False),
    Quantity("accelerometer", "g", STANDARD_GRAVITY, False),
)
"""`time_s` is the end of each row's interval; increments (`rotation_x_rad`, `velocity_x_m_s`) or
means over the interval (`gyro_x_deg_s`, `accelerometer_x_m_s2`), x forward, y right, z down."""
PATTERN = Quantity("pattern", "deg", DEG, False)
"""Optional columns: pattern angles of whole-angle gyros at the end of each row's interval."""


def choose_quantity(source: str, header: Sequence[str], among: Sequence[Quantity]) -> Quantity:
    """The quantity whose three columns a header has."""
    for name in header:
        if header.count(name) > 1:
            raise LogError(f"{source}: column {name}: found more than once, expected once")
    present = [q for q in among if any(column in header for column in q.columns)]
    if len(present) > 1:
        names = " and ".join(q.column("x") for q in present)
        raise LogError(f"{source}: found columns {names}, expected one kind of them")
    missing = [column for q in present for column in q.columns if column not in header]
    if not present or missing:
        kinds = " or ".join(q.column("x") for q in among)
        raise LogError(
            f"{source}: found no column {missing[0] if missing else kinds}, expected it "
            f"among {', '.join(header)}"
        )
    return present[0]


@dataclass(frozen=True)
class Increments:
    """Integrals of rotation rate and specific force over equal intervals, in body axes (forward,
    right, down).

    Attributes:
        interval: length of an interval, s.
        rotation: (n, 3) integral of `omega_ib_b`, rad.
        velocity: (n, 3) integral of the specific force `f_b`, m/s.
        start: time at the beginning of the first interval, s.
    """

    interval: float
    rotation: NDArray[np.float64]
    velocity: NDArray[np.float64]
    start: float = 0.0

    def __len__(self) -> int:
        return len(self.rotation)

    @property
    def duration(self) -> float:
        """Duration of all intervals, s."""
        return len(self) * self.interval

    @property
    def bounds(self) -> NDArray[np.float64]:
        """(n + 1,) times at which intervals begin and end, s."""
        return np.asarray(self.start + self.interval * np.arange(len(self) + 1.0))

    def between(self, first: int, last: int) -> "Increments":
        """The increments of intervals `first` to `last - 1`."""
        return Increments(
            self.interval,
            self.rotation[first:last],
            self.velocity[first:last],
            self.start + first * self.interval,
        )


MIN_ROWS = 10
"""Smallest number of rows of a log. Chosen: fewer show neither an interval nor a unit."""


@dataclass(frozen=True)
class RecordedImu:
    """A recorded log of an IMU.

    Attributes:
        increments: increments in body axes (forward, right, down).
        position: (3,) latitude, longitude (rad), height (m); None if the log states none.
        attitude: (3,) coarse roll, pitch and yaw at the start, rad; None if the log states none.
        source: the file.
        pattern_angle: (n, 3) pattern angles of whole-angle gyros at the end of each interval, rad;
            None if the log has none.
    """

    increments: Increments
    position: Array | None
    attitude: Array | None
    source: str
    pattern_angle: Array | None = None

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
