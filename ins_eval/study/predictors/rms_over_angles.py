"""Root mean square error over power-on angles of single gyros: what ranks them, luck left out."""

import numpy as np
from numpy.typing import NDArray

from ins_eval.study.predictors.parts.turned_maps import weights_from

Array = NDArray[np.float64]

_ANGLES = np.pi * np.arange(16) / 16
"""Enough for squares of harmonics up to the eighth to be averaged exactly."""


def rms_over_angles(weights: Array, maps: Array) -> Array:
    """(r, k, 3) rms horizontal error that each gyro's map alone does, m.

    A gyro counts as mounted along each body axis in turn, so that gyros are ranked and not their
    places.

    Args:
        weights: (k, 2, c, 3) of a mission.
        maps: (r, c, 3), from pattern angle 0.
    """
    turned = weights_from(weights, np.repeat(_ANGLES[:, None], 3, axis=1))
    errors = np.einsum("nkica,rcg->nkiarg", turned, maps)
    return np.asarray(np.sqrt(np.moveaxis((errors**2).mean(axis=0).sum(axis=(1, 2)), 0, 1)))


def triad_rms_over_angles(weights: Array, maps: Array) -> Array:
    """(r, k) rms horizontal error of triads whose gyros' angles are independent, m; arguments as
    `rms_over_angles`. What has no harmonic adds as it stands, the rest as powers."""
    turned = weights_from(weights, np.repeat(_ANGLES[:, None], 3, axis=1))
    errors = np.einsum("nkica,rca->nrkia", turned, maps)
    steady = errors.mean(axis=0)
    power = (errors - steady).var(axis=0).sum(axis=-1) + steady.sum(axis=-1) ** 2
    return np.asarray(np.sqrt(power.sum(axis=-1)))
