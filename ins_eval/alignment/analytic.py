"""Static alignment by means: pitch and roll from gravity, heading by gyrocompassing."""

import numpy as np

from ins_eval.alignment.bias_instability import mean_variance
from ins_eval.alignment.gyrocompass import bias_sensitivity
from ins_eval.alignment.result import Alignment, AlignmentError
from ins_eval.common import earth
from ins_eval.common.arrays import Array
from ins_eval.common.rotation import mat_from_euler
from ins_eval.common.sensor_errors import SensorErrors
from pyhrg.records.imu.increments import Increments


def level_and_gyrocompass(record: Increments, latitude: float) -> Array:
    """Return `mat_nb` (3, 3) of a vehicle at rest (Groves 2013, section 5.6.2).

    Pitch and roll follow from the mean specific force, yaw from the level components of the mean
    rate. The effect of sensor biases is `gyrocompass.bias_sensitivity`.

    Raises:
        AlignmentError: the mean rate is not Earth's, so the vehicle was moving.
    """
    duration = record.interval * len(record.rotation)
    force = record.velocity.sum(axis=0) / duration
    rate = record.rotation.sum(axis=0) / duration
    if abs(np.linalg.norm(rate) / earth.RATE - 1) > 0.5 or abs(np.cos(latitude)) < 0.01:
        raise AlignmentError(
            f"mean rate {np.linalg.norm(rate):.2e} rad/s "
            f"at latitude {np.rad2deg(latitude):.1f} deg; "
            f"expected about Earth's {earth.RATE:.2e} rad/s, away from the poles"
        )
    return attitude_at_rest(rate, force)


def attitude_at_rest(rate: Array, force: Array) -> Array:
    """Return `mat_nb` (..., 3, 3) of a vehicle at rest (Groves 2013, section 5.6.2).

    Args:
        rate, force: (..., 3) mean rates, rad/s, and mean specific forces, m/s^2, in body axes.
    """
    roll = np.arctan2(-force[..., 1], -force[..., 2])
    pitch = np.arctan2(force[..., 0], np.hypot(force[..., 1], force[..., 2]))
    levelled = mat_from_euler(roll, pitch, np.zeros_like(roll))
    level = np.einsum("...ij,...j->...i", levelled, rate)
    return mat_from_euler(roll, pitch, np.arctan2(-level[..., 1], level[..., 0]))


def align_by_means(record: Increments, position: Array, errors: SensorErrors) -> Alignment:
    """Find the attitude of a vehicle at rest; the covariance is that of the sensors' errors alone.

    Args:
        record: of the vehicle at rest.
        position: (3,) latitude, longitude, rad, and height, m.
        errors: of the sensors.

    Raises:
        AlignmentError: the mean rate is not Earth's, so the vehicle was moving.
    """
    latitude, height = float(position[0]), float(position[2])
    mat_nb = level_and_gyrocompass(record, latitude)
    covariance = analytic_covariance(errors, latitude, height, record.duration)
    return Alignment("analytic", float(record.bounds[-1]), mat_nb, covariance)


def analytic_covariance(
    errors: SensorErrors, latitude: float, height: float, duration: float
) -> Array:
    """Return the covariance (3, 3), about north, east, down, rad^2, of `level_and_gyrocompass`."""
    rate, force = mean_error_variances(errors, duration)
    turns = bias_sensitivity(latitude, earth.gravity(latitude, height))
    return np.asarray(turns @ np.diag([rate] * 3 + [force] * 3) @ turns.T)


def mean_error_variances(errors: SensorErrors, duration: float) -> tuple[float, float]:
    """Return the variances of mean rate, (rad/s)^2, and mean specific force, (m/s^2)^2.

    They are those of the bias, and of bias instability, white noise and the quantization at both
    ends, averaged over the duration, s.
    """
    rate = errors.gyro_bias**2 + mean_variance(errors.gyro_bias_instability)
    rate += (
        errors.angle_random_walk**2 / duration + errors.angle_quantization_step**2 / 6 / duration**2
    )
    force = errors.accelerometer_bias**2 + mean_variance(errors.accelerometer_bias_instability)
    force += (
        errors.velocity_random_walk**2 / duration
        + errors.velocity_quantization_step**2 / 6 / duration**2
    )
    return rate, force
