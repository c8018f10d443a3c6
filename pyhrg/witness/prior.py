"""The prior of the estimate: how far mechanisms may have changed since the calibration (Eq. 3)."""

import math
from dataclasses import dataclass

import numpy as np

from pyhrg.common.arrays import Array
from pyhrg.common.errors import describe_briefly
from pyhrg.common.units import YEAR
from pyhrg.device.device import Device
from pyhrg.witness.mechanisms import COUNT, find

DAMPING = slice(0, 2)
"""Places of the damping anisotropy's cosine and sine among the mechanisms."""
TURN_ON_NAMES = {
    "pickOff.gainMismatch": "pick-off gain mismatch",
    "pickOff.nonOrthogonality": "pick-off non-orthogonality",
    "drive.gainMismatch": "drive gain mismatch",
    "drive.nonOrthogonality": "drive non-orthogonality",
    "drive.frameRotation": "drive frame rotation",
    "pickOff.phaseError": "phase error",
    "controller.quadratureSetpoint": "residual quadrature",
}
"""Mechanisms by the FMU's parameters whose scatter between turn-ons a device may state, beside the
damping anisotropy's."""
CUBIC_DRIFT = 1e-5
"""Standard deviation of the change of the pick-offs' cubic term since a calibration. Chosen: a
tenth of that of the study's gyros."""


@dataclass(frozen=True)
class Prior:
    """Distribution of the mechanisms' changes: (COUNT,) mean, (COUNT, COUNT) covariance, SI."""

    mean: Array
    covariance: Array

    __repr__ = describe_briefly


def make_drift_prior(
    device: Device,
    age: float,
    ageing_share: float,
    decay_time_loss: float,
    temperature_rate_bias: float = 0.0,
    specific_force_bias: float = 0.0,
    cubic: float = CUBIC_DRIFT,
) -> Prior:
    """Make the prior of the changes of a device since its calibration: ageing and another turn-on.

    The turn-on to turn-on scatter that the device states (`Device.turn_on_scatter`) is added.

    Args:
        device: the gyro as it was calibrated.
        age: time since the calibration, s.
        ageing_share: standard deviation of the relative change in a year of damping anisotropy,
            pick-offs and drives. It grows with the square root of time.
        decay_time_loss: largest share of the decay time that is lost in a year; uniform from 0.
        temperature_rate_bias: standard deviation of the bias per rate of temperature, rad/K. Its
            mean is the device's own value, because a replay leaves it out.
        specific_force_bias: standard deviation, rad/s per m/s^2, of the change of two biases: that
            per specific force along the input axis, and that which pick-offs make per specific
            force across it.
        cubic: standard deviation of the change of the pick-offs' cubic term.
    """
    share, lost = ageing_share * math.sqrt(age / YEAR), decay_time_loss * age / YEAR
    pickoff = math.hypot(device.pickoff_gain_mismatch, device.pickoff_nonorthogonality)
    drive = math.hypot(device.drive_gain_mismatch, device.drive_nonorthogonality)
    deviation = np.zeros(COUNT)
    deviation[DAMPING] = share * device.damping_anisotropy
    for name, size in (("pick-off", pickoff), ("drive", drive)):
        for kind in ("gain mismatch", "non-orthogonality"):
            deviation[find(f"{name} {kind}")] = share * size
    mean = np.zeros(COUNT)
    decay = find("decay time, relative")
    mean[decay], deviation[decay] = -lost / 2, lost / math.sqrt(12)
    rate = find("bias per rate of temperature")
    mean[rate], deviation[rate] = device.bias_per_temperature_rate, temperature_rate_bias
    deviation[find("pick-off cubic")] = cubic
    gain_per_bias = 4 * device.bryan_factor * device.decay_time
    deviation[find("pick-off gain per specific force")] = gain_per_bias * specific_force_bias
    deviation[find("bias per specific force")] = specific_force_bias
    aged = _carry_warm_damping(device, np.diag(deviation**2))
    return Prior(mean, aged + compute_turn_on_covariance(device))


def compute_turn_on_covariance(device: Device) -> Array:
    """(COUNT, COUNT) covariance of the mechanisms from one turn-on to the next, SI. The damping
    anisotropy scatters along its own axis."""
    covariance = np.zeros((COUNT, COUNT))
    for name, mechanism in TURN_ON_NAMES.items():
        place = find(mechanism)
        covariance[place, place] = device.turn_on_scatter.get(name, 0.0) ** 2
    axis = 4 * device.damping_axis
    along = np.array([math.cos(axis), math.sin(axis)])
    scatter = device.turn_on_scatter.get("resonator.material.dampingAnisotropy", 0.0)
    covariance[DAMPING, DAMPING] = scatter**2 * np.outer(along, along)
    return _carry_warm_damping(device, covariance)


def _carry_warm_damping(device: Device, covariance: Array) -> Array:
    """The covariance if a damping anisotropy that changes keeps its share of change per kelvin."""
    carry = np.eye(COUNT)
    axis, share = 4 * device.damping_axis, device.damping_anisotropy_per_kelvin
    carry[find("damping anisotropy per kelvin"), DAMPING] = share * np.array(
        [math.cos(axis), math.sin(axis)]
    )
    return np.asarray(carry @ covariance @ carry.T)
