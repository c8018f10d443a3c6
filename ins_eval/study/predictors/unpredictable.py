"""Error of a mission by noise and accelerometers, which no gyro map predicts (Eq. 8)."""

import numpy as np
from numpy.typing import NDArray

from ins_eval.mission_model.mission_weights import MissionWeights

Array = NDArray[np.float64]


def compute_unpredictable_covariance(
    weights: MissionWeights, noise: Array, accelerometer_bias: float
) -> Array:
    """(r, k, 2, 2) covariance of the error, m^2.

    Args:
        weights: weights of the mission.
        noise: (r, KINDS, 3) strengths of each gyro's noise.
        accelerometer_bias: standard deviation of each accelerometer's bias, m/s^2.
    """
    kinds, axes, k = *weights.noise.shape[:2], len(weights.time)
    times = np.arange(k)
    pairs = weights.noise.reshape(kinds, axes, k, 2, k, 2)[:, :, times, :, times, :]
    gyros = np.einsum("knaij,rna->rkij", pairs, noise**2)
    carried = weights.accelerometers
    return np.asarray(gyros + accelerometer_bias**2 * carried @ np.swapaxes(carried, 1, 2))
