"""Position errors of many triads in one mission, by the linear error model."""

import numpy as np
from numpy.typing import NDArray

from ins_eval.study.mission_weights import MissionWeights

Array = NDArray[np.float64]


def map_errors(weights: MissionWeights, started: Array, warming: Array) -> Array:
    """What gyro maps do: (r, k, 2) error north and east, m.

    Args:
        weights: of the mission.
        started: (r, 2 TERMS, 3) coefficients of each triad's maps from their power-on angles.
        warming: (r, 2 TERMS, 3) what they gain when the gyros are warm.
    """
    steady = np.einsum("kica,rca->rki", weights.gyros, started)
    return np.asarray(steady + np.einsum("kica,rca->rki", weights.warming, warming))


def accelerometer_errors(weights: MissionWeights, biases: Array) -> Array:
    """What accelerometer biases (r, 3), m/s^2, do: (r, k, 2) m."""
    return np.asarray(np.einsum("kia,ra->rki", weights.accelerometers, biases))


def noise_errors(weights: MissionWeights, rates: Array) -> Array:
    """What rate errors over time do: (r, k, 2) m.

    Args:
        weights: of the mission.
        rates: (n, r, 3) mean rate error of each gyro over each step, rad/s.
    """
    pushed = np.matmul(rates, np.swapaxes(weights.per_rate, 1, 2))
    x, kept = np.zeros(pushed.shape[1:]), []
    told = set(weights.kept.tolist())
    for k, transition in enumerate(weights.transition):
        x = x @ transition.T + pushed[k]
        if k + 1 in told:
            kept.append(x[:, :2].copy())
    return np.stack(kept, axis=1)
