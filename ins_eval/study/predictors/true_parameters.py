"""The yardstick: the linear error model with the true maps in flight (Eq. 9).

Its spread is by noise, accelerometers and mounting alone, and by the start angle where that is
unknown. No predictor from a bench can do better.
"""

import numpy as np

from ins_eval.mission_model.gyro_map import undo_start
from ins_eval.mission_model.mission_weights import MissionWeights
from ins_eval.mission_model.position_errors import compute_expected_error
from ins_eval.study.predictors.parts.drawn_errors import draw_at_any_angle
from ins_eval.study.predictors.prediction import NormalPrediction, SampledPrediction
from pyhrg.common.arrays import Array


def predict(weights: MissionWeights, maps: Array, other: Array) -> NormalPrediction:
    """Errors of triads whose maps in flight are known.

    Args:
        maps: (r, COUNT, 3) true coefficients in flight.
        other: (r, k, 2, 2) covariance of the error by noise, accelerometers and mounting, m^2.
    """
    return NormalPrediction(compute_expected_error(weights, maps), other)


def fly_from_any_angle(
    weights: MissionWeights, maps: Array, other: Array, start_angle: Array, seed: int
) -> SampledPrediction:
    """Linear flights of triads from many start angles, with the same true maps.

    Args:
        weights, maps, other: as in `predict`.
        start_angle: (r, 3) angles at which the maps begin, rad; removed before the flights.
        seed: seed of the angles and of the noise.
    """
    known = undo_start(maps, start_angle)
    none = np.zeros((1, maps.shape[1]))
    return draw_at_any_angle(weights.maps, known, np.zeros_like(known), none, other, seed)
