"""What channels tell of the mechanisms: Fisher information, Bayesian bound, confounded directions.

Equations are those of docs/methods/witness.md. States are changes of `mechanisms.MECHANISMS`, SI.
"""

from dataclasses import dataclass

import numpy as np

from pyhrg.common.arrays import Array
from pyhrg.witness.mechanisms import COUNT, TEMPERATURE_RATE
from pyhrg.witness.responses import POWERS, TERMS, Motion, Responses, compute_design

PIECE = 20_000
"""Number of rows that are taken at once; it bounds memory. Chosen."""
SINGULAR = 1e-6
"""Variance of a direction, as a share of the largest, below which it is not a degree of freedom.
Chosen: above the nonlinearity of states that are functions of others."""
OUTPUT = 1
"""Number of channels of the output, which counts where the true rate is known."""


@dataclass(frozen=True)
class Confounded:
    """A direction among the mechanisms, in units of their prior standard deviations.

    gain: eigenvalue of S J S (docs/methods/witness.md, Eq. 7), the information of the channels over
        that of the prior's diagonal; 0 where they carry none on this direction.
    direction: (COUNT,) unit vector.
    """

    gain: float
    direction: Array


def accumulate_information(responses: Responses, motion: Motion) -> Array:
    """(COUNT, COUNT) Fisher information of the forces in all rows of a motion (Eq. 4)."""
    deviation = responses.noise / np.sqrt(motion.interval)
    return _accumulate(responses.forces, deviation, motion)


def accumulate_output_information(responses: Responses, motion: Motion, noise: float) -> Array:
    """(COUNT, COUNT) Fisher information of an output whose true rate is known.

    noise: white noise of the output in one second's mean, rad/s.
    """
    deviation = np.full(OUTPUT, noise) / np.sqrt(motion.interval)
    return _accumulate(responses.output[:, None], deviation, motion)


def compute_posterior(prior: Array, information: Array) -> Array:
    """(COUNT, COUNT) covariance of the mechanisms after the channels were read (Eq. 5).

    The prior may have no inverse: a mechanism without drift stays known.
    """
    root = factor_covariance(prior)
    inner = np.eye(len(prior)) + root.T @ information @ root
    return np.asarray(root @ np.linalg.solve(inner, root.T))


def factor_covariance(covariance: Array) -> Array:
    """(n, n) root R with R R^T the covariance, which may be singular; by its scaled eigenvectors,
    because units differ by orders of magnitude."""
    scale = np.sqrt(np.diag(covariance))
    safe = np.where(scale > 0, scale, 1.0)
    values, vectors = np.linalg.eigh(covariance / np.outer(safe, safe))
    return np.asarray(scale[:, None] * vectors * np.sqrt(np.maximum(values, 0.0)))


def compute_normalized_square(error: Array, covariance: Array) -> tuple[float, int]:
    """Normalised square of an estimate's error, and its degrees of freedom: the covariance may be
    singular, and its units differ by orders of magnitude."""
    scale = np.sqrt(np.diag(covariance))
    used = scale > 0
    values, vectors = np.linalg.eigh(
        covariance[np.ix_(used, used)] / np.outer(scale[used], scale[used])
    )
    known = values > SINGULAR * values[-1]
    along = vectors[:, known].T @ (error[used] / scale[used])
    return float(np.sum(along**2 / values[known])), int(known.sum())


def compute_maps_response(responses: Responses, temperature: float) -> Array:
    """(2 TERMS, COUNT) change of the bias map and of the scale-factor map per unit of each
    mechanism, at a constant temperature above the reference, K."""
    powers = temperature ** np.arange(POWERS)
    maps = np.einsum("p,cpmt->cmt", powers, responses.output[:, :, :2]).reshape(COUNT, -1)
    return np.asarray(np.where(TEMPERATURE_RATE, 0.0, maps.T))


def compute_map_response(responses: Responses, temperature: float) -> Array:
    """(TERMS, COUNT) the same of the bias map alone."""
    return compute_maps_response(responses, temperature)[:TERMS]


def compute_map_deviation(responses: Responses, covariance: Array, temperature: float) -> float:
    """Standard deviation of the bias map, rms over the circumference, rad/s (Eq. 6)."""
    variance = _compute_map_variance(responses, covariance, temperature)
    return float(np.sqrt(variance[0] + variance[1:].sum() / 2))


def compute_mean_deviation(responses: Responses, covariance: Array, temperature: float) -> float:
    """Standard deviation of the bias map's mean, rad/s."""
    return float(np.sqrt(_compute_map_variance(responses, covariance, temperature)[0]))


def rank_directions(prior: Array, information: Array) -> list[Confounded]:
    """Directions among the mechanisms, from what the channels tell best to what they tell least
    (Eq. 7): singular vectors of the channels' sensitivities in units of noise and of the prior."""
    scale = np.sqrt(np.diag(prior))
    values, vectors = np.linalg.eigh(information * np.outer(scale, scale))
    order = np.argsort(-values)
    return [Confounded(float(max(values[i], 0.0)), vectors[:, i]) for i in order]


def _compute_map_variance(responses: Responses, covariance: Array, temperature: float) -> Array:
    response = compute_map_response(responses, temperature)
    variance = np.einsum("ti,ij,tj->t", response, covariance, response)
    assert len(variance) == TERMS
    return np.maximum(variance, 0.0)


def _accumulate(sensitivities: Array, deviation: Array, motion: Motion) -> Array:
    count = len(sensitivities)
    information = np.zeros((count, count))
    for first in range(0, len(motion.angle), PIECE):
        design = compute_design(sensitivities, motion.take(slice(first, first + PIECE)))
        scaled = (design / deviation[:, None]).reshape(-1, count)
        information += scaled.T @ scaled
    return information
