"""Static alignment by means: pitch and roll from gravity, heading by gyrocompassing."""

import numpy as np
from numpy.typing import ArrayLike

from ins_eval.alignment.bias_instability import mean_variance
from ins_eval.common import earth
from ins_eval.common.rotation import mat_from_euler
from ins_eval.common.sensor_errors import SensorErrors
from pyhrg.common.arrays import Array
from pyhrg.common.errors import HrgError
from pyhrg.records.imu.log import Increments


def level_and_gyrocompass(record: Increments, latitude: float) -> Array:
    """Return `mat_nb` (3, 3) of a vehicle at rest (Groves 2013, section 5.6.2).

    Pitch and roll follow from the mean specific force, yaw from the level components of the mean
    rate. The effect of sensor biases is `bias_sensitivity`.
    """
    duration = record.interval * len(record.rotation)
    force = record.velocity.sum(axis=0) / duration
    rate = record.rotation.sum(axis=0) / duration
    if abs(np.linalg.norm(rate) / earth.RATE - 1) > 0.5 or abs(np.cos(latitude)) < 0.01:
        raise HrgError(
            f"mean rate {np.linalg.norm(rate):.2e} rad/s "
            f"at latitude {np.rad2deg(latitude):.1f} deg; "
            f"expected about Earth's {earth.RATE:.2e} rad/s, away from the poles"
        )
    return attitude_at_rest(rate, force)


def attitude_at_rest(rate: Array, force: Array) -> Array:
    """Return `mat_nb` (..., 3, 3) of a vehicle at rest from mean rates, rad/s, and specific forces,
    m/s^2, (..., 3) in body axes (Groves 2013, section 5.6.2)."""
    roll = np.arctan2(-force[..., 1], -force[..., 2])
    pitch = np.arctan2(force[..., 0], np.hypot(force[..., 1], force[..., 2]))
    levelled = mat_from_euler(roll, pitch, np.zeros_like(roll))
    level = np.einsum("...ij,...j->...i", levelled, rate)
    return mat_from_euler(roll, pitch, np.arctan2(-level[..., 1], level[..., 0]))


def bias_sensitivity(latitude: ArrayLike, gravity: ArrayLike) -> Array:
    """Return the attitude error (..., 3, 6) per bias of gyros and accelerometers.

    docs/methods/alignment.md, Eq. 1 (Groves 2013, section 5.6.2). Attitude errors are about north,
    east, down, rad; biases are about and along the same axes, rad/s and m/s^2. A navigator that
    does not turn afterwards is affected neither by these biases nor by the attitude errors: they
    cancel.
    """
    sensitivity = np.zeros((*np.shape(latitude), 3, 6))
    sensitivity[..., 0, 4] = -1 / np.asarray(gravity)
    sensitivity[..., 1, 3] = 1 / np.asarray(gravity)
    sensitivity[..., 2, 1] = -1 / (earth.RATE * np.cos(latitude))
    sensitivity[..., 2, 4] = np.tan(latitude) / gravity
    return sensitivity


def mean_rate_variance(errors: SensorErrors, duration: float) -> float:
    """Return the variance of a mean rate, (rad/s)^2: that of the bias, and of bias instability,
    white noise and the quantization at both ends, averaged over the duration, s."""
    rate = errors.gyro_bias**2 + mean_variance(errors.gyro_bias_instability)
    rate += (
        errors.angle_random_walk**2 / duration + errors.angle_quantization_step**2 / 6 / duration**2
    )
    return rate
