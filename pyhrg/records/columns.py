"""The columns of a log: each one's name in the file, its unit and its quantity."""

import math
import re
from dataclasses import dataclass
from typing import Literal

from pyhrg.common.errors import HrgError
from pyhrg.common.reading.limits import LARGEST_NUMBER
from pyhrg.common.units import DEG


class LogError(HrgError):
    """The log can't be used; the message names file, row, column, and what was expected."""


@dataclass(frozen=True)
class Column:
    """A quantity of a log: SI value = factor * value in the file + offset.

    Attributes:
        field: attribute of `Log`.
        stem: name in the file, without its unit.
        unit: unit in the file; empty for a pure number.
        role: whether the test bench measures the quantity (reference), the test bench commands it,
            or the gyro measures it (response).
        lowest: smallest value allowed, in the file's unit.
        highest: largest value allowed, in the file's unit.
        digits: significant digits that are written: well below the noise of any gyro.
        optional: whether a log without the column is read without a note.
    """

    field: str
    stem: str
    unit: str
    role: Literal["reference", "command", "response"]
    factor: float = 1.0
    offset: float = 0.0
    lowest: float = -LARGEST_NUMBER
    highest: float = LARGEST_NUMBER
    digits: int = 12
    optional: bool = False

    @property
    def name(self) -> str:
        """Name in the file, unit included."""
        return f"{self.stem}_{self.unit}" if self.unit else self.stem

    @property
    def si_unit(self) -> str:
        """Unit of the field of `Log`; empty for a pure number."""
        return SI_UNITS[self.unit]


SI_UNITS = {
    "s": "s",
    "deg": "rad",
    "rad": "rad",
    "deg_s": "rad/s",
    "m_s2": "m/s2",
    "degC": "K",
    "per_s": "1/s",
    "Hz": "rad/s",
    "": "",
}
"""SI units, by a column's unit in the file."""


COLUMNS = (
    Column("time", "time", "s", "reference", digits=15),
    Column("table_angle", "table_angle", "deg", "reference", factor=DEG, digits=15),
    Column("axis_up", "axis_up", "", "command", lowest=-1.0, highest=1.0),
    Column("acceleration_x", "accel_x", "m_s2", "reference"),
    Column("acceleration_y", "accel_y", "m_s2", "reference"),
    Column("acceleration_z", "accel_z", "m_s2", "reference"),
    Column(
        "temperature",
        "temperature",
        "degC",
        "reference",
        offset=273.15,
        lowest=-100.0,
        highest=150.0,
    ),
    Column("virtual_rotation", "virtual_rotation", "deg_s", "command", factor=DEG, digits=15),
    Column("amplitude_setpoint", "amplitude_setpoint", "", "command", lowest=0.0),
    Column("phase_offset", "phase_offset", "rad", "command", lowest=-math.pi, highest=math.pi),
    Column("drive_on", "drive_on", "", "command", lowest=0.0, highest=1.0),
    Column("gyro_angle", "gyro_angle", "deg", "response", factor=DEG, digits=15),
    Column("wave_angle", "wave_angle", "deg", "response", factor=DEG, digits=15),
    Column("amplitude", "amplitude", "", "response", lowest=0.0),
    Column("amplitude_force", "amplitude_force", "per_s", "response"),
    Column("quadrature_force", "quadrature_force", "per_s", "response"),
    Column("frequency_offset", "frequency_offset", "Hz", "response", factor=2 * math.pi),
    Column("valid", "valid", "", "response", lowest=0.0, highest=1.0, optional=True),
)
"""The columns in the order in which they are written."""

BY_FIELD = {column.field: column for column in COLUMNS}

ANY_UNIT = re.compile(
    r"|_(m|u)?rad(_s)?|_deg(_[sh])?|_arcsec|_deg[CF]|_[CFKVNmgsh]|_[mu]s|_min|_mg|_m_s2|_[mk]?Hz"
    r"|_per_[sh]|_ppm|_percent|_mV|_[mun]m"
)
"""Suffixes of a column's name that state a unit, right or wrong, or none."""


def find_mislabelled_column(name: str) -> Column | None:
    """The column that a header names with another unit, or without one; None if there is none."""
    for column in COLUMNS:
        suffix = name.removeprefix(column.stem)
        if suffix != name != column.name and ANY_UNIT.fullmatch(suffix):
            return column
    return None
