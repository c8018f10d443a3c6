"""Predictor (4): the fitted map of this device, through the linear error model of this manoeuvre.

Bias map and scale-factor map as the bench fitted them, and what they gain as the gyros warm, say
where the error is expected; the bench's uncertainty, the drift of maps between bench and flight,
noise and accelerometers how far about.
"""

import numpy as np
from numpy.typing import NDArray

from ins_eval.mission_model.mission_weights import MissionWeights
from ins_eval.study.predictors.knowledge import BenchKnowledge
from ins_eval.study.predictors.parts.drawn_errors import at_angles, at_any_angle
from ins_eval.study.predictors.parts.expected_error import expected_error
from ins_eval.study.predictors.parts.map_drift import MapDrift
from ins_eval.study.predictors.parts.turned_maps import started, weights_from
from ins_eval.study.predictors.prediction import Drawn

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
    expected = expected_error(weights, started(knowledge.maps, start_angle))
    sigma, standard = drift.missed(knowledge), drift.standard
    return at_angles(weights.maps, expected, sigma, standard, rest, start_angle, seed)


def predict_any_angle(
    knowledge: BenchKnowledge,
    weights: MissionWeights,
    drift: MapDrift,
    rest: Array,
    seed: int,
) -> Drawn:
    """Of triads whose gyros' power-on angles are anywhere; arguments as `predict`."""
    sigma = drift.missed(knowledge)
    return at_any_angle(weights.maps, knowledge.maps, sigma, drift.standard, rest, seed)


def drift_covariance(
    knowledge: BenchKnowledge, weights: MissionWeights, drift: MapDrift, start_angle: Array
) -> Array:
    """(r, k, 2, 2) of the errors that drift alone makes, m^2; arguments as `predict`."""
    sigma = drift.sigma(knowledge)[:, None, None]
    carried = np.moveaxis(weights_from(weights.maps, start_angle) * sigma, -1, 0)
    together = carried @ drift.together @ np.swapaxes(carried, -1, -2)
    return np.asarray(np.sum(together, axis=0))
