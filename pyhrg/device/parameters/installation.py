"""Parameters of the mounting and of a power-on; the FMU does not have them."""

from dataclasses import dataclass

from pyhrg.common.units import DEG
from pyhrg.device.declarations import EffectDeclaration, parameter


@dataclass(frozen=True)
class InstallationParameters:
    """How the gyro stands on the turntable, and where its vibration starts; SI."""

    misalignment: float = parameter(
        key="misalignment_rad",
        limits=(0, 0.5),
        effect=EffectDeclaration(
            "input_axis_misalignment",
            1e-3,
            ("table_angle",),
            25,
            angle="misalignment_direction",
            periods=1,
        ),
    )
    """Tilt of the input axis from the table's axis, rad; the mounting's, not the FMU's."""
    misalignment_direction: float = parameter(
        key="misalignment_direction_deg", unit=DEG, limits=(-360, 360)
    )
    """Azimuth about the table's axis to which the input axis tilts at table angle 0, rad."""
    power_on_angle: float = parameter(key="power_on_angle_deg", unit=DEG, limits=(-360, 360))
    """Pattern angle at which the electronics start the vibration, rad."""
    power_on_scatter: float = parameter(key="power_on_scatter_deg", unit=DEG, limits=(0, 45))
    """Standard deviation of that angle from one power-on to the next, rad."""
