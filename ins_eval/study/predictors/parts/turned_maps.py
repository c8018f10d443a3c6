"""Maps, and weights of maps, seen from other pattern angles."""

import numpy as np
from numpy.typing import NDArray

from ins_eval.mission_model.gyro_map import HARMONICS, TERMS

Array = NDArray[np.float64]


def started(maps: Array, angles: Array) -> Array:
    """Maps (..., 2 TERMS, 3) over the pattern's turn from angles (..., 3), rad, as
    `GyroMap.started_at`; leading dimensions are broadcast."""
    return _mixed(maps, angles, sign=1.0)


def unstarted(maps: Array, angles: Array) -> Array:
    """The inverse of `started`."""
    return _mixed(maps, angles, sign=-1.0)


def weights_from(weights: Array, angles: Array) -> Array:
    """Weights of maps that start at 0, made weights of maps that start at angles (..., 3), rad.

    Args:
        weights: (k, 2, n TERMS, 3) of `MissionWeights`.
        angles: (..., 3).

    Returns:
        (..., k, 2, n TERMS, 3).
    """
    return _mixed(weights, angles[..., None, None, :], sign=-1.0)


def _mixed(values: Array, angles: Array, sign: float) -> Array:
    """Cosine and sine terms turned into each other by each harmonic's multiple of the angles."""
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
