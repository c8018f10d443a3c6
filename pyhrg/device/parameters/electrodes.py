"""Parameters of the electrodes: the pick-offs with their demodulation, and the drives."""

from dataclasses import dataclass

from pyhrg.common.units import DEG_PER_H, MINUTE, STANDARD_GRAVITY
from pyhrg.device.declarations import EffectDeclaration, parameter


@dataclass(frozen=True)
class PickoffParameters:
    """Errors of what the electronics read; ratios on the modal axes, SI."""

    pickoff_gain_mismatch: float = parameter(
        key="pickoff_gain_mismatch",
        limits=(-0.5, 0.5),
        fmu="pickOff.gainMismatch",
        effect=EffectDeclaration("pickoff_gain_mismatch", 1e-3, ("wave_angle",), 3),
    )
    """x reads (1 + g/2), y reads (1 - g/2) [g]."""
    pickoff_gain_per_kelvin: float = parameter(
        key="pickoff_gain_per_K",
        limits=(-0.01, 0.01),
        fmu="pickOff.gainPerKelvin",
        effect=EffectDeclaration(
            "pickoff_gain_temperature", 1e-5, ("temperature", "wave_angle"), 21
        ),
    )
    """Change of g with temperature, 1/K."""
    pickoff_gain_per_acceleration: float = parameter(
        key="pickoff_gain_per_g",
        unit=1 / STANDARD_GRAVITY,
        limits=(-0.09, 0.09),
        fmu="pickOff.gainPerAcceleration[1]",
        effect=EffectDeclaration(
            "g_sensitive_gain", 1e-4 / STANDARD_GRAVITY, ("acceleration",), 24
        ),
    )
    """Change of g with specific force along x, s2/m."""
    pickoff_nonorthogonality: float = parameter(
        key="pickoff_nonorthogonality",
        limits=(-0.5, 0.5),
        fmu="pickOff.nonOrthogonality",
        effect=EffectDeclaration("pickoff_nonorthogonality", 1e-3, ("wave_angle",), 4),
    )
    """y reads y + d x [d]."""
    pickoff_cubic: float = parameter(
        key="pickoff_cubic",
        limits=(-0.1, 0.1),
        fmu="pickOff.cubic",
        effect=EffectDeclaration(
            "pickoff_cubic_nonlinearity", 1e-3, ("amplitude", "wave_angle"), 12
        ),
    )
    """x reads x (1 + 3/4 b |x|^2), y alike [b]."""
    phase_error: float = parameter(
        key="phase_error_rad",
        limits=(-1, 1),
        fmu="pickOff.phaseError",
        effect=EffectDeclaration("demodulation_phase_error", 1e-2, ("rate", "wave_angle"), 8),
    )
    """Phase that the demodulation adds to both channels [p], rad."""
    phase_per_kelvin: float = parameter(
        key="phase_rad_per_K",
        limits=(-0.01, 0.01),
        fmu="pickOff.phasePerKelvin",
        effect=EffectDeclaration("phase_temperature", 1e-4, ("temperature", "wave_angle"), 20),
    )
    """Change of p with temperature, rad/K."""
    differential_phase: float = parameter(
        key="differential_phase_rad",
        limits=(-1, 1),
        fmu="pickOff.differentialPhase",
        effect=EffectDeclaration("differential_phase_error", 1e-2, ("wave_angle",), 9),
    )
    """Phase of x over that of y: x turned by half of it, y by minus half, rad."""
    demodulation_offset: float = parameter(
        key="demodulation_offset",
        limits=(-0.1, 0.1),
        fmu="pickOff.offset",
        effect=EffectDeclaration("demodulation_offset", 1e-3, ("wave_angle",), 11),
    )
    """Added to the in-phase x channel [x0], amplitude units."""
    demodulation_offset_y: float = parameter(
        key="demodulation_offset_y", limits=(-0.1, 0.1), fmu="pickOff.offsetY"
    )
    """Added to the in-phase y channel [y0], amplitude units."""
    feedthrough: float = parameter(
        key="feedthrough_s",
        limits=(-0.01, 0.01),
        fmu="pickOff.feedthrough",
        effect=EffectDeclaration("drive_feedthrough", 1e-4, ("amplitude", "wave_angle"), 14),
    )
    """Pick-offs read this time the force as well [c], s."""


@dataclass(frozen=True)
class DriveParameters:
    """Errors of the forces; ratios on the modal axes, SI."""

    drive_gain_mismatch: float = parameter(
        key="drive_gain_mismatch",
        limits=(-0.5, 0.5),
        fmu="drive.gainMismatch",
        effect=EffectDeclaration("drive_gain_mismatch", 1e-3, ("wave_angle",), 5),
    )
    """x drives (1 + gd/2), y drives (1 - gd/2) [gd]."""
    drive_nonorthogonality: float = parameter(
        key="drive_nonorthogonality",
        limits=(-0.5, 0.5),
        fmu="drive.nonOrthogonality",
        effect=EffectDeclaration("drive_nonorthogonality", 1e-3, ("wave_angle",), 6),
    )
    """y drives fy + nd fx [nd]."""
    drive_frame_rotation: float = parameter(
        key="drive_frame_rotation_rad",
        limits=(-0.5, 0.5),
        fmu="drive.frameRotation",
        effect=EffectDeclaration("drive_frame_rotation", 1e-3, ("time",), 7),
    )
    """Force frame turned against the pick-offs' on the modal axes [e], rad."""
    bias_per_temperature_rate: float = parameter(
        key="bias_deg_h_per_K_min",
        unit=DEG_PER_H * MINUTE,
        limits=(-10, 10),
        effect=EffectDeclaration(
            "temperature_rate_bias", 0.1 * DEG_PER_H * MINUTE, ("temperature_rate",), 22
        ),
    )
    """Output bias over the rate of the case's temperature, rad/s per K/s."""
    bias_per_acceleration: float = parameter(
        key="bias_deg_h_per_g",
        unit=DEG_PER_H / STANDARD_GRAVITY,
        limits=(-10, 10),
        effect=EffectDeclaration(
            "g_sensitive_bias", 0.1 * DEG_PER_H / STANDARD_GRAVITY, ("acceleration",), 23
        ),
    )
    """Output bias over specific force along the input axis, by rotation of the force frame; rad/s
    per m/s2."""
