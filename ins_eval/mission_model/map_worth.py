"""What knowing a gyro's maps is worth: the position error that their uncertainty makes."""

import numpy as np

from ins_eval.mission_model.mission_weights import MissionWeights
from ins_eval.mission_model.turned_maps import turn_weights
from pyhrg.common.arrays import Array

AXES = ("forward", "right", "down")
"""Body axes along which a gyro may point."""


def compute_map_worth(weights: MissionWeights, covariance: Array, angle: float) -> Array:
    """(3,) rms horizontal error at the mission's end, m, by one gyro along each body axis.

    covariance: (2 TERMS, 2 TERMS) of its bias map, rad/s, and scale-factor map, over the pattern
    angle, constant in the mission; angle: of the pattern when the mission begins, rad.
    """
    carried = turn_weights(weights.gyros[-1:], np.full(len(AXES), angle))[0]
    power = np.einsum("ica,cd,ida->a", carried, covariance, carried)
    return np.asarray(np.sqrt(np.maximum(power, 0.0)))
