"""Predictor (4): the fitted map of this device, through the linear error model of this manoeuvre.

Bias map and scale-factor map as the bench fitted them say where the error is expected; the bench's
uncertainty, the drift of maps between bench and flight, noise and accelerometers how far about.
"""

import numpy as np
from numpy.typing import NDArray

from ins_eval.study.mission_weights import MissionWeights
from ins_eval.study.predictors.drawn_errors import at_angles, at_any_angle
from ins_eval.study.predictors.expected_error import expected_error
from ins_eval.study.predictors.flown_maps import flown_weights, not_warming
from ins_eval.study.predictors.knowledge import BenchKnowledge
from ins_eval.study.predictors.map_drift import MapDrift
from ins_eval.study.predictors.prediction import Drawn
from ins_eval.study.predictors.turned_maps import started, weights_from

Array = NDArray[np.float64]


def predict(
    knowledge: BenchKnowledge,
    weights: MissionWeights,
    drift: MapDrift,
    rest: Array,
    start_angle: Array,
    seed: int,
) -> Drawn:
    """Of triads whose gyros' power-on angles are known.

    Args:
        knowledge: of r triads.
        weights: of the mission.
        drift: of maps, learnt from other triads.
        rest: (r, k, 2, 2) covariance of what maps don't tell, m^2.
        start_angle: (r, 3) pattern angles at power-on, rad.
        seed: of everything random.
    """
    maps = started(knowledge.maps, start_angle)
    expected = expected_error(weights, not_warming(maps))
    sigma, standard = drift.missed(knowledge), drift.standard
    return at_angles(flown_weights(weights), expected, sigma, standard, rest, start_angle, seed)


def predict_any_angle(
    knowledge: BenchKnowledge,
    weights: MissionWeights,
    drift: MapDrift,
    rest: Array,
    seed: int,
) -> Drawn:
    """Of triads whose gyros' power-on angles are anywhere; arguments as `predict`."""
    maps = not_warming(knowledge.maps)
    sigma = drift.missed(knowledge)
    return at_any_angle(flown_weights(weights), maps, sigma, drift.standard, rest, seed)


def drift_covariance(
    knowledge: BenchKnowledge, weights: MissionWeights, drift: MapDrift, start_angle: Array
) -> Array:
    """(r, k, 2, 2) of the errors that drift alone makes, m^2; arguments as `predict`."""
    carried = np.moveaxis(weights_from(flown_weights(weights), start_angle), -1, 0)
    spread = np.moveaxis(drift.covariance(knowledge), -1, 0)[:, :, None]
    return np.asarray(np.sum(carried @ spread @ np.swapaxes(carried, -1, -2), axis=0))
