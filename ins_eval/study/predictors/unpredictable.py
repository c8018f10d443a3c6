"""Error of a mission by noise, accelerometers and mounting, which no gyro map predicts (Eq. 8)."""

import numpy as np

from ins_eval.mission_model.mission_weights import MissionWeights
from pyhrg.common.arrays import Array


def compute_unpredictable_covariance(
    weights: MissionWeights, noise: Array, accelerometer_bias: float, mounting: float
) -> Array:
    """(r, k, 2, 2) covariance of the error, m^2.

    Args:
        noise: (r, 4, 3) noise coefficients of each gyro, SI.
        accelerometer_bias: standard deviation of each accelerometer's bias, m/s^2.
        mounting: standard deviation of the angle by which each input axis leans, in each of two
            directions, rad.
    """
    kinds, axes, k = *weights.noise.shape[:2], len(weights.time)
    times = np.arange(k)
    pairs = weights.noise.reshape(kinds, axes, k, 2, k, 2)[:, :, times, :, times, :]
    gyros = np.einsum("knaij,rna->rkij", pairs, noise**2)
    by_force, by_mounting = weights.accelerometers, weights.mounting.reshape(k, 2, 6)
    force = accelerometer_bias**2 * by_force @ np.swapaxes(by_force, 1, 2)
    leaning = mounting**2 * by_mounting @ np.swapaxes(by_mounting, 1, 2)
    return np.asarray(gyros + force + leaning)
