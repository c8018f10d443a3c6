"""The oracle: the same linear error model with the true maps in flight. What it can't tell, nobody
can: noise and accelerometers, and without the power-on angle where the patterns start."""

import numpy as np
from numpy.typing import NDArray

from ins_eval.study.mission_weights import MissionWeights
from ins_eval.study.predictors.drawn_errors import at_any_angle
from ins_eval.study.predictors.expected_error import expected_error
from ins_eval.study.predictors.prediction import Drawn, Normal
from ins_eval.study.predictors.turned_maps import unstarted

Array = NDArray[np.float64]


def predict(weights: MissionWeights, started: Array, warming: Array, rest: Array) -> Normal:
    """Of triads.

    Args:
        weights: of the mission.
        started, warming: (r, 2 TERMS, 3) true maps in flight, from the power-on angles.
        rest: (r, k, 2, 2) covariance of what maps don't tell, m^2.
    """
    return Normal(expected_error(weights, started, warming), rest)


def predict_any_angle(
    weights: MissionWeights,
    started: Array,
    warming: Array,
    rest: Array,
    start_angle: Array,
    seed: int,
) -> Drawn:
    """Of triads of which all is known but the power-on angles.

    Args:
        weights, started, warming, rest: as `predict`.
        start_angle: (r, 3) that `started` and `warming` begin at, rad: taken out again.
        seed: of the angles.
    """
    both = np.concatenate([started, warming], axis=1)
    maps = unstarted(both, start_angle)
    carried = np.concatenate([weights.gyros, weights.warming], axis=2)
    none = np.zeros((1, maps.shape[1]))
    return at_any_angle(carried, maps, np.zeros_like(maps), none, rest, seed)
