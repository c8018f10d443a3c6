"""The distribution of errors when patterns start anywhere: a mixture over power-on angles.

That spreads errors so much that what aligning does beyond first order, 1 % of them, is left out.
"""

import numpy as np
from numpy.typing import NDArray
from scipy.stats import qmc

from ins_eval.study.predictors.prediction import Drawn
from ins_eval.study.predictors.turned_maps import weights_from

Array = NDArray[np.float64]

DRAWS = 2048
"""A power of two. Their 5 % and 95 % quantiles are right within 0.5 % of probability, rms."""


def mixed(weights: Array, maps: Array, covariance: Array, rest: Array, seed: int) -> Drawn:
    """Angles by Sobol's sequence, scrambled; all else drawn. All triads share the draws' numbers.

    Args:
        weights: (k, 2, c, 3) of maps that start at 0.
        maps: (r, c, 3) expected.
        covariance: (r, c, c, 3) of the maps.
        rest: (r, k, 2, 2) covariance of what maps don't tell, m^2.
        seed: of everything random.
    """
    random = np.random.default_rng(seed)
    angles = np.pi * qmc.Sobol(maps.shape[2], rng=random).random(DRAWS)
    carried = _by_axis(weights_from(weights, angles))
    numbers = random.standard_normal((*carried.shape[:2], carried.shape[3]))
    others = random.standard_normal((DRAWS, 2))
    roots = np.swapaxes(_root(np.moveaxis(covariance, 3, 1)), -1, -2)
    rest_roots = np.swapaxes(_root(rest), -1, -2)
    draws = np.empty((len(maps), DRAWS, len(weights), 2))
    for r, expected in enumerate(np.swapaxes(maps, 1, 2)):
        drawn = expected[:, None] + numbers @ roots[r]
        errors = np.einsum("amic,amc->mi", carried, drawn)
        draws[r] = errors.reshape(draws.shape[1:]) + np.swapaxes(others @ rest_roots[r], 0, 1)
    return Drawn(draws)


def _by_axis(weights: Array) -> Array:
    """(3, m, 2 k, c) of weights (m, k, 2, c, 3)."""
    m, k, two, c, axes = weights.shape
    return np.ascontiguousarray(np.moveaxis(weights, -1, 0)).reshape(axes, m, k * two, c)


def _root(covariance: Array) -> Array:
    """S with S S' the covariance (..., c, c), which may be singular."""
    scale = np.sqrt(np.diagonal(covariance, axis1=-2, axis2=-1))
    unit = np.where(scale > 0, scale, 1.0)
    values, axes = np.linalg.eigh(covariance / (unit[..., None] * unit[..., None, :]))
    root = axes * np.sqrt(np.maximum(values, 0.0))[..., None, :]
    return np.asarray(unit[..., None] * root)
