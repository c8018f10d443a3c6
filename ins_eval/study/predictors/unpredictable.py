"""What no gyro map tells of a mission's error: noise and accelerometers."""

import numpy as np
from numpy.typing import NDArray

from ins_eval.mission_model.mission_weights import MissionWeights

Array = NDArray[np.float64]


def unpredictable(weights: MissionWeights, noise: Array, accelerometer_bias: float) -> Array:
    """Covariance (r, k, 2, 2) of the error, m^2.

    Args:
        weights: of the mission.
        noise: (r, KINDS, 3) strengths of each gyro's.
        accelerometer_bias: standard deviation of each accelerometer's, m/s^2.
    """
    kinds, axes, k = *weights.noise.shape[:2], len(weights.time)
    times = np.arange(k)
    pairs = weights.noise.reshape(kinds, axes, k, 2, k, 2)[:, :, times, :, times, :]
    gyros = np.einsum("knaij,rna->rkij", pairs, noise**2)
    carried = weights.accelerometers
    return np.asarray(gyros + accelerometer_bias**2 * carried @ np.swapaxes(carried, 1, 2))
