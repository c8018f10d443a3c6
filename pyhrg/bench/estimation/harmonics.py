"""Least squares with harmonics of the pattern angle and of the table angle."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from scipy import stats

from pyhrg.bench.outcome import Finding
from pyhrg.common.arrays import Array

MEAN = "mean"
TILT = ("tilt_cos", "tilt_sin")
LARGEST_INFLATION = 10.0
"""Largest variance inflation factor (chosen) of a term that counts as separable from the others."""


def name_terms(order: int) -> tuple[str, str]:
    """Names of the cosine and the sine term of a harmonic of the pattern angle."""
    return f"cos{order}", f"sin{order}"


def make_columns(
    pattern_angle: Array, table_angle: Array, harmonics: Sequence[int], tilt: bool
) -> dict[str, Array]:
    """Columns of a linear model: mean, harmonics of the pattern angle and, for a tilt of the input
    axis, the first harmonic of the table angle.

    Angles are (n,) rad. Returns (n,) each, by the term's name.
    """
    columns = {MEAN: np.ones_like(pattern_angle)}
    for order in harmonics:
        cosine, sine = name_terms(order)
        columns[cosine] = np.cos(order * pattern_angle)
        columns[sine] = np.sin(order * pattern_angle)
    if tilt:
        columns[TILT[0]], columns[TILT[1]] = np.cos(table_angle), np.sin(table_angle)
    return columns


def average_wave(trig: np.ufunc, order: int, angle: Array) -> Array:
    """(n,) mean of cosine or sine (`trig`) of `order` times an angle (n + 1,), rad, that is linear
    between its values."""
    middle, swept = (angle[1:] + angle[:-1]) / 2, np.diff(angle)
    return np.asarray(trig(order * middle) * np.sinc(order * swept / (2 * np.pi)))


def compute_inflations(columns: dict[str, Array]) -> dict[str, float]:
    """Variance inflation factor (uncentred) of each term; infinite where a term is zero or lies in
    the span of the others."""
    names = list(columns)
    matrix = np.column_stack([columns[name] for name in names])
    norms = np.linalg.norm(matrix, axis=0)
    result = {}
    for i, name in enumerate(names):
        others = np.delete(matrix, i, axis=1) / np.delete(norms, i).clip(1e-300)
        fitted = others @ np.linalg.lstsq(others, matrix[:, i], rcond=1e-10)[0]
        square = float(np.sum((matrix[:, i] - fitted) ** 2))
        # a column that is zero or lies in the others' span, but for rounding, counts as unseen
        expected = len(matrix) / (1 if name == MEAN else 2)
        result[name] = expected / square if square > 1e-9 * expected else np.inf
    return result


@dataclass(frozen=True)
class Fit:
    """Result of a least-squares fit; the residual of a generalised one is whitened.

    Attributes:
        names: names of the m terms.
        values: (m,) SI.
        covariance: (m, m) of the values.
        residual: (n,).
        freedom: degrees of freedom of the residual, or the smallest of `freedoms`.
        freedoms: (m,) degrees of freedom of the values' standard errors.
    """

    names: tuple[str, ...]
    values: Array
    covariance: Array
    residual: Array
    freedom: int
    freedoms: Array

    @property
    def terms(self) -> dict[str, float]:
        """Values of the terms, SI, by name."""
        return dict(zip(self.names, self.values.tolist(), strict=True))

    def value(self, name: str) -> float:
        """Value of a term, SI."""
        return float(self.values[self.names.index(name)])

    def deviation(self, name: str) -> float:
        """Standard error of a term, SI."""
        i = self.names.index(name)
        return float(np.sqrt(self.covariance[i, i]))

    def freedom_of(self, *names: str) -> float:
        """Degrees of freedom of the terms' standard errors; the smallest of them."""
        return float(min(self.freedoms[self.names.index(name)] for name in names))

    def interval(self, name: str) -> tuple[float, float]:
        """Student's 95 % interval of a term, SI."""
        reach = float(stats.t.ppf(0.975, self.freedom_of(name))) * self.deviation(name)
        return self.value(name) - reach, self.value(name) + reach

    def finding(
        self, term: str, name: str, unit: str, factor: float = 1.0, note: str = ""
    ) -> Finding:
        """The finding that is a term times a factor."""
        low, high = sorted(factor * bound for bound in self.interval(term))
        return Finding(name, factor * self.value(term), unit, low, high, len(self.residual), note)


def fit(columns: dict[str, Array], values: Array) -> Fit:
    """Least-squares fit of values (n,) by columns (n,) each."""
    matrix = np.column_stack(list(columns.values()))
    freedom = len(values) - matrix.shape[1]
    if freedom < 1:
        raise ValueError(
            f"{len(values)} values can't determine {matrix.shape[1]} terms and their scatter"
        )
    scale = np.linalg.norm(matrix, axis=0)
    q, r = np.linalg.qr(matrix / scale)
    if np.min(np.abs(np.diag(r))) < 1e-6:
        raise ValueError(f"terms {', '.join(columns)} can't be separated by these values")
    inverse = np.linalg.inv(r)
    solution = inverse @ (q.T @ values) / scale
    residual = values - matrix @ solution
    variance = float(residual @ residual) / freedom
    covariance = variance * (inverse @ inverse.T) / np.outer(scale, scale)
    freedoms = np.full(len(columns), float(freedom))
    return Fit(tuple(columns), solution, covariance, residual, freedom, freedoms)
