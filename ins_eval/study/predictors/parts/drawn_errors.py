"""Sampled errors of triads (Eq. 7). All triads share one set of draws of maps, power-on angles and
noise.
"""

import numpy as np
from scipy.stats import qmc

from ins_eval.mission_model.gyro_map import turn_weights
from ins_eval.study.predictors.prediction import SampledPrediction
from pyhrg.common.arrays import Array

DRAWS = 2048
"""Number of samples, a power of two for Sobol's sequence. Chosen: a sampled 5 % or 95 %
quantile then lies at that probability with a standard error of 0.5 %."""


def draw_at_angles(
    weights: Array,
    expected: Array,
    sigma: Array,
    standard: Array,
    other: Array,
    start_angle: Array,
    seed: int,
) -> SampledPrediction:
    """Errors of triads whose power-on angles are known.

    Args:
        weights: (k, 2, c, 3) weights of maps that start at angle 0.
        expected: (r, k, 2) error of the expected maps, m.
        sigma: (r, c, 3) standard deviations of the maps' coefficients.
        standard: (n, c) deviations in units of sigma; each row occurred together in one gyro.
        other: (r, k, 2, 2) covariance of the error by noise and accelerometers, m^2.
        start_angle: (r, 3) pattern angles at power-on, rad.
    """
    random = np.random.default_rng(seed)
    deviations = _draw_deviations(standard, random).reshape(DRAWS, -1)
    others = random.standard_normal((DRAWS, 2))
    shape = (DRAWS, *weights.shape[:2])
    draws = _shape_noise(other, others)
    for r, mean in enumerate(expected):
        carried = turn_weights(weights, start_angle[r]) * sigma[r]
        errors = deviations @ carried.reshape(shape[1] * shape[2], -1).T
        draws[r] += mean + errors.reshape(shape)
    return SampledPrediction(draws)


def draw_at_any_angle(
    weights: Array, maps: Array, sigma: Array, standard: Array, other: Array, seed: int
) -> SampledPrediction:
    """Errors of triads whose power-on angles are unknown: a scrambled Sobol sequence.

    The alignment's second-order error, 1 % of the spread by the angles, is left out. Arguments as
    `draw_at_angles`; maps: (r, c, 3) expected coefficients over the pattern angle itself.
    """
    random = np.random.default_rng(seed)
    deviations = _draw_deviations(standard, random)
    others = random.standard_normal((DRAWS, 2))
    angles = np.pi * qmc.Sobol(maps.shape[2], rng=random).random(DRAWS)
    carried = turn_weights(weights, angles)
    deviating = carried * deviations[:, None, None]
    errors = _multiply(maps, carried) + _multiply(sigma, deviating)
    return SampledPrediction(errors + _shape_noise(other, others))


def _multiply(coefficients: Array, carried: Array) -> Array:
    """(r, DRAWS, k, 2) errors of coefficients (r, c, 3) with weights (DRAWS, k, 2, c, 3)."""
    r, shape = len(coefficients), carried.shape[:3]
    flat = carried.reshape(-1, coefficients[0].size)
    return np.asarray(coefficients.reshape(r, -1) @ flat.T).reshape(r, *shape)


def _draw_deviations(standard: Array, random: np.random.Generator) -> Array:
    """(DRAWS, c, 3) deviations of three gyros; each is a row of `standard` with a random sign."""
    chosen = standard[random.integers(len(standard), size=(DRAWS, 3))]
    signs = random.choice([-1.0, 1.0], size=(DRAWS, 3, 1))
    return np.swapaxes(signs * chosen, 1, 2)


def _shape_noise(covariance: Array, normal: Array) -> Array:
    """(r, DRAWS, k, 2) normal samples with covariance (r, k, 2, 2) from unit ones (DRAWS, 2)."""
    values, axes = np.linalg.eigh(covariance)
    roots = axes * np.sqrt(np.maximum(values, 0.0))[..., None, :]
    return np.swapaxes(roots @ normal.T, 1, 3).swapaxes(2, 3).copy()
