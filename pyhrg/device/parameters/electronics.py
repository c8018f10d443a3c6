"""Parameters of the control electronics: set points, loops, timing, read-out."""

from dataclasses import dataclass

from pyhrg.common.units import PPM
from pyhrg.device.declarations import EffectDeclaration, ToleranceDeclaration, parameter


@dataclass(frozen=True)
class ElectronicsParameters:
    """What the loops hold, how fast, and what they do not do as told; SI."""

    amplitude: float = parameter(
        1.0, key="amplitude", limits=(0.01, 10), fmu=("startAmplitude", "amplitudeSetpoint")
    )
    """Antinode amplitude that is held."""
    residual_quadrature: float = parameter(
        key="residual_quadrature",
        limits=(-0.5, 0.5),
        fmu="controller.quadratureSetpoint",
        effect=EffectDeclaration("residual_quadrature", 1e-3, ("wave_angle",), 10),
    )
    """Set point of the quadrature loop [q0], amplitude units."""
    amplitude_loop: float = parameter(
        6.0,
        key="amplitude_loop_rad_s",
        limits=(0.01, 500),
        fmu="controller.amplitudeLoop.naturalFrequency",
        known=ToleranceDeclaration(
            "nominal_amplitude_loop", "nominal", 0.6, relative_tolerance=0.02
        ),
    )
    """Natural frequency of the amplitude loop, rad/s."""
    quadrature_loop: float = parameter(
        6.0,
        key="quadrature_loop_rad_s",
        limits=(0.01, 500),
        fmu="controller.quadratureLoop.naturalFrequency",
        known=ToleranceDeclaration(
            "nominal_quadrature_loop", "nominal", 0.6, relative_tolerance=0.02
        ),
    )
    """Natural frequency of the quadrature loop, rad/s."""
    phase_loop: float = parameter(
        200.0,
        key="phase_loop_rad_s",
        limits=(0.01, 500),
        fmu="controller.phaseLoop.naturalFrequency",
        known=ToleranceDeclaration("nominal_phase_loop", "nominal", 20.0, relative_tolerance=0.02),
    )
    """Natural frequency of the phase loop, rad/s."""
    control_period: float = parameter(1e-3, key="control_period_s", limits=(1e-3, 1e-3))
    """Period of the control electronics [Ts], s; the FMU knows this one alone."""
    loop_delay: float = parameter(
        key="loop_delay_s",
        limits=(0, 0.1),
        fmu="controller.synthesis.loopDelay",
        effect=EffectDeclaration("loop_delay", 1e-3, ("rate",), 15),
    )
    """Delay from detected angle to force, beyond the hold [td], s."""
    virtual_rotation_error: float = parameter(
        key="virtual_rotation_gain_ppm",
        unit=PPM,
        limits=(-1e5, 1e5),
        fmu="controller.readout.virtualRotationError",
        effect=EffectDeclaration("virtual_rotation_gain", 100 * PPM, ("rate",), 17),
    )
    """True over commanded virtual rotation, less one."""
