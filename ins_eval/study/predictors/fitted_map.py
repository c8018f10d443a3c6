"""Predictor (4): the fitted map of this device, through the linear error model of this manoeuvre.

Bias map and scale-factor map as the bench fitted them say where the error is expected; their
covariance, the drift of maps between bench and flight, noise and accelerometers say how far about.
"""

import numpy as np
from numpy.typing import NDArray

from ins_eval.study.gyro_map import TERMS
from ins_eval.study.mission_weights import MissionWeights
from ins_eval.study.predictors.expected_error import expected_error
from ins_eval.study.predictors.knowledge import BenchKnowledge
from ins_eval.study.predictors.map_drift import MapDrift
from ins_eval.study.predictors.mixed_angles import mixed
from ins_eval.study.predictors.prediction import Drawn, Normal
from ins_eval.study.predictors.turned_maps import started, weights_from

Array = NDArray[np.float64]


def predict(
    knowledge: BenchKnowledge,
    weights: MissionWeights,
    drift: MapDrift,
    rest: Array,
    start_angle: Array,
) -> Normal:
    """Of triads whose gyros' power-on angles are known.

    Args:
        knowledge: of r triads.
        weights: of the mission.
        drift: of maps, learnt from other triads.
        rest: (r, k, 2, 2) covariance of what maps don't tell, m^2.
        start_angle: (r, 3) pattern angles at power-on, rad.
    """
    maps = started(knowledge.maps, start_angle)
    expected = expected_error(weights, maps, np.zeros_like(maps))
    carried = weights_from(_both(weights), start_angle)
    spread = _covariance(knowledge, drift)
    scattered = np.zeros_like(rest)
    for axis in range(carried.shape[-1]):
        w = carried[..., axis].reshape(len(carried), -1, carried.shape[-2])
        w_spread = (w @ spread[..., axis]).reshape(carried.shape[:-1])
        scattered += w_spread @ np.swapaxes(carried[..., axis], -1, -2)
    return Normal(expected, rest + scattered)


def predict_any_angle(
    knowledge: BenchKnowledge,
    weights: MissionWeights,
    drift: MapDrift,
    rest: Array,
    seed: int,
) -> Drawn:
    """Of triads whose gyros' power-on angles are anywhere; arguments as `predict`."""
    maps = np.concatenate([knowledge.maps, np.zeros_like(knowledge.maps)], axis=1)
    return mixed(_both(weights), maps, _covariance(knowledge, drift), rest, seed)


def _both(weights: MissionWeights) -> Array:
    return np.concatenate([weights.gyros, weights.warming], axis=2)


def _covariance(knowledge: BenchKnowledge, drift: MapDrift) -> Array:
    """(r, 4 TERMS, 4 TERMS, 3) of maps at power-on and of their warming."""
    total = drift.covariance(knowledge)
    total[:, : 2 * TERMS, : 2 * TERMS] += knowledge.covariance
    return total
