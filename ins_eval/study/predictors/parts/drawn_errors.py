"""Errors of triads whose maps, power-on angles and noise are drawn: the same draws for all."""

import numpy as np
from numpy.typing import NDArray
from scipy.stats import qmc

from ins_eval.study.predictors.parts.turned_maps import weights_from
from ins_eval.study.predictors.prediction import Drawn

Array = NDArray[np.float64]

DRAWS = 2048
"""A power of two. Their 5 % and 95 % quantiles are right within 0.5 % of probability, rms."""


def at_angles(
    weights: Array,
    expected: Array,
    sigma: Array,
    standard: Array,
    rest: Array,
    start_angle: Array,
    seed: int,
) -> Drawn:
    """Errors of triads whose power-on angles are known.

    Args:
        weights: (k, 2, c, 3) of maps that start at 0.
        expected: (r, k, 2) error of the maps as they are expected, m.
        sigma: (r, c, 3) standard deviations of the maps' coefficients.
        standard: (n, c) deviations in units of them that occur together.
        rest: (r, k, 2, 2) covariance of what maps don't tell, m^2.
        start_angle: (r, 3) rad.
        seed: of everything random.
    """
    random = np.random.default_rng(seed)
    deviations = _drawn(standard, random).reshape(DRAWS, -1)
    others = random.standard_normal((DRAWS, 2))
    shape = (DRAWS, *weights.shape[:2])
    draws = _noise(rest, others)
    for r, mean in enumerate(expected):
        carried = weights_from(weights, start_angle[r]) * sigma[r]
        errors = deviations @ carried.reshape(shape[1] * shape[2], -1).T
        draws[r] += mean + errors.reshape(shape)
    return Drawn(draws)


def at_any_angle(
    weights: Array, maps: Array, sigma: Array, standard: Array, rest: Array, seed: int
) -> Drawn:
    """Errors of triads whose power-on angles are anywhere: by Sobol's sequence, scrambled.

    That spreads errors so much that what aligning does beyond first order, 1 % of them, is left
    out. Arguments as `at_angles`, and maps: (r, c, 3) as they are expected, from pattern angle 0.
    """
    random = np.random.default_rng(seed)
    deviations = _drawn(standard, random)
    others = random.standard_normal((DRAWS, 2))
    angles = np.pi * qmc.Sobol(maps.shape[2], rng=random).random(DRAWS)
    carried = weights_from(weights, angles)
    deviating = carried * deviations[:, None, None]
    errors = _product(maps, carried) + _product(sigma, deviating)
    return Drawn(errors + _noise(rest, others))


def _product(coefficients: Array, carried: Array) -> Array:
    """(r, DRAWS, k, 2) of coefficients (r, c, 3) and weights (DRAWS, k, 2, c, 3)."""
    r, shape = len(coefficients), carried.shape[:3]
    flat = carried.reshape(-1, coefficients[0].size)
    return np.asarray(coefficients.reshape(r, -1) @ flat.T).reshape(r, *shape)


def _drawn(standard: Array, random: np.random.Generator) -> Array:
    """(DRAWS, c, 3) deviations of three gyros, each those of one that was seen, of either sign."""
    chosen = standard[random.integers(len(standard), size=(DRAWS, 3))]
    signs = random.choice([-1.0, 1.0], size=(DRAWS, 3, 1))
    return np.swapaxes(signs * chosen, 1, 2)


def _noise(covariance: Array, normal: Array) -> Array:
    """(r, DRAWS, k, 2) with this covariance (r, k, 2, 2) of normal pairs (DRAWS, 2)."""
    values, axes = np.linalg.eigh(covariance)
    roots = axes * np.sqrt(np.maximum(values, 0.0))[..., None, :]
    return np.swapaxes(roots @ normal.T, 1, 3).swapaxes(2, 3).copy()
