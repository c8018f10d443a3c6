"""Root mean square error over power-on angles (Eq. 10): ranks gyros without the luck of one
angle."""

import numpy as np

from ins_eval.mission_model.gyro_map import turn_weights
from pyhrg.common.arrays import Array

_ANGLES = np.pi * np.arange(16) / 16
"""Sixteen angles average the squares of harmonics up to the eighth exactly."""


def compute_gyro_rms(weights: Array, maps: Array) -> Array:
    """(r, k, 3) rms horizontal error by each gyro's map alone, m.

    Each gyro is mounted along each body axis in turn, so that the figure ranks gyros and not
    mountings.

    Args:
        weights: (k, 2, c, 3) weights of a mission.
        maps: (r, c, 3) coefficients over the pattern angle itself.
    """
    turned = turn_weights(weights, np.repeat(_ANGLES[:, None], 3, axis=1))
    errors = np.einsum("nkica,rcg->nkiarg", turned, maps)
    return np.asarray(np.sqrt(np.moveaxis((errors**2).mean(axis=0).sum(axis=(1, 2)), 0, 1)))
