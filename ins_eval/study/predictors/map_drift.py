"""How much maps change between bench and flight, and in it: learnt from the training half.

Mechanisms age, warm and scatter in proportion to their own size. How large they are in a gyro shows
in what the bench sees of its bias map, scatter over power-ons included; drift counts in units of
that.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ins_eval.study.gyro_map import TERMS
from ins_eval.study.predictors.knowledge import BenchKnowledge
from ins_eval.study.predictors.turned_maps import unstarted

Array = NDArray[np.float64]


@dataclass(frozen=True)
class MapDrift:
    """relative: (4 TERMS, 4 TERMS) covariance of a gyro's map at power-on less the bench's, and of
    what the map gains by warming, from pattern angle 0, per squared `map_size`;
    gyros: how many it was learnt from."""

    relative: Array
    gyros: int

    def covariance(self, bench: BenchKnowledge) -> Array:
        """(r, 4 TERMS, 4 TERMS, 3) of the drift of these gyros."""
        size = map_size(bench)
        return np.asarray(self.relative[..., None] * size[:, None, None] ** 2)


NO_DRIFT = MapDrift(np.zeros((4 * TERMS, 4 * TERMS)), 0)


def map_size(bench: BenchKnowledge) -> Array:
    """(r, 3) root mean square of the bias map's harmonics in another power-on, rad/s."""
    harmonics = slice(1, TERMS)
    scatter = np.diagonal(bench.covariance, axis1=1, axis2=2)
    scatter = np.swapaxes(scatter, 1, 2)
    power = bench.maps[:, harmonics] ** 2 + scatter[:, harmonics]
    return np.asarray(np.sqrt(power.mean(axis=1)))


def learnt(bench: BenchKnowledge, started: Array, warming: Array, start_angle: Array) -> MapDrift:
    """Second moments about zero, less what the fits' own uncertainty explains.

    Args:
        bench: of the training half.
        started, warming: (r, 2 TERMS, 3) their maps in flight, from their power-on angles.
        start_angle: (r, 3) rad.
    """
    drifted = unstarted(started, start_angle) - bench.maps
    both = np.concatenate([drifted, unstarted(warming, start_angle)], axis=1)
    size = map_size(bench)[:, None]
    gyros, half = size.size, 2 * TERMS
    moments = np.einsum("rca,rda->cd", both / size, both / size) / gyros
    moments[:half, :half] -= np.mean(bench.covariance / size[:, None] ** 2, axis=(0, 3))
    return MapDrift(_without_negative(moments), gyros)


def _without_negative(moments: Array) -> Array:
    """The nearest covariance, in units in which the diagonal is 1."""
    scale = np.sqrt(np.maximum(np.abs(np.diag(moments)), np.finfo(float).tiny))
    values, axes = np.linalg.eigh(moments / np.outer(scale, scale))
    kept = (axes * np.maximum(values, 0.0)) @ axes.T
    return np.asarray(kept * np.outer(scale, scale))
