"""Ensembles of error histories, drawn from the linear model."""

import numpy as np

from ins_eval.error_model.dynamics import COUNT
from ins_eval.error_model.linear_model import AXES, LinearModel
from pyhrg.common.arrays import Array


def draw_ensemble(
    model: LinearModel,
    initial: Array,
    sigmas: Array,
    members: int,
    generator: np.random.Generator,
    keep_every: int = 1,
) -> Array:
    """Draw error histories (n / keep_every + 1, members, 10) with the moments of
    `propagate_covariance` (docs/methods/error_model.md, Eq. 13).

    Args:
        model: with its noise.
        initial: (10, 10) covariance at the start.
        sigmas: (e, 3) standard deviations of the coefficients, the same at all times.
        members: number of histories.
        generator: of all random draws.
        keep_every: steps between the rows that are kept.
    """
    spread = np.ravel(sigmas)
    persistence = np.repeat(model.persistence, AXES)
    renewed = spread * np.sqrt(1 - persistence**2)
    x = generator.standard_normal((members, COUNT)) @ _root(np.asarray(initial)).T
    coefficients = generator.standard_normal((members, len(spread))) * spread
    inputs = model.inputs.reshape(len(model), COUNT, -1)
    roots = _root(model.noise_covariance)
    roots = roots[:, :, np.any(roots != 0, axis=(0, 1))]
    kept = [x]
    for k, phi in enumerate(model.transition):
        x = x @ phi.T + coefficients @ inputs[k].T
        x += generator.standard_normal((members, roots.shape[2])) @ roots[k].T
        if np.any(renewed):
            coefficients = coefficients * persistence
            coefficients += generator.standard_normal(coefficients.shape) * renewed
        if (k + 1) % keep_every == 0:
            kept.append(x)
    return np.stack(kept)


def _root(covariance: Array) -> Array:
    """Return R (..., 10, 10) with R R' the covariance, which may be singular."""
    scale = np.sqrt(np.diagonal(covariance, axis1=-2, axis2=-1))
    safe = np.where(scale > 0, scale, 1.0)
    values, vectors = np.linalg.eigh(covariance / safe[..., :, None] / safe[..., None, :])
    values = np.where(values > 1e-14, values, 0.0)
    return np.asarray(scale[..., :, None] * vectors * np.sqrt(values)[..., None, :])
