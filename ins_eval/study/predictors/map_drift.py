"""How much maps change between bench and flight, and in it: learnt from the training half.

Some mechanisms age, warm and scatter in proportion to their size, which shows in what the bench
sees of a gyro's bias map, scatter over power-ons included; some are the same for all gyros. Drift
has a part of either kind.
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
    """Of a gyro's map at power-on less the bench's, and of what the map gains by warming, from
    pattern angle 0: covariance (4 TERMS, 4 TERMS).

    common: of all gyros; relative: per squared `map_size`; gyros: how many it was learnt from.
    """

    common: Array
    relative: Array
    gyros: int

    def covariance(self, bench: BenchKnowledge) -> Array:
        """(r, 4 TERMS, 4 TERMS, 3) of the drift of these gyros."""
        power = map_size(bench)[:, None, None] ** 2
        return np.asarray(self.common[..., None] + self.relative[..., None] * power)


NO_DRIFT = MapDrift(np.zeros((4 * TERMS, 4 * TERMS)), np.zeros((4 * TERMS, 4 * TERMS)), 0)


def map_size(bench: BenchKnowledge) -> Array:
    """(r, 3) root mean square of the bias map's harmonics in another power-on, rad/s."""
    harmonics = slice(1, TERMS)
    scatter = np.diagonal(bench.covariance, axis1=1, axis2=2)
    scatter = np.swapaxes(scatter, 1, 2)
    power = bench.maps[:, harmonics] ** 2 + scatter[:, harmonics]
    return np.asarray(np.sqrt(power.mean(axis=1)))


def learnt(bench: BenchKnowledge, started: Array, warming: Array, start_angle: Array) -> MapDrift:
    """Squares and products about zero, less what the fits' own uncertainty explains, regressed on
    1 and the squared size; squares scatter as they are large, so that small gyros weigh more.

    Args:
        bench: of the training half.
        started, warming: (r, 2 TERMS, 3) their maps in flight, from their power-on angles.
        start_angle: (r, 3) rad.
    """
    drifted = unstarted(started, start_angle) - bench.maps
    both = np.concatenate([drifted, unstarted(warming, start_angle)], axis=1)
    products = np.einsum("rca,rda->racd", both, both)
    half = 2 * TERMS
    products[..., :half, :half] -= np.moveaxis(bench.covariance, -1, 1)
    power = np.ravel(map_size(bench) ** 2)
    unit = np.median(power)
    weight = 1 / (1 + power / unit)
    rows = np.stack([weight, weight * power / unit], axis=1)
    values = weight[:, None] * products.reshape(len(power), -1)
    found = np.linalg.lstsq(rows, values, rcond=None)[0].reshape(2, 2 * half, 2 * half)
    common, relative = (_without_negative(part) for part in found)
    return MapDrift(common, relative / unit, len(power))


def _without_negative(moments: Array) -> Array:
    """The nearest covariance, in units in which the diagonal is 1."""
    scale = np.sqrt(np.maximum(np.abs(np.diag(moments)), np.finfo(float).tiny))
    values, axes = np.linalg.eigh(moments / np.outer(scale, scale))
    kept = (axes * np.maximum(values, 0.0)) @ axes.T
    return np.asarray(kept * np.outer(scale, scale))
