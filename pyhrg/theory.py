"""Closed forms that tests and predictions hold the simulation to; nothing here is simulated.

Angles are physical pattern angles. `k` is the Bryan factor, `tau` the mean decay time. Sources:
D. D. Lynch, Vibratory gyro analysis by the method of averaging (1995), in the form checked in
Senkal and Shkel, Whole-Angle MEMS Gyroscopes (2020); each docstring says what is derived from it.
"""

import math

import numpy as np
from numpy.typing import ArrayLike, NDArray

from pyhrg.device import Device


def static_bias_phasor(device: Device) -> complex:
    """Fourth harmonic H of the output bias at rest, B(th) = mean + Re(H exp(-4i th)), rad/s.

    First order in every imperfection, loops closed: damping anisotropy gives
    -(D/4k) sin 4(th - th_tau); a gain mismatch g of pick-offs or drives +(g/4k tau) sin 4th (the
    force that sustains the amplitude is misaimed); a non-orthogonality d -(d/4k tau)(1 + cos 4th);
    a frequency split with phase error p -(dw p/4k) sin 4(th - th_w).
    """
    tau = device.decay_time
    gain = (device.pickoff_gain_mismatch + device.drive_gain_mismatch) / tau
    skew = (device.pickoff_nonorthogonality + device.drive_nonorthogonality) / tau
    damping = device.damping_anisotropy * np.exp(4j * device.damping_axis)
    split = device.frequency_split * device.phase_error * np.exp(4j * device.stiffness_axis)
    return complex((-1j * (damping + split - gain) - skew) / (4 * device.bryan_factor))


def static_bias(device: Device, pattern_angle: ArrayLike) -> NDArray[np.float64]:
    """Output bias at rest, rad/s, at each pattern angle (rad); see `static_bias_phasor`."""
    harmonic = static_bias_phasor(device) * np.exp(-4j * np.asarray(pattern_angle))
    return np.asarray(mean_bias(device) + harmonic.real)


def mean_bias(device: Device) -> float:
    """Output bias at rest averaged over the circumference, rad/s: -(d + nd)/(4 k tau)."""
    skew = device.pickoff_nonorthogonality + device.drive_nonorthogonality
    return -skew / (4 * device.bryan_factor * device.decay_time)


def circumferential_bias_stability(device: Device) -> float:
    """Standard deviation of the bias over the circumference, rad/s: amplitude over sqrt 2."""
    return abs(static_bias_phasor(device)) / math.sqrt(2)


def hold_scale_factor_error(control_period: float, delay: float, decay_time: float) -> float:
    """Scale-factor error of a gyro whose forces lag the pattern: -(Ts/2 + delay)/tau.

    Forces are computed for the angle at the sample and held: on average they point at where the
    pattern was Ts/2 + delay ago, and the amplitude force 1/tau pulls it back.
    """
    return -(control_period / 2 + delay) / decay_time


def angle_random_walk_bias_stability(angle_random_walk: float, average: float) -> float:
    """Standard deviation of rate means over `average` seconds, rad/s, from N (rad/sqrt(s))."""
    return angle_random_walk / math.sqrt(average)
