"""Generalised least squares on angles with white rate noise and white angle noise.

Increments of such an angle have the covariance q dt I + r T, where T is tridiagonal (2, -1). The
discrete sine transform makes it diagonal, so that weighted least squares on the transformed
increments is exact. Both variances are estimated from the residual by restricted maximum likelihood
(H. D. Patterson, R. Thompson, Biometrika 58, 1971). Each term's degrees of freedom follow from the
uncertainty of the variances (F. E. Satterthwaite, Biometrics Bulletin 2, 1946).
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np
from scipy import fft, optimize, stats

from pyhrg.bench.estimation.harmonics import Fit
from pyhrg.bench.estimation.row_fit import compute_eigenvalues, compute_matrix_inflations
from pyhrg.bench.outcome import Finding
from pyhrg.common.arrays import Array

RATE_NOISE_FLOOR = 1e-60
"""Density of the rate noise, rad^2/s, that stands for zero where the residual is zero; its square
is still above the smallest double."""
LOG_RATIO_BOUNDS = (-8.0, 20.0)
"""Range in which the logarithm of the ratio of angle noise to the rate noise of a step is searched.
The ends mean practically no angle noise and practically no rate noise."""


@dataclass(frozen=True)
class Record:
    """One uninterrupted record of an angle.

    Attributes:
        interval: time between samples, s.
        angle: (n,) rad.
        columns: (n,) each, by the term's name: what one unit of the term adds to the angle. A
            constant in a column has no effect.
    """

    interval: float
    angle: Array
    columns: Mapping[str, Array]


@dataclass(frozen=True)
class AngleFit(Fit):
    """Fitted terms and both noises; the residual is that of the transformed increments.

    Attributes:
        rate_noise: power spectral density N^2 of the white rate noise, (rad/s)^2/Hz = rad^2/s.
        angle_noise: variance of a sample's white angle noise, rad^2.
    """

    rate_noise: float
    angle_noise: float


def compute_largest_inflation(records: Sequence[Record]) -> float:
    """Largest variance inflation factor of the terms, see `compute_matrix_inflations`."""
    increments = np.concatenate([_compute_increments(record) for record in records])
    return max(compute_matrix_inflations(increments[:, :-1]))


def fit_angles(records: Sequence[Record]) -> AngleFit:
    """Fit of several records by common terms and common noise."""
    steps, differences = _compute_components(records)
    tables = [_compute_increments(record) for record in records]
    matrix = np.concatenate([fft.dst(table, type=1, norm="ortho", axis=0) for table in tables])
    terms = matrix.shape[1] - 1
    if len(matrix) < terms + 3:
        raise ValueError(f"{len(matrix)} increments can't determine {terms} terms and two noises")
    scale = np.linalg.norm(matrix[:, :-1], axis=0)
    matrix[:, :-1] /= scale
    variances = _estimate_variances(matrix, steps, differences)
    return _fit_weighted(tuple(records[0].columns), matrix, scale, steps, differences, variances)


def _compute_increments(record: Record) -> Array:
    """(n - 1, terms + 1) increments of the columns and, last, of the angle."""
    return np.diff(np.column_stack([*record.columns.values(), record.angle]), axis=0)


def _compute_components(records: Sequence[Record]) -> Array:
    """(2, n) variances of the transformed increments for unit rate noise and unit angle noise."""
    counts = [len(record.angle) - 1 for record in records]
    steps = [np.full(n, record.interval) for n, record in zip(counts, records, strict=True)]
    differences = [compute_eigenvalues(count) for count in counts]
    return np.array([np.concatenate(steps), np.concatenate(differences)])


def _estimate_variances(matrix: Array, steps: Array, differences: Array) -> tuple[float, float]:
    """Rate noise, rad^2/s, and angle noise, rad^2, by restricted maximum likelihood."""
    step, freedom = float(np.mean(steps)), len(matrix) - matrix.shape[1] + 1
    terms = matrix[:, :-1]
    residual = matrix[:, -1] - terms @ np.linalg.lstsq(terms, matrix[:, -1], rcond=None)[0]
    size = float(np.linalg.norm(residual))
    if size == 0.0:
        return RATE_NOISE_FLOOR, 0.0
    whole = np.column_stack([terms, residual / size])

    def reduced(logarithm: float) -> tuple[float, float]:
        weight = steps / step + np.exp(logarithm) * differences
        diagonal = np.diag(np.linalg.cholesky(whole.T @ (whole / weight[:, None])))
        variance = float((size * diagonal[-1]) ** 2 / freedom)
        spread = np.sum(np.log(weight)) + 2 * np.sum(np.log(diagonal[:-1]))
        return float(freedom * np.log(variance) + spread), variance

    best = optimize.minimize_scalar(
        lambda x: reduced(x)[0], bounds=LOG_RATIO_BOUNDS, method="bounded", options={"xatol": 0.01}
    )
    variance = reduced(best.x)[1]
    return variance / step, variance * float(np.exp(best.x))


def _fit_weighted(
    names: tuple[str, ...],
    matrix: Array,
    scale: Array,
    steps: Array,
    differences: Array,
    noise: tuple[float, float],
) -> AngleFit:
    parts = np.array([steps, differences])
    variance = np.asarray(noise) @ parts
    whitened = matrix / np.sqrt(variance)[:, None]
    q, r = np.linalg.qr(whitened[:, :-1])
    inverse = np.linalg.inv(r)
    solution = inverse @ (q.T @ whitened[:, -1])
    residual = whitened[:, -1] - whitened[:, :-1] @ solution
    freedom = len(residual) - len(names)
    covariance = inverse @ inverse.T
    # Satterthwaite: derivative of the terms' variances by both noises, and the noises' information
    slopes = (parts / variance) @ (q @ inverse.T) ** 2
    information = (parts / variance) @ (parts / variance).T / 2
    spread = np.einsum("ij,ij->j", slopes, np.linalg.solve(information, slopes))
    freedoms = np.minimum(2 * np.diag(covariance) ** 2 / spread, freedom)
    covariance = covariance / np.outer(scale, scale)
    return AngleFit(names, solution / scale, covariance, residual, freedom, freedoms, *noise)


Walk = tuple[float, float]
"""Power spectral density N^2 of the rate noise, rad^2/s, and its degrees of freedom."""


def estimate_walk(fit: AngleFit, records: Sequence[Record]) -> Walk:
    """Rate noise of a fit with its degrees of freedom.

    The variance of the estimated density is an element of the inverse Fisher information of both
    noises, to which each sine of the increments contributes. A chi-square estimate with f degrees
    of freedom has the variance 2 N^4 / f: that gives f.
    """
    parts = _compute_components(records)
    weighted = parts / (np.array([fit.rate_noise, fit.angle_noise]) @ parts)
    information = weighted @ weighted.T / 2
    share = fit.freedom / parts.shape[1]
    variance = float(np.linalg.inv(information)[0, 0]) / share
    return fit.rate_noise, 2 * fit.rate_noise**2 / variance


def make_walk_finding(name: str, walk: Walk) -> Finding:
    """Angle random walk N with its chi-square interval."""
    density, freedom = walk
    high, low = np.sqrt(freedom / stats.chi2.ppf([0.025, 0.975], freedom))
    value = float(np.sqrt(density))
    n = round(freedom)
    return Finding(name, value, "deg/sqrt(h)", value * float(low), value * float(high), n)


def estimate_walk_ratio(name: str, first: Walk, second: Walk) -> Finding:
    """Ratio of two independent angle random walks N, with the interval of the F distribution."""
    value = float(np.sqrt(first[0] / second[0]))
    quantiles = stats.f.ppf([0.975, 0.025], first[1], second[1])
    low, high = value / np.sqrt(quantiles)
    return Finding(name, value, "1", float(low), float(high), round(min(first[1], second[1])))
