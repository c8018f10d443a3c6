"""Parameters of the drives: how the force on the shell differs from the command."""

from dataclasses import dataclass

from pyhrg.common.units import DEG_PER_H, MINUTE, STANDARD_GRAVITY
from pyhrg.device.declarations import EffectDeclaration, parameter


@dataclass(frozen=True)
class DriveParameters:
    """Errors of the forces; ratios on the modal axes, SI."""

    drive_gain_mismatch: float = parameter(
        key="drive_gain_mismatch",
        limits=(-0.5, 0.5),
        fmu="drive.gainMismatch",
        effect=EffectDeclaration("drive_gain_mismatch", 1e-3, ("wave_angle",), position=5),
    )
    """x drives (1 + gd/2), y drives (1 - gd/2) [gd]."""
    drive_nonorthogonality: float = parameter(
        key="drive_nonorthogonality",
        limits=(-0.5, 0.5),
        fmu="drive.nonOrthogonality",
        effect=EffectDeclaration("drive_nonorthogonality", 1e-3, ("wave_angle",), position=6),
    )
    """y drives fy + nd fx [nd]."""
    drive_frame_rotation: float = parameter(
        key="drive_frame_rotation_rad",
        limits=(-0.5, 0.5),
        fmu="drive.frameRotation",
        effect=EffectDeclaration("drive_frame_rotation", 1e-3, ("time",), position=7),
    )
    """Force frame turned against the pick-offs' on the modal axes [e], rad."""
    bias_per_temperature_rate: float = parameter(
        key="bias_deg_h_per_K_min",
        unit=DEG_PER_H * MINUTE,
        limits=(-10, 10),
        effect=EffectDeclaration(
            "temperature_rate_bias", 0.1 * DEG_PER_H * MINUTE, ("temperature_rate",), position=22
        ),
    )
    """Output bias over the rate of the case's temperature, rad/s per K/s."""
    bias_per_acceleration: float = parameter(
        key="bias_deg_h_per_g",
        unit=DEG_PER_H / STANDARD_GRAVITY,
        limits=(-10, 10),
        effect=EffectDeclaration(
            "g_sensitive_bias", 0.1 * DEG_PER_H / STANDARD_GRAVITY, ("acceleration",), position=23
        ),
    )
    """Output bias over specific force along the input axis, by rotation of the force frame; rad/s
    per m/s2."""
