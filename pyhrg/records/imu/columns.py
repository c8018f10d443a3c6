"""Columns of an IMU's log as a table (CSV, Parquet)."""

from collections.abc import Sequence
from dataclasses import dataclass

from pyhrg.common.units import DEG, STANDARD_GRAVITY
from pyhrg.records.columns import LogError

AXES = ("x", "y", "z")
"""Body axes: forward, right, down."""
TIME = "time_s"


@dataclass(frozen=True)
class Quantity:
    """Three columns of one quantity: SI value = factor * value.

    integral: whether a value is the integral over the interval (an increment) or the mean over it.
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
