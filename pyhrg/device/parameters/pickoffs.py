"""Parameters of the pick-offs and of the demodulation."""

from dataclasses import dataclass

from pyhrg.common.units import STANDARD_GRAVITY
from pyhrg.device.declarations import EffectDeclaration, parameter


@dataclass(frozen=True)
class PickoffParameters:
    """Errors of what the electronics read; ratios on the modal axes, SI."""

    pickoff_gain_mismatch: float = parameter(
        key="pickoff_gain_mismatch",
        limits=(-0.5, 0.5),
        fmu="pickOff.gainMismatch",
        effect=EffectDeclaration("pickoff_gain_mismatch", 1e-3, ("wave_angle",), position=3),
    )
    """x reads (1 + g/2), y reads (1 - g/2) [g]."""
    pickoff_gain_per_kelvin: float = parameter(
        key="pickoff_gain_per_K",
        limits=(-0.01, 0.01),
        fmu="pickOff.gainPerKelvin",
        effect=EffectDeclaration(
            "pickoff_gain_temperature", 1e-5, ("temperature", "wave_angle"), position=21
        ),
    )
    """Change of g with temperature, 1/K."""
    pickoff_gain_per_acceleration: float = parameter(
        key="pickoff_gain_per_g",
        unit=1 / STANDARD_GRAVITY,
        limits=(-0.09, 0.09),
        fmu="pickOff.gainPerAcceleration[1]",
        effect=EffectDeclaration(
            "g_sensitive_gain", 1e-4 / STANDARD_GRAVITY, ("acceleration",), position=24
        ),
    )
    """Change of g with specific force along x, s2/m."""
    pickoff_nonorthogonality: float = parameter(
        key="pickoff_nonorthogonality",
        limits=(-0.5, 0.5),
        fmu="pickOff.nonOrthogonality",
        effect=EffectDeclaration("pickoff_nonorthogonality", 1e-3, ("wave_angle",), position=4),
    )
    """y reads y + d x [d]."""
    pickoff_cubic: float = parameter(
        key="pickoff_cubic",
        limits=(-0.1, 0.1),
        fmu="pickOff.cubic",
        effect=EffectDeclaration(
            "pickoff_cubic_nonlinearity", 1e-3, ("amplitude", "wave_angle"), position=12
        ),
    )
    """x reads x (1 + 3/4 b |x|^2), y alike [b]."""
    phase_error: float = parameter(
        key="phase_error_rad",
        limits=(-1, 1),
        fmu="pickOff.phaseError",
        effect=EffectDeclaration(
            "demodulation_phase_error", 1e-2, ("rate", "wave_angle"), position=8
        ),
    )
    """Phase that the demodulation adds to both channels [p], rad."""
    phase_per_kelvin: float = parameter(
        key="phase_rad_per_K",
        limits=(-0.01, 0.01),
        fmu="pickOff.phasePerKelvin",
        effect=EffectDeclaration(
            "phase_temperature", 1e-4, ("temperature", "wave_angle"), position=20
        ),
    )
    """Change of p with temperature, rad/K."""
    differential_phase: float = parameter(
        key="differential_phase_rad",
        limits=(-1, 1),
        fmu="pickOff.differentialPhase",
        effect=EffectDeclaration("differential_phase_error", 1e-2, ("wave_angle",), position=9),
    )
    """Phase of x over that of y: x turned by half of it, y by minus half, rad."""
    demodulation_offset: float = parameter(
        key="demodulation_offset",
        limits=(-0.1, 0.1),
        fmu="pickOff.offset",
        effect=EffectDeclaration("demodulation_offset", 1e-3, ("wave_angle",), position=11),
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
        effect=EffectDeclaration(
            "drive_feedthrough", 1e-4, ("amplitude", "wave_angle"), position=14
        ),
    )
    """Pick-offs read this time the force as well [c], s."""
