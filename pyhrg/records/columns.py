"""What stands in a log: each column's name in the file, and what it is in SI."""

import math
import re
from dataclasses import dataclass
from typing import Literal

from pyhrg.common.errors import HrgError
from pyhrg.common.units import DEG


class LogError(HrgError):
    """The log can't be used; the message names file, row, column, and what was expected."""


@dataclass(frozen=True)
class Column:
    """A quantity of a log.

    SI value = factor * value in the file + offset.
    """

    field: str
    """In `Log`."""
    stem: str
    """Name in the file, without its unit."""
    unit: str
    """In the file; empty for a pure number."""
    role: Literal["reference", "command", "response"]
    """Measured by the test bench, commanded by it, or measured by the gyro."""
    quantity: str
    factor: float = 1.0
    offset: float = 0.0
    lowest: float = -math.inf
    """Least value that makes sense, in the file's unit."""
    highest: float = math.inf
    digits: int = 12
    """Significant digits that are written: well below the noise of any gyro."""
    optional: bool = False
    """Beyond the campaign format: nothing is said where it isn't there."""

    @property
    def name(self) -> str:
        """Name in the file, unit included."""
        return f"{self.stem}_{self.unit}" if self.unit else self.stem


COLUMNS = (
    Column("time", "time", "s", "reference", "end of the interval", digits=15),
    Column(
        *("table_angle", "table_angle", "deg", "reference"),
        "turntable encoder, about the input axis; 0 at start",
        factor=DEG,
        digits=15,
    ),
    Column(
        *("axis_up", "axis_up", "", "command"),
        "projection of the input axis on local up",
        lowest=-1.0,
        highest=1.0,
    ),
    Column("acceleration_x", "accel_x", "m_s2", "reference", "specific force, gyro's x"),
    Column("acceleration_y", "accel_y", "m_s2", "reference", "specific force, gyro's y"),
    Column("acceleration_z", "accel_z", "m_s2", "reference", "specific force, input axis"),
    Column(
        *("temperature", "temperature", "degC", "reference"),
        "of the case",
        offset=273.15,
        lowest=-100.0,
        highest=150.0,
    ),
    Column(
        *("virtual_rotation", "virtual_rotation", "deg_s", "command"),
        "commanded rotation, as an input rate",
        factor=DEG,
        digits=15,
    ),
    Column(
        *("amplitude_setpoint", "amplitude_setpoint", "", "command"),
        "commanded amplitude; nominal 1",
        lowest=0.0,
    ),
    Column(
        *("phase_offset", "phase_offset", "rad", "command"),
        "commanded offset added to the detected phase",
        lowest=-math.pi,
        highest=math.pi,
    ),
    Column(
        *("drive_on", "drive_on", "", "command"),
        "0 while amplitude, quadrature and rotation forces are off",
        lowest=0.0,
        highest=1.0,
    ),
    Column(
        *("gyro_angle", "gyro_angle", "deg", "response"),
        "the gyro's output; positive with the case's rotation",
        factor=DEG,
        digits=15,
    ),
    Column(
        *("wave_angle", "wave_angle", "deg", "response"),
        "detected pattern angle, physical, continuous",
        factor=DEG,
        digits=15,
    ),
    Column(
        *("amplitude", "amplitude", "", "response"),
        "detected antinode amplitude; nominal 1",
        lowest=0.0,
    ),
    Column(
        *("amplitude_force", "amplitude_force", "per_s", "response"),
        "amplitude-loop force over detected amplitude",
    ),
    Column(
        *("quadrature_force", "quadrature_force", "per_s", "response"),
        "quadrature-loop force, amplitude units per second",
    ),
    Column(
        *("frequency_offset", "frequency_offset", "Hz", "response"),
        "phase-loop frequency less the nominal one",
        factor=2 * math.pi,
    ),
    Column(
        *("valid", "valid", "", "response"),
        "share of the interval in which the output was valid",
        lowest=0.0,
        highest=1.0,
        optional=True,
    ),
)
"""In the order in which they are written."""

BY_FIELD = {column.field: column for column in COLUMNS}

ANY_UNIT = re.compile(
    r"|_(m|u)?rad(_s)?|_deg(_[sh])?|_arcsec|_deg[CF]|_[CFKVNmgsh]|_[mu]s|_min|_mg|_m_s2|_[mk]?Hz"
    r"|_per_[sh]|_ppm|_percent|_mV|_[mun]m"
)
"""Suffixes that say a unit, right or wrong, or none."""


def mislabelled(name: str) -> Column | None:
    """The column that a header's name means but gives with another unit, or with none."""
    for column in COLUMNS:
        rest = name.removeprefix(column.stem)
        if rest != name != column.name and ANY_UNIT.fullmatch(rest):
            return column
    return None
