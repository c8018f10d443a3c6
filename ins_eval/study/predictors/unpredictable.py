"""What no gyro map tells of a mission's error: noise and accelerometers."""

import numpy as np
from numpy.typing import NDArray

from ins_eval.study.mission_weights import MissionWeights
from ins_eval.study.predictors.knowledge import NoiseLevels
from ins_eval.study.predictors.noise_spread import NoiseSpread

Array = NDArray[np.float64]


def unpredictable(
    weights: MissionWeights, spread: NoiseSpread, noise: NoiseLevels, accelerometer_bias: float
) -> Array:
    """Covariance (r, k, 2, 2) of the error, m^2.

    Args:
        weights: of the mission.
        spread: of the mission.
        noise: levels of r triads.
        accelerometer_bias: standard deviation of each accelerometer's, m/s^2.
    """
    carried = weights.accelerometers
    return spread.covariance(noise) + accelerometer_bias**2 * np.einsum(
        "kia,kja->kij", carried, carried
    )
