"""Maps, and weights of maps, for patterns that start at other angles (mission_model.md, Eq. 2)."""

import numpy as np

from ins_eval.mission_model.gyro_map import HARMONICS, TERMS
from pyhrg.common.arrays import Array


def start_maps(maps: Array, angles: Array) -> Array:
    """(..., n TERMS, 3) maps over the pattern's turn from angles (..., 3), rad; leading dimensions
    are broadcast."""
    return _rotate_harmonics(maps, angles, sign=1.0)


def undo_start(maps: Array, angles: Array) -> Array:
    """The inverse of `start_maps`."""
    return _rotate_harmonics(maps, angles, sign=-1.0)


def turn_weights(weights: Array, angles: Array) -> Array:
    """(..., k, 2, n TERMS, 3) weights of maps over the pattern angle itself.

    Args:
        weights: (k, 2, n TERMS, 3) weights of maps over the turn from the start angle.
        angles: (..., 3) start angles, rad.
    """
    return _rotate_harmonics(weights, angles[..., None, None, :], sign=-1.0)


def _rotate_harmonics(values: Array, angles: Array, sign: float) -> Array:
    """Rotate cosine and sine of each harmonic h by h times the angles."""
    leading = np.broadcast_shapes(values.shape[:-2], angles.shape[:-1])
    mixed = np.array(np.broadcast_to(values, (*leading, *values.shape[-2:])))
    for first in range(0, values.shape[-2], TERMS):
        for place, h in enumerate(HARMONICS):
            at = first + 1 + 2 * place
            cos, sin = values[..., at, :], values[..., at + 1, :]
            c, s = np.cos(h * angles), sign * np.sin(h * angles)
            mixed[..., at, :] = cos * c + sin * s
            mixed[..., at + 1, :] = sin * c - cos * s
    return mixed
