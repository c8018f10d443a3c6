"""Start angles of the level gyros' patterns that make a mission's position error least.

The linear model carries each gyro's map, less its value at the start angle, to the position error
along the mission (docs/methods/mission_model.md, Eqs. 1, 2 and 6): the pattern creeps as the
mission turns it. Errors of the two gyros add, so that their angles are chosen together.
"""

from collections.abc import Sequence

import numpy as np

from ins_eval.mission_model.gyro_map import TERMS, evaluate_terms, list_coefficients, turn_weights
from ins_eval.mission_model.mission_weights import MissionWeights
from pyhrg.common.arrays import Array
from pyhrg.common.units import DEG
from pyhrg.device.device import AngleMap

CANDIDATES = np.arange(0.0, 180.0, 0.5) * DEG
"""Start angles that are compared, rad. Chosen: the scatter of power-on angles."""
LEVEL = (0, 1)
"""Axes of the gyros whose patterns are parked."""


def choose_start_angles(weights: MissionWeights, maps: Sequence[AngleMap]) -> Array:
    """(2,) start angles of the patterns of the gyros forward and right, rad, at which the position
    error that their maps make is least, as its mean square over the mission.

    maps: bias maps of the two, rad/s, whose value at the start angle is taken out of the output.
    """
    forward, right = (
        _predict_errors(weights, axis, bias_map) for axis, bias_map in zip(LEVEL, maps, strict=True)
    )
    squares = [np.square(each).sum(axis=1) for each in (forward, right)]
    total = squares[0][:, None] + squares[1] + 2 * forward @ right.T
    return CANDIDATES[list(np.unravel_index(np.argmin(total), total.shape))]


def _predict_errors(weights: MissionWeights, axis: int, bias_map: AngleMap) -> Array:
    """(candidates, 2 k) error north and east at all kept times by one gyro, m."""
    coefficients = list_coefficients(bias_map)
    taken_out = evaluate_terms(CANDIDATES) @ coefficients
    at_zero = weights.maps[:, :, :TERMS]
    starts = np.broadcast_to(CANDIDATES[:, None], (len(CANDIDATES), at_zero.shape[-1]))
    bias = turn_weights(at_zero, starts)[..., axis]
    errors = bias @ coefficients - bias[..., 0] * taken_out[:, None, None]
    return np.asarray(errors.reshape(len(CANDIDATES), -1))
