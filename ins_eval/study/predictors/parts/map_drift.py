"""How much maps change between bench and flight, and in it: learnt from the training half.

Some mechanisms age, warm and scatter in proportion to their size, which shows in what the bench
sees of a gyro's bias map, scatter over power-ons included; some are the same for all gyros. The
variance of each coefficient has a part of either kind. Temperatures and mechanisms differ from gyro
to gyro, so that drift is far from normal: those of the training half, in units of their standard
deviations, are its distribution.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import nnls

from ins_eval.mission_model.gyro_map import TERMS
from ins_eval.mission_model.signals import COUNT
from ins_eval.study.predictors.knowledge import BenchKnowledge
from ins_eval.study.predictors.parts.turned_maps import unstarted

Array = NDArray[np.float64]


@dataclass(frozen=True)
class MapDrift:
    """Of the coefficients of a gyro in flight less the bench's, from pattern angle 0.

    common: (COUNT,) variance in all gyros; relative: (COUNT,) per squared `map_size`;
    standard: (n, COUNT) drifts of the training half's gyros, the bench's error included, in units
    of their standard deviations; what errs together in one gyro stays together.
    """

    common: Array
    relative: Array
    standard: Array

    def sigma(self, bench: BenchKnowledge) -> Array:
        """(r, COUNT, 3) standard deviations of the drift of these gyros."""
        power = map_size(bench)[:, None] ** 2
        return np.sqrt(self.common[:, None] + self.relative[:, None] * power)

    def missed(self, bench: BenchKnowledge) -> Array:
        """(r, COUNT, 3) those of drift and the bench's error together."""
        return np.sqrt(self.sigma(bench) ** 2 + bench.variance)

    @property
    def together(self) -> Array:
        """(COUNT, COUNT) mean products of the drifts, in units of their standard deviations."""
        return np.asarray(self.standard.T @ self.standard / len(self.standard))


NO_DRIFT = MapDrift(np.zeros(COUNT), np.zeros(COUNT), np.zeros((1, COUNT)))


def map_size(bench: BenchKnowledge) -> Array:
    """(r, 3) root mean square of the bias map's harmonics in another power-on, rad/s."""
    harmonics = slice(1, TERMS)
    power = bench.maps[:, harmonics] ** 2 + bench.variance[:, harmonics]
    return np.asarray(np.sqrt(power.mean(axis=1)))


def learnt(bench: BenchKnowledge, in_flight: Array, start_angle: Array) -> MapDrift:
    """Squares, less what the fits' own uncertainty explains, regressed on 1 and the squared size;
    they scatter as they are large, so that small gyros weigh more.

    Args:
        bench: of the training half.
        in_flight: (r, COUNT, 3) their maps.
        start_angle: (r, 3) rad.
    """
    drifted = unstarted(in_flight, start_angle) - bench.maps
    power = np.ravel(map_size(bench) ** 2)
    unit = np.median(power)
    weight = 1 / (1 + power / unit)
    rows = np.stack([weight, weight * power / unit], axis=1)
    squares = _by_gyro(drifted**2 - bench.variance)
    found = np.array([_positive(rows, weight * column) for column in squares.T])
    drift = MapDrift(found[:, 0], found[:, 1] / unit, NO_DRIFT.standard)
    sigma = _by_gyro(drift.missed(bench))
    standard = _by_gyro(drifted) / np.where(sigma > 0, sigma, np.inf)
    return MapDrift(drift.common, drift.relative, standard)


def _positive(rows: Array, values: Array) -> Array:
    """Least squares without negative variances, in the values' own scale."""
    scale = float(np.max(np.abs(values)))
    return nnls(rows, values / scale)[0] * scale if scale > 0 else np.zeros(rows.shape[1])


def _by_gyro(values: Array) -> Array:
    """(3 r, COUNT) of values (r, COUNT, 3)."""
    return np.moveaxis(values, 2, 1).reshape(-1, values.shape[1])
