"""Parameters of the resonator, its pick-offs and its drives."""

from dataclasses import dataclass

from pyhrg.common.units import DEG, DEG_PER_H, HZ, MINUTE, PPM, STANDARD_GRAVITY, ZERO_CELSIUS
from pyhrg.device.declarations import EffectDeclaration, ToleranceDeclaration, parameter


@dataclass(frozen=True)
class ResonatorParameters:
    """Parameters of the resonator, its temperature, pick-offs and drives. SI; ratios are on the
    modal axes, angles are physical pattern angles."""

    bryan_factor: float = parameter(
        0.277, key="coriolis_factor", limits=(0.02, 0.9), fmu="controller.readout.bryanFactor"
    )
    """Angular gain (Bryan factor) that the electronics use [k]."""
    bryan_factor_error: float = parameter(
        key="coriolis_factor_error_ppm",
        unit=PPM,
        limits=(-1e5, 1e5),
        effect=EffectDeclaration("coriolis_factor_error", 100 * PPM, ("rate",), position=16),
    )
    """True angular gain over the one that the electronics use, less one."""
    decay_time: float = parameter(
        450.0,
        key="decay_time_s",
        limits=(1, 1e5),
        fmu="resonator.material.decayTime",
        tolerance=ToleranceDeclaration(
            "nominal_decay_time", "nominal", 45.0, relative_tolerance=0.01
        ),
    )
    """Mean amplitude decay time [tau], s."""
    decay_time_per_kelvin: float = parameter(
        key=("decay_time_per_K", "decay_time_temperature_coefficient_per_K"),
        limits=(-0.1, 0.1),
        fmu="resonator.material.decayTimePerKelvin",
        effect=EffectDeclaration(
            "decay_time_temperature", 1e-3, ("temperature", "wave_angle"), position=19
        ),
    )
    """Relative change of the decay time with temperature, 1/K."""
    damping_anisotropy: float = parameter(
        key="damping_anisotropy_per_s",
        limits=(0, 1e-2),
        fmu="resonator.material.dampingAnisotropy",
        effect=EffectDeclaration(
            "damping_anisotropy", 1e-5, ("wave_angle",), position=1, angle="damping_axis", periods=4
        ),
    )
    """Damping anisotropy: 1/tau1 - 1/tau2 of the axes of maximum and minimum damping [D], 1/s."""
    damping_axis: float = parameter(
        key="damping_axis_deg", unit=DEG, limits=(-360, 360), fmu="resonator.material.dampingAxis"
    )
    """Pattern angle of maximum damping [th_tau], rad."""
    damping_anisotropy_per_kelvin: float = parameter(
        key="damping_anisotropy_per_K",
        limits=(-1, 1),
        fmu="resonator.material.dampingAnisotropyPerKelvin",
        effect=EffectDeclaration(
            "damping_anisotropy_temperature", 0.05, ("temperature", "wave_angle"), position=18
        ),
        group="damping_anisotropy",
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
        tolerance=ToleranceDeclaration(
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
            "frequency_split",
            2e-4 * HZ,
            ("wave_angle",),
            position=2,
            angle="stiffness_axis",
            periods=4,
        ),
        group="frequency_split_and_phase_errors",
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
        effect=EffectDeclaration("duffing_stiffness", 1e-2 * HZ, ("amplitude",), position=13),
    )
    """Frequency shift at unit amplitude by cubic stiffness, rad/s."""
    electrostatic_cubic: float = parameter(
        key="electrostatic_cubic_Hz",
        unit=HZ,
        limits=(-10, 10),
        fmu="resonator.material.electrostaticCubic",
        effect=EffectDeclaration("electrostatic_cubic", 1e-3 * HZ, ("amplitude", "wave_angle")),
    )
    """Softening of x, and of y, by eight electrodes: decrease of its frequency at its own unit
    amplitude [delta], rad/s."""
    thermal_lag: float = parameter(
        600.0,
        key="thermal_lag_s",
        limits=(1, 1e6),
        fmu="resonator.environment.thermalLag",
        tolerance=ToleranceDeclaration(
            "nominal_thermal_lag", "nominal", 60.0, relative_tolerance=0.05
        ),
    )
    """Time constant of the resonator's temperature behind the case's, s."""
    reference_temperature: float = parameter(
        298.15,
        key="reference_temperature_degC",
        limits=(-150, 200),
        zero=ZERO_CELSIUS,
        fmu=("caseTemperature", "resonator.environment.referenceTemperature"),
    )
    """Temperature at which the parameters hold, K."""
    pickoff_gain_mismatch: float = parameter(
        key="pickoff_gain_mismatch",
        limits=(-0.5, 0.5),
        fmu="pickOff.gainMismatch",
        effect=EffectDeclaration("pickoff_gain_mismatch", 1e-3, ("wave_angle",), position=3),
    )
    """Gain mismatch of the pick-offs: x reads (1 + g/2), y reads (1 - g/2) [g]."""
    pickoff_gain_per_kelvin: float = parameter(
        key="pickoff_gain_per_K",
        limits=(-0.01, 0.01),
        fmu="pickOff.gainPerKelvin",
        effect=EffectDeclaration(
            "pickoff_gain_temperature", 1e-5, ("temperature", "wave_angle"), position=21
        ),
    )
    """Change of the pick-offs' gain mismatch with temperature, 1/K."""
    pickoff_gain_per_acceleration: float = parameter(
        key="pickoff_gain_per_g",
        unit=1 / STANDARD_GRAVITY,
        limits=(-0.09, 0.09),
        fmu="pickOff.gainPerAcceleration[1]",
        effect=EffectDeclaration(
            "g_sensitive_gain", 1e-4 / STANDARD_GRAVITY, ("acceleration",), position=24
        ),
    )
    """Change of the pick-offs' gain mismatch with specific force along x, s2/m."""
    pickoff_nonorthogonality: float = parameter(
        key="pickoff_nonorthogonality",
        limits=(-0.5, 0.5),
        fmu="pickOff.nonOrthogonality",
        effect=EffectDeclaration("pickoff_nonorthogonality", 1e-3, ("wave_angle",), position=4),
    )
    """Non-orthogonality of the pick-offs: y reads y + d x [d]."""
    pickoff_cubic: float = parameter(
        key="pickoff_cubic",
        limits=(-0.1, 0.1),
        fmu="pickOff.cubic",
        effect=EffectDeclaration(
            "pickoff_cubic_nonlinearity", 1e-3, ("amplitude", "wave_angle"), position=12
        ),
    )
    """Cubic nonlinearity of the pick-offs: x reads x (1 + 3/4 b |x|^2), y likewise [b]."""
    sampling_skew: float = parameter(
        key="sampling_skew_s",
        limits=(-1e-3, 1e-3),
        fmu="pickOff.samplingSkew",
        effect=EffectDeclaration("sampling_skew", 1e-5, ("rate", "wave_angle")),
    )
    """Time after x at which y is sampled [ts], s."""
    phase_error: float = parameter(
        key="phase_error_rad",
        limits=(-1, 1),
        fmu="pickOff.phaseError",
        effect=EffectDeclaration(
            "demodulation_phase_error", 1e-2, ("rate", "wave_angle"), position=8
        ),
        group="frequency_split_and_phase_errors",
    )
    """Phase that the demodulation adds to both channels [p], rad."""
    phase_per_kelvin: float = parameter(
        key="phase_rad_per_K",
        limits=(-0.01, 0.01),
        fmu="pickOff.phasePerKelvin",
        effect=EffectDeclaration(
            "phase_temperature", 1e-4, ("temperature", "wave_angle"), position=20
        ),
        group="frequency_split_and_phase_errors",
    )
    """Change of that phase with temperature, rad/K."""
    differential_phase: float = parameter(
        key="differential_phase_rad",
        limits=(-1, 1),
        fmu="pickOff.differentialPhase",
        effect=EffectDeclaration("differential_phase_error", 1e-2, ("wave_angle",), position=9),
        group="frequency_split_and_phase_errors",
    )
    """Phase of x less that of y, rad: x is turned by half of it, y by minus half."""
    demodulation_offset: float = parameter(
        key="demodulation_offset",
        limits=(-0.1, 0.1),
        fmu="pickOff.offset",
        effect=EffectDeclaration("demodulation_offset", 1e-3, ("wave_angle",), position=11),
    )
    """Offset of the in-phase x channel [x0], amplitude units."""
    demodulation_offset_y: float = parameter(
        key="demodulation_offset_y",
        limits=(-0.1, 0.1),
        fmu="pickOff.offsetY",
        group="demodulation_offset",
    )
    """Offset of the in-phase y channel [y0], amplitude units."""
    feedthrough: float = parameter(
        key="feedthrough_s",
        limits=(-0.01, 0.01),
        fmu="pickOff.feedthrough",
        effect=EffectDeclaration(
            "drive_feedthrough", 1e-4, ("amplitude", "wave_angle"), position=14
        ),
    )
    """Feedthrough: pick-offs read the force as well, times this time [c], s."""
    drive_gain_mismatch: float = parameter(
        key="drive_gain_mismatch",
        limits=(-0.5, 0.5),
        fmu="drive.gainMismatch",
        effect=EffectDeclaration("drive_gain_mismatch", 1e-3, ("wave_angle",), position=5),
    )
    """Gain mismatch of the drives: x drives (1 + gd/2), y drives (1 - gd/2) [gd]."""
    drive_nonorthogonality: float = parameter(
        key="drive_nonorthogonality",
        limits=(-0.5, 0.5),
        fmu="drive.nonOrthogonality",
        effect=EffectDeclaration("drive_nonorthogonality", 1e-3, ("wave_angle",), position=6),
    )
    """Non-orthogonality of the drives: y drives fy + nd fx [nd]."""
    drive_frame_rotation: float = parameter(
        key="drive_frame_rotation_rad",
        limits=(-0.5, 0.5),
        fmu="drive.frameRotation",
        effect=EffectDeclaration("drive_frame_rotation", 1e-3, ("time",), position=7),
    )
    """Angle of the force frame against the pick-offs', on the modal axes [e], rad."""
    pump_anisotropy: float = parameter(
        key="pump_anisotropy", limits=(-0.5, 0.5), fmu="drive.pumpAnisotropy"
    )
    """Anisotropy of parametric drive: it gives 1 + n along its axis, 1 - n across it [n]."""
    pump_axis: float = parameter(
        key="pump_axis_deg", unit=DEG, limits=(-360, 360), fmu="drive.pumpAxis"
    )
    """Pattern angle at which parametric drive gives most, rad."""
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
