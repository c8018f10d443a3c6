"""Flights of the triads of `cases`, by the linear error model."""

import numpy as np
from numpy.typing import NDArray

from ins_eval.mission_model.flown import flown
from ins_eval.mission_model.mission_weights import MissionWeights
from ins_eval.mission_model.triads import Triads

Array = NDArray[np.float64]


def errors(triads: Triads, weights: MissionWeights) -> Array:
    """(r, k, 2) m."""
    return flown(triads, weights, mission=0).error


def radial(triads: Triads, weights: MissionWeights) -> Array:
    """(r, k) m."""
    return np.asarray(np.linalg.norm(errors(triads, weights), axis=-1))
