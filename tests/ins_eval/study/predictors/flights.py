"""Flights of the triads of `cases`, by the linear error model."""

import numpy as np

from ins_eval.mission_model.mission_weights import MissionWeights
from ins_eval.mission_model.position_errors import TriadBlock, compute_linear_position_errors
from pyhrg.common.arrays import Array


def errors(triads: TriadBlock, weights: MissionWeights) -> Array:
    """(r, k, 2) m."""
    return compute_linear_position_errors(triads, weights, mission=0).error


def radial(triads: TriadBlock, weights: MissionWeights) -> Array:
    """(r, k) m."""
    return np.asarray(np.linalg.norm(errors(triads, weights), axis=-1))
