"""Parameters of loops, noise, temperature and bench: one number each."""

import math
from dataclasses import dataclass

from pyhrg.common.units import ARCSEC, DEG, DEG_PER_H, DEG_PER_SQRT_H, HOUR, HZ, PPM
from pyhrg.device.declarations import EffectDeclaration, ToleranceDeclaration, parameter
from pyhrg.device.parameters.resonator import ResonatorParameters


@dataclass(frozen=True)
class LoopAndBenchParameters(ResonatorParameters):
    """Parameters of the resonator, and of loops, noise and bench; SI.

    These are what the loops hold, their speed and their errors; noise, input-referred by the
    coefficients of IEEE Std 952; the gyro's place on the turntable and its start angle; and errors
    of the bench's instruments, which the FMU does not have.
    """

    amplitude: float = parameter(
        1.0, key="amplitude", limits=(0.01, 10), fmu=("startAmplitude", "amplitudeSetpoint")
    )
    """Antinode amplitude that is held."""
    residual_quadrature: float = parameter(
        key="residual_quadrature",
        limits=(-0.5, 0.5),
        fmu="controller.quadratureSetpoint",
        effect=EffectDeclaration("residual_quadrature", 1e-3, ("wave_angle",), position=10),
        group="frequency_split_and_phase_errors",
    )
    """Set point of the quadrature loop [q0], amplitude units."""
    amplitude_loop: float = parameter(
        6.0,
        key="amplitude_loop_rad_s",
        limits=(0.01, 500),
        fmu="controller.amplitudeLoop.naturalFrequency",
        tolerance=ToleranceDeclaration(
            "nominal_amplitude_loop", "nominal", 0.6, relative_tolerance=0.02
        ),
    )
    """Natural frequency of the amplitude loop, rad/s."""
    quadrature_loop: float = parameter(
        6.0,
        key="quadrature_loop_rad_s",
        limits=(0.01, 500),
        fmu="controller.quadratureLoop.naturalFrequency",
        tolerance=ToleranceDeclaration(
            "nominal_quadrature_loop", "nominal", 0.6, relative_tolerance=0.02
        ),
    )
    """Natural frequency of the quadrature loop, rad/s."""
    phase_loop: float = parameter(
        200.0,
        key="phase_loop_rad_s",
        limits=(0.01, 500),
        fmu="controller.phaseLoop.naturalFrequency",
        tolerance=ToleranceDeclaration(
            "nominal_phase_loop", "nominal", 20.0, relative_tolerance=0.02
        ),
    )
    """Natural frequency of the phase loop, rad/s."""
    parametric_share: float = parameter(
        key="parametric_share", limits=(0, 1), fmu="controller.parametricShare"
    )
    """Share of the amplitude force that parametric drive gives."""
    sweep_angle: float = parameter(
        key="sweep_angle_deg", unit=DEG, limits=(-400, 400), fmu="controller.sweep.angle"
    )
    """Pattern angle by which the electronics turn the pattern to and fro, rad; 0: none."""
    sweep_time: float = parameter(
        10.0, key="sweep_time_s", limits=(0.1, 1e6), fmu="controller.sweep.sweepTime"
    )
    """Time of a sweep, one way, s."""
    sweep_rest: float = parameter(
        key="sweep_rest_s", limits=(0, 1e6), fmu="controller.sweep.restTime"
    )
    """Time at rest between sweeps, s."""
    control_period: float = parameter(1e-3, key="control_period_s", limits=(1e-3, 1e-3))
    """Period of the control electronics [Ts], s; the FMU has no other."""
    loop_delay: float = parameter(
        key="loop_delay_s",
        limits=(0, 0.1),
        fmu="controller.synthesis.loopDelay",
        effect=EffectDeclaration("loop_delay", 1e-3, ("rate",), position=15),
    )
    """Delay from detected angle to force, beyond the hold [td], s."""
    filter_delay: float = parameter(
        key="filter_delay_s",
        limits=(0, 0.1),
        fmu="controller.demodulation.filterDelay",
        effect=EffectDeclaration("filter_delay", 1e-3, ("rate",)),
    )
    """Delay of the demodulation's low-pass filter, s; 0: no filter."""
    time_division: float = parameter(
        key="time_division", limits=(0, 1), fmu="controller.timeDivision"
    )
    """1: the electrodes drive in one control period and sense in the next; 0: both at once."""
    virtual_rotation_error: float = parameter(
        key="virtual_rotation_gain_ppm",
        unit=PPM,
        limits=(-1e5, 1e5),
        fmu="controller.readout.virtualRotationError",
        effect=EffectDeclaration("virtual_rotation_gain", 100 * PPM, ("rate",), position=17),
    )
    """True over commanded virtual rotation, less one."""
    angle_random_walk: float = parameter(
        key="angle_random_walk_deg_sqrt_h",
        unit=DEG_PER_SQRT_H,
        limits=(0, 10),
        fmu="noise.angleRandomWalk",
        noise=EffectDeclaration("angle_random_walk", 1e-3 * DEG_PER_SQRT_H, ("noise",)),
    )
    """White force noise, as the input-referred angle random walk [N], rad/sqrt(s)."""
    rate_random_walk: float = parameter(
        key="rate_random_walk_deg_h_sqrt_h",
        unit=DEG_PER_H / math.sqrt(HOUR),
        limits=(0, 1000),
        fmu="noise.rateRandomWalk",
        noise=EffectDeclaration(
            "rate_random_walk", 1e-2 * DEG_PER_H / math.sqrt(HOUR), ("noise", "time")
        ),
    )
    """Input-referred rate random walk coefficient [K], rad/s/sqrt(s)."""
    bias_instability: float = parameter(
        key="bias_instability_deg_h",
        unit=DEG_PER_H,
        limits=(0, 1e4),
        fmu="noise.biasInstability",
        noise=EffectDeclaration("bias_instability", 1e-2 * DEG_PER_H, ("noise", "time")),
    )
    """Input-referred flicker coefficient (IEEE Std 952: the Allan deviation's floor is 0.664 B)
    [B], rad/s."""
    damping_anisotropy_flicker: float = parameter(
        key="damping_anisotropy_flicker", limits=(0, 1), fmu="flicker.dampingAnisotropy"
    )
    """Flicker coefficient of the damping anisotropy, relative to it."""
    pickoff_gain_flicker: float = parameter(
        key="pickoff_gain_flicker", limits=(0, 0.1), fmu="flicker.gainMismatch"
    )
    """Flicker coefficient of the pick-offs' gain mismatch [g]."""
    phase_flicker: float = parameter(
        key="phase_flicker_rad", limits=(0, 0.1), fmu="flicker.phaseError"
    )
    """Flicker coefficient of the phase that the demodulation adds [p], rad."""
    angle_white_noise: float = parameter(
        key="angle_white_noise_arcsec",
        unit=ARCSEC,
        limits=(0, 1e4),
        noise=EffectDeclaration("angle_white_noise", 0.1 * ARCSEC, ("noise",)),
    )
    """Standard deviation of the white noise of the detected angle, per 1 ms sample, as an angle of
    the case, rad."""
    quantization_step: float = parameter(
        key="quantum_arcsec",
        unit=ARCSEC,
        limits=(0, 3600),
        fmu="controller.readout.quantum",
        noise=EffectDeclaration("angle_quantisation", 0.3 * ARCSEC, ("noise",)),
    )
    """Quantization step of the output angle, rad; 0: none."""
    misalignment: float = parameter(
        key="misalignment_rad",
        limits=(0, 0.5),
        effect=EffectDeclaration(
            "input_axis_misalignment",
            1e-3,
            ("table_angle",),
            position=25,
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
    """Standard deviation of the power-on angle from one power-on to the next, rad."""
    frequency_error: float = parameter(
        key="frequency_error_Hz",
        unit=HZ,
        limits=(-1000, 1000),
        tolerance=ToleranceDeclaration("nominal_frequency", "nominal", 1 * HZ, 7 * HZ),
    )
    """True modal frequency less the one from which the frequency offset counts, rad/s."""
    thermometer_offset: float = parameter(
        key="thermometer_offset_K",
        limits=(-100, 100),
        tolerance=ToleranceDeclaration("thermometer_offset", "bench", 1.0, 0.2),
    )
    """Reading of the case thermometer less the case's temperature, K."""
    thermometer_lag: float = parameter(
        key="thermometer_lag_s",
        limits=(-3600, 3600),
        tolerance=ToleranceDeclaration(
            "thermometer_lag", "bench", 60.0, 20.0, imitators=("temperature_gradient",)
        ),
    )
    """Time constant of the thermometer's reading behind the case, s. A gradient in the chamber that
    grows with the temperature's rate has the same effect."""
    thermometer_gain: float = parameter(
        key="thermometer_gain",
        limits=(-0.5, 0.5),
        tolerance=ToleranceDeclaration(
            "thermometer_gain", "bench", 0.1, 0.002, imitators=("temperature_gradient",)
        ),
    )
    """Change of the reading over the change of the case's temperature, less one. A gradient in the
    chamber that grows with its distance from the room's temperature has the same effect."""
    latitude_error: float = parameter(
        key="latitude_error_deg",
        unit=DEG,
        limits=(-180, 180),
        tolerance=ToleranceDeclaration(
            "site_latitude", "bench", 0.1 * DEG, 0.01 * DEG, imitators=("table_axis_tilt",)
        ),
    )
    """True less stated latitude of the site, rad. A tilt of the table's axis to the north has the
    same effect on an upright axis."""
    encoder_eccentricity: float = parameter(
        key="encoder_eccentricity_arcsec",
        unit=ARCSEC,
        limits=(0, 3600),
        tolerance=ToleranceDeclaration(
            "encoder_eccentricity",
            "bench",
            10 * ARCSEC,
            1 * ARCSEC,
            angle="encoder_eccentricity_phase",
            periods=1,
        ),
    )
    """Amplitude of the encoder's error over one turn of the table, rad."""
    encoder_eccentricity_phase: float = parameter(
        key="encoder_eccentricity_phase_deg", unit=DEG, limits=(-360, 360)
    )
    """Phase of that error, rad: the true rate is the rate read times 1 + a cos(reading + phase)."""
    clock_latency: float = parameter(
        key="clock_latency_s",
        limits=(-1, 1),
        tolerance=ToleranceDeclaration("clock_latency", "record", 1e-4, 1e-5),
    )
    """Time by which the gyro's angle is read later than the encoder, s."""
    clock_rate: float = parameter(
        key="clock_rate_ppm",
        unit=PPM,
        limits=(-1e5, 1e5),
        tolerance=ToleranceDeclaration("clock_rate", "record", 10 * PPM, 1 * PPM),
    )
    """Growth of `clock_latency` with the time since power-on, s/s."""
    amplitude_latency: float = parameter(
        key="amplitude_latency_s",
        limits=(-1, 1),
        tolerance=ToleranceDeclaration("amplitude_latency", "record", 1e-4, 1e-5),
    )
    """Time by which the amplitude is read later than one control period before a row's end, s."""
    table_tilt_east: float = parameter(
        key="table_axis_tilt_east_deg",
        unit=DEG,
        limits=(-45, 45),
        tolerance=ToleranceDeclaration(
            "table_axis_tilt", "bench", 0.1 * DEG, 0.03 * DEG, imitators=("table_azimuth",)
        ),
    )
    """Tilt of the table's upright axis to the east, rad, by which a level input axis points below
    the east. An error of the table's azimuth has the same effect."""
    amplitude_scale: float = parameter(
        key="amplitude_scale",
        limits=(-0.5, 1),
        tolerance=ToleranceDeclaration("amplitude_scale", "record", 0.01, 1e-7),
    )
    """Recorded amplitude over that which the set point asks for, less one."""
    amplitude_force_scale: float = parameter(
        key="amplitude_force_scale",
        limits=(-0.5, 1),
        tolerance=ToleranceDeclaration("amplitude_force_scale", "record", 0.01, 1e-7),
    )
    """Recorded amplitude force over the true one, less one."""
    quadrature_force_scale: float = parameter(
        key="quadrature_force_scale",
        limits=(-0.5, 1),
        tolerance=ToleranceDeclaration("quadrature_force_scale", "record", 0.01, 1e-7),
    )
    """Recorded quadrature force over the true one, less one."""
