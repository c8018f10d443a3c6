"""A gyro's parameters, as its maker would list them."""

import math
from collections.abc import Mapping
from dataclasses import dataclass, field, replace

import numpy as np

from pyhrg.common.site import Site
from pyhrg.common.units import HZ


@dataclass(frozen=True)
class AngleMap:
    """Fourier coefficients over the pattern angle th: mean + cos2 cos 2th + sin2 sin 2th + ..."""

    mean: float = 0.0
    cos2: float = 0.0
    sin2: float = 0.0
    cos4: float = 0.0
    sin4: float = 0.0
    cos8: float = 0.0
    sin8: float = 0.0


@dataclass(frozen=True)
class Device:
    """One gyro, an ideal one by default. SI; angles are physical pattern angles; ratios are
    electrical (modal axes). Temperatures count from `reference_temperature`.

    Symbols in brackets are those of `theory`. `device_file` reads and writes it.
    """

    name: str = ""
    """What it is called in reports."""

    bryan_factor: float = 0.277
    """Precession of the pattern over rotation of the case, as the electronics believe it [k]."""
    bryan_factor_error: float = 0.0
    """True over believed Bryan factor, less one."""
    decay_time: float = 450.0
    """Mean amplitude decay time [tau], s."""
    decay_time_per_kelvin: float = 0.0
    """Relative change of the decay time with temperature, 1/K."""
    damping_anisotropy: float = 0.0
    """1/tau1 - 1/tau2 between the axes of maximum and minimum damping [D], 1/s."""
    damping_axis: float = 0.0
    """Pattern angle of maximum damping [th_tau], rad."""
    damping_anisotropy_per_kelvin: float = 0.0
    """Relative change of the damping anisotropy with temperature, 1/K."""
    frequency: float = 7000 * HZ
    """Modal frequency [w], rad/s."""
    frequency_per_kelvin: float = 0.0
    """Relative change of the modal frequency with temperature, 1/K."""
    frequency_split: float = 0.0
    """Difference of the modes' circular frequencies [dw], rad/s."""
    stiffness_axis: float = 0.0
    """Pattern angle of the mode of lower frequency [th_w], rad."""
    duffing: float = 0.0
    """Frequency shift at unit amplitude by cubic stiffness, rad/s."""
    thermal_lag: float = 600.0
    """Time constant of the resonator's temperature behind the case's, s."""
    reference_temperature: float = 298.15
    """Temperature that the parameters hold at, K."""

    pickoff_gain_mismatch: float = 0.0
    """x reads (1 + g/2), y reads (1 - g/2) [g]."""
    pickoff_gain_per_kelvin: float = 0.0
    """Change of g with temperature, 1/K."""
    pickoff_gain_per_acceleration: float = 0.0
    """Change of g with specific force along x, s2/m."""
    pickoff_nonorthogonality: float = 0.0
    """y reads y + d x [d]."""
    pickoff_cubic: float = 0.0
    """x reads x (1 + 3/4 b |x|^2), y alike [b]."""
    phase_error: float = 0.0
    """Phase that the demodulation adds to both channels [p], rad."""
    phase_per_kelvin: float = 0.0
    """Change of p with temperature, rad/K."""
    differential_phase: float = 0.0
    """Phase of x over that of y: x turned by half of it, y by minus half, rad."""
    demodulation_offset: float = 0.0
    """Added to the in-phase x channel [x0], amplitude units."""
    feedthrough: float = 0.0
    """Pick-offs read this time the force as well [c], s."""

    drive_gain_mismatch: float = 0.0
    """x drives (1 + gd/2), y drives (1 - gd/2) [gd]."""
    drive_nonorthogonality: float = 0.0
    """y drives fy + nd fx [nd]."""
    drive_frame_rotation: float = 0.0
    """Force frame turned against the pick-offs' on the modal axes [e], rad."""
    bias_per_temperature_rate: float = 0.0
    """Output bias over the rate of the case's temperature, rad/s per K/s."""
    bias_per_acceleration: float = 0.0
    """Output bias over specific force along the input axis, by rotation of the force frame; rad/s
    per m/s2."""

    amplitude: float = 1.0
    """Antinode amplitude that is held."""
    residual_quadrature: float = 0.0
    """Set point of the quadrature loop [q0], amplitude units."""
    amplitude_loop: float = 6.0
    """Natural frequency of the amplitude loop, rad/s."""
    quadrature_loop: float = 6.0
    """Natural frequency of the quadrature loop, rad/s."""
    phase_loop: float = 200.0
    """Natural frequency of the phase loop, rad/s."""
    control_period: float = 1e-3
    """Period of the control electronics [Ts], s; the FMU knows this one alone."""
    loop_delay: float = 0.0
    """Delay from detected angle to force, beyond the hold [td], s."""
    virtual_rotation_error: float = 0.0
    """True over commanded virtual rotation, less one."""
    bias_map: AngleMap = field(default_factory=AngleMap)
    """Calibrated output bias that the electronics take out, rad/s."""
    scale_factor_map: AngleMap = field(default_factory=AngleMap)
    """Calibrated error of the detected pattern angle that the electronics take out, rad; its mean
    is none."""

    angle_random_walk: float = 0.0
    """White force noise, as the input-referred angle random walk [N], rad/sqrt(s)."""
    rate_random_walk: float = 0.0
    """Input-referred rate random walk coefficient [K], rad/s/sqrt(s)."""
    bias_instability: float = 0.0
    """Input-referred flicker coefficient [B] (IEEE Std 952: the Allan deviation's floor is
    0.664 B), rad/s."""
    pickoff_noise: float = 0.0
    """White noise of the detected angle, one sample at 1 kHz, input-referred, rad."""
    angle_quantum: float = 0.0
    """Least significant bit of the output angle, rad; 0: none."""

    misalignment: float = 0.0
    """Tilt of the input axis from the table's axis, rad; the mounting's, not the FMU's."""
    misalignment_direction: float = 0.0
    """Azimuth about the table's axis to which the input axis tilts at table angle 0, rad."""

    power_on_angle: float = 0.0
    """Pattern angle at which the electronics start the vibration, rad."""
    power_on_scatter: float = 0.0
    """Standard deviation of that angle from one power-on to the next, rad."""

    turn_on_scatter: Mapping[str, float] = field(default_factory=dict, hash=False)
    """Standard deviations of the FMU's parameters, by its names, from one power-on to the next; SI,
    normal, independent."""

    model: Mapping[str, float] = field(default_factory=dict, hash=False)
    """Whatever else the FMU has: values by its names, SI."""
    site: Site = field(default_factory=Site)
    """Where it is tested."""
    specification: Mapping[str, float] = field(default_factory=dict, hash=False)
    """Limits of a bench's findings, by name with unit, in that unit."""

    def fmu_parameters(self) -> dict[str, float]:
        """Values of the FMU's parameters that differ from its own, by name; the start angle is set
        at power-on. Those of `model` come last."""
        ideal = fmu_values(Device())
        values = {name: v for name, v in fmu_values(self).items() if v != ideal[name]}
        return {**values, **self.model}

    def turned_on(self, generator: np.random.Generator) -> dict[str, float]:
        """Parameters as `fmu_parameters`, those of `turn_on_scatter` as this power-on has them."""
        stated = {**fmu_values(self), **self.model}
        drawn = {
            name: stated[name] + generator.normal(0.0, deviation)
            for name, deviation in self.turn_on_scatter.items()
        }
        return {**self.fmu_parameters(), **drawn}

    def without_anisotropy(self) -> "Device":
        """The same gyro with every anisotropy of resonator and electrodes zero; noise stays."""
        return replace(
            self,
            damping_anisotropy=0.0,
            frequency_split=0.0,
            pickoff_gain_mismatch=0.0,
            pickoff_nonorthogonality=0.0,
            drive_gain_mismatch=0.0,
            drive_nonorthogonality=0.0,
        )

    def without_noise(self) -> "Device":
        """The same gyro without noise of any kind; what varies from power-on to power-on stays."""
        return replace(
            self,
            angle_random_walk=0.0,
            rate_random_walk=0.0,
            bias_instability=0.0,
            pickoff_noise=0.0,
            model={name: v for name, v in self.model.items() if not name.startswith("noise.")},
        )

    def another(self, generator: np.random.Generator) -> "Device":
        """A gyro of the same kind: same magnitudes, own axes and own power-on angle.

        A gain mismatch turned by 22.5 deg of pattern is a non-orthogonality, so that each pair
        (gain mismatch, non-orthogonality) is turned as a vector.
        """
        turn = generator.uniform(0.0, 2 * math.pi, size=4)
        pickoff = _turned(self.pickoff_gain_mismatch, self.pickoff_nonorthogonality, turn[0])
        drive = _turned(self.drive_gain_mismatch, self.drive_nonorthogonality, turn[1])
        return replace(
            self,
            damping_axis=turn[2] / 4,
            stiffness_axis=turn[3] / 4,
            pickoff_gain_mismatch=pickoff[0],
            pickoff_nonorthogonality=pickoff[1],
            drive_gain_mismatch=drive[0],
            drive_nonorthogonality=drive[1],
            power_on_angle=generator.uniform(0.0, math.pi / 2),
        )


FMU_FIELDS = {
    "startAmplitude": "amplitude",
    "amplitudeSetpoint": "amplitude",
    "caseTemperature": "reference_temperature",
    "resonator.environment.referenceTemperature": "reference_temperature",
    "resonator.environment.thermalLag": "thermal_lag",
    "resonator.material.decayTime": "decay_time",
    "resonator.material.decayTimePerKelvin": "decay_time_per_kelvin",
    "resonator.material.dampingAnisotropy": "damping_anisotropy",
    "resonator.material.dampingAxis": "damping_axis",
    "resonator.material.dampingAnisotropyPerKelvin": "damping_anisotropy_per_kelvin",
    "resonator.material.frequency": "frequency",
    "resonator.material.frequencyPerKelvin": "frequency_per_kelvin",
    "resonator.material.frequencySplit": "frequency_split",
    "resonator.material.stiffnessAxis": "stiffness_axis",
    "resonator.material.duffing": "duffing",
    "pickOff.gainMismatch": "pickoff_gain_mismatch",
    "pickOff.gainPerKelvin": "pickoff_gain_per_kelvin",
    "pickOff.gainPerAcceleration[1]": "pickoff_gain_per_acceleration",
    "pickOff.nonOrthogonality": "pickoff_nonorthogonality",
    "pickOff.cubic": "pickoff_cubic",
    "pickOff.phaseError": "phase_error",
    "pickOff.phasePerKelvin": "phase_per_kelvin",
    "pickOff.differentialPhase": "differential_phase",
    "pickOff.offset": "demodulation_offset",
    "pickOff.feedthrough": "feedthrough",
    "drive.gainMismatch": "drive_gain_mismatch",
    "drive.nonOrthogonality": "drive_nonorthogonality",
    "drive.frameRotation": "drive_frame_rotation",
    "noise.biasInstability": "bias_instability",
    "controller.quadratureSetpoint": "residual_quadrature",
    "controller.amplitudeLoop.naturalFrequency": "amplitude_loop",
    "controller.quadratureLoop.naturalFrequency": "quadrature_loop",
    "controller.phaseLoop.naturalFrequency": "phase_loop",
    "controller.synthesis.loopDelay": "loop_delay",
    "controller.readout.bryanFactor": "bryan_factor",
    "controller.readout.virtualRotationError": "virtual_rotation_error",
    "controller.readout.quantum": "angle_quantum",
}
"""Parameters and inputs of the FMU that are fields of a device as they stand."""


LOOPS = frozenset(name for name in FMU_FIELDS if name.endswith("Loop.naturalFrequency"))
"""Those that a gyro with quasi-steady loops (`HRGSlow`) does not have."""


def fmu_values(device: Device) -> dict[str, float]:
    """All parameters of the FMU that a device states, by name; the rest is `Device.model`."""
    return {
        **{name: getattr(device, stated) for name, stated in FMU_FIELDS.items()},
        **_derived_values(device),
        **{f"controller.biasMap.{name}": v for name, v in vars(device.bias_map).items()},
        **{
            f"controller.scaleFactorMap.{name}": v
            for name, v in vars(device.scale_factor_map).items()
            if name != "mean"
        },
    }


def _derived_values(device: Device) -> dict[str, float]:
    """Parameters that the FMU defines otherwise.

    A force frame turned by e gives the bias -e/(2 k tau). Noises are densities; one of n in each
    displacement turns the pattern by n/2, the output by n/2k.
    """
    k, tau = device.bryan_factor, device.decay_time
    turn = -2 * k * tau
    displacement_noise = 2 * k * device.pickoff_noise
    return {
        "resonator.material.bryanFactor": k * (1 + device.bryan_factor_error),
        "drive.rotationPerTemperatureRate": turn * device.bias_per_temperature_rate,
        "drive.rotationPerAcceleration[3]": turn * device.bias_per_acceleration,
        "noise.angleRandomWalk": device.angle_random_walk**2,
        "noise.rateRandomWalk": device.rate_random_walk**2,
        "noise.pickOff": displacement_noise**2 * device.control_period,
    }


FMU_NAMES = frozenset({*fmu_values(Device()), "seed", "startAngle"})
"""Of the FMU, those that a device states or a power-on sets: not for `Device.model`."""


def _turned(gain: float, nonorthogonality: float, angle: float) -> tuple[float, float]:
    c, s = math.cos(angle), math.sin(angle)
    return c * gain - s * nonorthogonality, s * gain + c * nonorthogonality
