"""What is left unknown of the mechanisms: of the bias map, and directions that stay confounded.

Equations are those of docs/methods/witness.md.
"""

from dataclasses import dataclass

import numpy as np

from pyhrg.common.arrays import Array
from pyhrg.witness.design import TERMS
from pyhrg.witness.information import compute_maps_response
from pyhrg.witness.responses import Responses


@dataclass(frozen=True)
class Confounded:
    """A direction among the mechanisms, in units of their prior standard deviations.

    gain: eigenvalue of S J S (docs/methods/witness.md, Eq. 7), the information of the channels over
        that of the prior's diagonal; 0 where they carry none on this direction.
    direction: (COUNT,) unit vector.
    """

    gain: float
    direction: Array


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
    response = compute_maps_response(responses, temperature)[:TERMS]
    variance = np.einsum("ti,ij,tj->t", response, covariance, response)
    return np.maximum(variance, 0.0)
