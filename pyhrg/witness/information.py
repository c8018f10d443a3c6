"""Information of channels about the mechanisms: Fisher information, Bayesian bound.

Equations are those of docs/methods/witness.md. States are changes of `mechanisms.MECHANISMS`, SI.
"""

import numpy as np

from pyhrg.common.arrays import Array
from pyhrg.witness.design import POWERS, Motion, compute_design
from pyhrg.witness.mechanisms import COUNT, STEADY
from pyhrg.witness.responses import Responses

PIECE = 20_000
"""Number of rows that are taken at once; it bounds memory. Chosen."""
SINGULAR = 1e-6
"""Variance of a direction, as a share of the largest, below which it is not a degree of freedom.
Chosen: above the nonlinearity of states that are functions of others."""
OUTPUT = 1
"""Number of channels of the output, which counts where the true rate is known."""


def accumulate_information(responses: Responses, motion: Motion) -> Array:
    """(COUNT, COUNT) Fisher information of the forces in all rows of a motion (Eq. 4)."""
    deviation = responses.noise / np.sqrt(motion.interval)
    return _accumulate(responses.forces, deviation, motion, responses.angular_gain)


def accumulate_output_information(responses: Responses, motion: Motion, noise: float) -> Array:
    """(COUNT, COUNT) Fisher information of an output whose true rate is known.

    noise: white noise of the output in one second's mean, rad/s.
    """
    deviation = np.full(OUTPUT, noise) / np.sqrt(motion.interval)
    return _accumulate(responses.output[:, None], deviation, motion, responses.angular_gain)


def compute_posterior(prior: Array, information: Array) -> Array:
    """(COUNT, COUNT) covariance of the mechanisms after the channels were read (Eq. 5).

    The prior may have no inverse: a mechanism without drift stays known.
    """
    root = factor_covariance(prior)
    inner = np.eye(len(prior)) + root.T @ information @ root
    return np.asarray(root @ np.linalg.solve(inner, root.T))


def factor_covariance(covariance: Array) -> Array:
    """(n, n) root R with R R^T the covariance, which may be singular; by its scaled eigenvectors,
    because units differ by orders of magnitude. A variance below zero is rounding."""
    scale = np.sqrt(np.maximum(np.diag(covariance), 0.0))
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
    mechanism, at a constant temperature above the reference, K, without specific force."""
    powers = temperature ** np.arange(POWERS)
    maps = np.einsum("p,cpmt->cmt", powers, responses.output[:, :, :2]).reshape(COUNT, -1)
    return np.asarray(np.where(STEADY, maps.T, 0.0))


def _accumulate(
    sensitivities: Array, deviation: Array, motion: Motion, angular_gain: float
) -> Array:
    count = len(sensitivities)
    information = np.zeros((count, count))
    for first in range(0, len(motion.angle), PIECE):
        piece = motion.take(slice(first, first + PIECE))
        design = compute_design(sensitivities, piece, angular_gain)
        scaled = (design / deviation[:, None]).reshape(-1, count)
        information += scaled.T @ scaled
    return information
