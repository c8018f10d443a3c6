"""Parameters of the resonator: damping, stiffness, coupling, temperature."""

from dataclasses import dataclass

from pyhrg.common.units import DEG, HZ, PPM, ZERO_CELSIUS
from pyhrg.device.declarations import EffectDeclaration, ToleranceDeclaration, parameter


@dataclass(frozen=True)
class ResonatorParameters:
    """The shell and its temperature; SI, angles are physical pattern angles."""

    bryan_factor: float = parameter(
        0.277, key="coriolis_factor", limits=(0.02, 0.9), fmu="controller.readout.bryanFactor"
    )
    """Precession of the pattern over rotation of the case, as the electronics believe it [k]."""
    bryan_factor_error: float = parameter(
        key="coriolis_factor_error_ppm",
        unit=PPM,
        limits=(-1e5, 1e5),
        effect=EffectDeclaration("coriolis_factor_error", 100 * PPM, ("rate",), 16),
    )
    """True over believed Bryan factor, less one."""
    decay_time: float = parameter(
        450.0,
        key="decay_time_s",
        limits=(1, 1e5),
        fmu="resonator.material.decayTime",
        known=ToleranceDeclaration("nominal_decay_time", "nominal", 45.0, relative_tolerance=0.01),
    )
    """Mean amplitude decay time [tau], s."""
    decay_time_per_kelvin: float = parameter(
        key=("decay_time_per_K", "decay_time_temperature_coefficient_per_K"),
        limits=(-0.1, 0.1),
        fmu="resonator.material.decayTimePerKelvin",
        effect=EffectDeclaration("decay_time_temperature", 1e-3, ("temperature", "wave_angle"), 19),
    )
    """Relative change of the decay time with temperature, 1/K."""
    damping_anisotropy: float = parameter(
        key="damping_anisotropy_per_s",
        limits=(0, 1e-2),
        fmu="resonator.material.dampingAnisotropy",
        effect=EffectDeclaration(
            "damping_anisotropy", 1e-5, ("wave_angle",), 1, angle="damping_axis", periods=4
        ),
    )
    """1/tau1 - 1/tau2 between the axes of maximum and minimum damping [D], 1/s."""
    damping_axis: float = parameter(
        key="damping_axis_deg", unit=DEG, limits=(-360, 360), fmu="resonator.material.dampingAxis"
    )
    """Pattern angle of maximum damping [th_tau], rad."""
    damping_anisotropy_per_kelvin: float = parameter(
        key="damping_anisotropy_per_K",
        limits=(-1, 1),
        fmu="resonator.material.dampingAnisotropyPerKelvin",
        effect=EffectDeclaration(
            "damping_anisotropy_temperature", 0.05, ("temperature", "wave_angle"), 18
        ),
    )
    """Relative change of the damping anisotropy with temperature, 1/K."""
    frequency: float = parameter(
        7000 * HZ,
        key="frequency_Hz",
        unit=HZ,
        limits=(200, 1e5),
        fmu="resonator.material.frequency",
    )
    """Modal frequency [w], rad/s."""
    frequency_per_kelvin: float = parameter(
        key="frequency_temperature_coefficient_per_K",
        limits=(-1e-3, 1e-3),
        fmu="resonator.material.frequencyPerKelvin",
        known=ToleranceDeclaration(
            "nominal_frequency_temperature_coefficient", "nominal", 1e-6, 1e-8, 0.01
        ),
    )
    """Relative change of the modal frequency with temperature, 1/K."""
    frequency_split: float = parameter(
        key="frequency_split_Hz",
        unit=HZ,
        limits=(0, 10),
        fmu="resonator.material.frequencySplit",
        effect=EffectDeclaration(
            "frequency_split", 2e-4 * HZ, ("wave_angle",), 2, angle="stiffness_axis", periods=4
        ),
    )
    """Difference of the modes' circular frequencies [dw], rad/s."""
    stiffness_axis: float = parameter(
        key="stiffness_axis_deg",
        unit=DEG,
        limits=(-360, 360),
        fmu="resonator.material.stiffnessAxis",
    )
    """Pattern angle of the mode of lower frequency [th_w], rad."""
    duffing: float = parameter(
        key="duffing_Hz",
        unit=HZ,
        limits=(-10, 10),
        fmu="resonator.material.duffing",
        effect=EffectDeclaration("duffing_stiffness", 1e-2 * HZ, ("amplitude",), 13),
    )
    """Frequency shift at unit amplitude by cubic stiffness, rad/s."""
    thermal_lag: float = parameter(
        600.0,
        key="thermal_lag_s",
        limits=(1, 1e6),
        fmu="resonator.environment.thermalLag",
        known=ToleranceDeclaration("nominal_thermal_lag", "nominal", 60.0, relative_tolerance=0.05),
    )
    """Time constant of the resonator's temperature behind the case's, s."""
    reference_temperature: float = parameter(
        298.15,
        key="reference_temperature_degC",
        limits=(-150, 200),
        zero=ZERO_CELSIUS,
        fmu=("caseTemperature", "resonator.environment.referenceTemperature"),
    )
    """Temperature that the parameters hold at, K."""
