"""All coefficients of a gyro in flight as one list: at power-on, and what warming adds."""

import numpy as np
from numpy.typing import NDArray

from ins_eval.study.gyro_map import TERMS
from ins_eval.study.mission_weights import MissionWeights
from ins_eval.study.triads import Triads

Array = NDArray[np.float64]

COUNT = 6 * TERMS
"""Of `GyroMap` at power-on, gained with warmth, and gained with its square."""


def flown_maps(triads: Triads) -> Array:
    """(r, COUNT, 3), from the power-on angles."""
    return np.concatenate([triads.started, triads.warming, triads.curving], axis=1)


def flown_weights(weights: MissionWeights) -> Array:
    """(k, 2, COUNT, 3) error north and east, m, of maps that start at pattern angle 0."""
    return np.concatenate([weights.gyros, weights.warming, weights.curving], axis=2)


def not_warming(maps: Array) -> Array:
    """(r, COUNT, 3) of maps (r, 2 TERMS, 3) that stay as they are."""
    return np.concatenate([maps, np.zeros_like(maps), np.zeros_like(maps)], axis=1)
