"""How much maps change between bench and flight, and in it: learnt from the training half."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ins_eval.study.gyro_map import TERMS
from ins_eval.study.predictors.knowledge import BenchKnowledge
from ins_eval.study.predictors.turned_maps import unstarted

Array = NDArray[np.float64]


@dataclass(frozen=True)
class MapDrift:
    """covariance: (4 TERMS, 4 TERMS) of a gyro's map at power-on less the bench's, and of what the
    map gains by warming, from pattern angle 0; gyros: how many it was learnt from."""

    covariance: Array
    gyros: int


NO_DRIFT = MapDrift(np.zeros((4 * TERMS, 4 * TERMS)), 0)


def learnt(
    knowledge: BenchKnowledge, started: Array, warming: Array, start_angle: Array
) -> MapDrift:
    """Second moments about zero, less what the fits' own uncertainty explains.

    Args:
        knowledge: of the training half.
        started, warming: (r, 2 TERMS, 3) their maps in flight, from their power-on angles.
        start_angle: (r, 3) rad.
    """
    drifted = unstarted(started, start_angle) - knowledge.maps
    both = np.concatenate([drifted, unstarted(warming, start_angle)], axis=1)
    gyros = both.shape[0] * both.shape[2]
    moments = np.einsum("rca,rda->cd", both, both) / gyros
    half = 2 * TERMS
    moments[:half, :half] -= knowledge.covariance.mean(axis=(0, 3))
    return MapDrift(_without_negative(moments), gyros)


def _without_negative(moments: Array) -> Array:
    """The nearest covariance, in units in which the diagonal is 1."""
    scale = np.sqrt(np.maximum(np.abs(np.diag(moments)), np.finfo(float).tiny))
    values, axes = np.linalg.eigh(moments / np.outer(scale, scale))
    kept = (axes * np.maximum(values, 0.0)) @ axes.T
    return np.asarray(kept * np.outer(scale, scale))
