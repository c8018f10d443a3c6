"""A gyro's parameters, as its maker would list them."""

import math
from collections.abc import Mapping
from dataclasses import dataclass, field, replace

import numpy as np

from pyhrg.units import ARCSEC, DEG, DEG_PER_SQRT_H


@dataclass(frozen=True)
class Device:
    """One gyro. SI; angles are physical pattern angles; ratios are electrical (modal axes).

    Symbols in brackets are those of `theory`.
    """

    decay_time: float = 450.0
    """Mean amplitude decay time [tau], s."""
    damping_anisotropy: float = 0.0
    """1/tau1 - 1/tau2 between the axes of maximum and minimum damping [D], 1/s."""
    damping_axis: float = 0.0
    """Pattern angle of maximum damping [th_tau], rad."""
    frequency_split: float = 0.0
    """Difference of the modes' circular frequencies [dw], rad/s."""
    stiffness_axis: float = 0.0
    """Pattern angle of the mode of lower frequency [th_w], rad."""
    bryan_factor: float = 0.277
    """Precession of the pattern over rotation of the case [k]."""
    pickoff_gain_mismatch: float = 0.0
    """x reads (1 + g/2), y reads (1 - g/2) [g]."""
    pickoff_nonorthogonality: float = 0.0
    """y reads y + d x [d]."""
    drive_gain_mismatch: float = 0.0
    """x drives (1 + gd/2), y drives (1 - gd/2) [gd]."""
    drive_nonorthogonality: float = 0.0
    """y drives fy + nd fx [nd]."""
    phase_error: float = 0.0
    """Phase that the demodulation adds to both channels [p], rad."""
    angle_random_walk: float = 0.0
    """White force noise, as the input-referred angle random walk [N], rad/sqrt(s)."""
    pickoff_noise: float = 0.0
    """White noise of the detected angle, one sample at 1 kHz, input-referred, rad."""
    power_on_angle: float = 0.0
    """Pattern angle at which the electronics start the vibration, rad."""
    power_on_scatter: float = 0.0
    """Standard deviation of that angle from one power-on to the next, rad."""

    name: str = "gyro"
    misalignment: float = 0.0
    """Tilt of the input axis from the table's axis, rad."""
    misalignment_direction: float = 0.0
    """Table angle at which the tilted axis leans north, rad."""
    model: Mapping[str, float] = field(default_factory=dict)
    """Further parameters of the FMU by their own names, SI."""

    def nominal(self) -> dict[str, float]:
        """What is believed of the gyro, by the keys of a campaign."""
        return {"coriolis_factor": self.bryan_factor, "decay_time_s": self.decay_time}

    def fmu_parameters(self) -> dict[str, float]:
        """Values of the FMU's parameters, by name; the start angle is set at power-on."""
        control_period = 1e-3
        displacement_noise = 2 * self.bryan_factor * self.pickoff_noise
        return {
            "resonator.material.decayTime": self.decay_time,
            "resonator.material.dampingAnisotropy": self.damping_anisotropy,
            "resonator.material.dampingAxis": self.damping_axis,
            "resonator.material.frequencySplit": self.frequency_split,
            "resonator.material.stiffnessAxis": self.stiffness_axis,
            "resonator.material.bryanFactor": self.bryan_factor,
            "controller.readout.bryanFactor": self.bryan_factor,
            "pickOff.gainMismatch": self.pickoff_gain_mismatch,
            "pickOff.nonOrthogonality": self.pickoff_nonorthogonality,
            "drive.gainMismatch": self.drive_gain_mismatch,
            "drive.nonOrthogonality": self.drive_nonorthogonality,
            "pickOff.phaseError": self.phase_error,
            "noise.angleRandomWalk": self.angle_random_walk**2,
            "noise.pickOff": displacement_noise**2 * control_period,
            **self.model,
        }

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


def _turned(gain: float, nonorthogonality: float, angle: float) -> tuple[float, float]:
    c, s = math.cos(angle), math.sin(angle)
    return c * gain - s * nonorthogonality, s * gain + c * nonorthogonality


TYPICAL = Device(
    decay_time=450.0,
    damping_anisotropy=7.5e-7,
    damping_axis=85 * DEG,
    frequency_split=2 * math.pi * 0.5e-3,
    stiffness_axis=17.5 * DEG,
    pickoff_gain_mismatch=4e-5,
    pickoff_nonorthogonality=3e-5,
    drive_gain_mismatch=-3e-5,
    drive_nonorthogonality=4e-5,
    phase_error=5e-5,
    angle_random_walk=1e-4 * DEG_PER_SQRT_H,
    pickoff_noise=0.02 * ARCSEC,
    power_on_angle=10 * DEG,
    power_on_scatter=0.5 * DEG,
)
"""A 20 mm gyro whose damping anisotropy is trimmed to 0.03 % of 1/tau: about 0.1 deg/h of bias
over the circumference, 0.001 deg/h at one pattern angle (the paper's Table 2, normalised). Its
imperfections stand in quadrature, so that its bias map is as large as the rms of its kind."""
