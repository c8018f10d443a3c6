"""The oracle: the same linear error model with the true maps in flight. What it can't tell, nobody
can: noise and accelerometers, and without the power-on angle where the patterns start."""

import numpy as np
from numpy.typing import NDArray

from ins_eval.mission_model.mission_weights import MissionWeights
from ins_eval.study.predictors.parts.drawn_errors import at_any_angle
from ins_eval.study.predictors.parts.expected_error import expected_error
from ins_eval.study.predictors.parts.turned_maps import unstarted
from ins_eval.study.predictors.prediction import Drawn, Normal

Array = NDArray[np.float64]


def predict(weights: MissionWeights, maps: Array, rest: Array) -> Normal:
    """Of triads.

    Args:
        weights: of the mission.
        maps: (r, COUNT, 3) true ones in flight.
        rest: (r, k, 2, 2) covariance of what maps don't tell, m^2.
    """
    return Normal(expected_error(weights, maps), rest)


def predict_any_angle(
    weights: MissionWeights, maps: Array, rest: Array, start_angle: Array, seed: int
) -> Drawn:
    """Of triads of which all is known but the power-on angles.

    Args:
        weights, maps, rest: as `predict`.
        start_angle: (r, 3) that the maps begin at, rad: taken out again.
        seed: of the angles.
    """
    known = unstarted(maps, start_angle)
    none = np.zeros((1, maps.shape[1]))
    return at_any_angle(weights.maps, known, np.zeros_like(known), none, rest, seed)
