"""Distribution of the maps' change from bench to flight, from the training triads (Eq. 6).

Some mechanisms age, warm and scatter in proportion to their size, which the bench's bias map shows;
others do not depend on it. The variance of each coefficient therefore has a relative and a common
part. Temperatures and mechanisms differ from gyro to gyro, so that the drift is far from normal.
Its distribution is that of the training triads' drifts in units of their standard deviations.
"""

from dataclasses import dataclass

import numpy as np
from scipy.optimize import nnls

from ins_eval.mission_model.gyro_map import TERMS, undo_start
from ins_eval.mission_model.signals import COUNT
from ins_eval.study.predictors.bench_figures import BenchFigures
from pyhrg.common.arrays import Array


@dataclass(frozen=True)
class MapDrift:
    """Coefficients of a gyro in flight less those of the bench, over the pattern angle itself.

    Attributes:
        common: (COUNT,) variance that is the same in all gyros.
        relative: (COUNT,) variance per squared `compute_map_size`.
        standard: (n, COUNT) drifts of the training triads' gyros, bench errors included, in units
            of their standard deviations; a row is one gyro's.
    """

    common: Array
    relative: Array
    standard: Array

    def sigma(self, bench: BenchFigures) -> Array:
        """(r, COUNT, 3) standard deviations of the drift of these gyros."""
        power = compute_map_size(bench)[:, None] ** 2
        return np.sqrt(self.common[:, None] + self.relative[:, None] * power)

    def compute_sigma_with_bench(self, bench: BenchFigures) -> Array:
        """(r, COUNT, 3) standard deviations of drift and bench error together."""
        return np.sqrt(self.sigma(bench) ** 2 + bench.variance)


NO_DRIFT = MapDrift(np.zeros(COUNT), np.zeros(COUNT), np.zeros((1, COUNT)))


def compute_map_size(bench: BenchFigures) -> Array:
    """(r, 3) rms of the bias map's harmonics expected in another power-on, rad/s."""
    harmonics = slice(1, TERMS)
    power = bench.maps[:, harmonics] ** 2 + bench.variance[:, harmonics]
    return np.asarray(np.sqrt(power.mean(axis=1)))


def estimate_map_drift(bench: BenchFigures, in_flight: Array, start_angle: Array) -> MapDrift:
    """The distribution of drift, by weighted least squares without negative variances.

    Squared drifts, less the bench's own variance, are regressed on 1 and the squared map size.
    Large squares scatter more and have smaller weights.

    Args:
        in_flight: (r, COUNT, 3) true coefficients in flight.
        start_angle: (r, 3) pattern angles at power-on, rad.
    """
    drifted = undo_start(in_flight, start_angle) - bench.maps
    power = np.ravel(compute_map_size(bench) ** 2)
    unit = np.median(power)
    weight = 1 / (1 + power / unit)
    rows = np.stack([weight, weight * power / unit], axis=1)
    squares = _stack_gyros(drifted**2 - bench.variance)
    coefficients = np.array([_fit_nonnegative(rows, weight * column) for column in squares.T])
    drift = MapDrift(coefficients[:, 0], coefficients[:, 1] / unit, NO_DRIFT.standard)
    sigma = _stack_gyros(drift.compute_sigma_with_bench(bench))
    standard = _stack_gyros(drifted) / np.where(sigma > 0, sigma, np.inf)
    return MapDrift(drift.common, drift.relative, standard)


def _fit_nonnegative(rows: Array, values: Array) -> Array:
    """Nonnegative least squares, with the values scaled to 1."""
    scale = float(np.max(np.abs(values)))
    return nnls(rows, values / scale)[0] * scale if scale > 0 else np.zeros(rows.shape[1])


def _stack_gyros(values: Array) -> Array:
    """(3 r, COUNT) values of all gyros, from (r, COUNT, 3)."""
    return np.moveaxis(values, 2, 1).reshape(-1, values.shape[1])
