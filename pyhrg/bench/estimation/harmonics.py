"""Linear fit of what repeats with the pattern's and the table's angle, with honest intervals."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy import stats

Array = NDArray[np.float64]

MEAN = "mean"
TILT = ("tilt_cos", "tilt_sin")
LARGEST_INFLATION = 10.0
"""A term whose variance the other terms inflate by more than this can't be told from them."""


def harmonic(order: int) -> tuple[str, str]:
    """Names of the two terms of a harmonic of the pattern angle."""
    return f"cos{order}", f"sin{order}"


def design(
    pattern_angle: Array, table_angle: Array, harmonics: Sequence[int], tilt: bool
) -> dict[str, Array]:
    """Columns (n,) of the model mean + harmonics of the pattern + once a turn of the table."""
    columns = {MEAN: np.ones_like(pattern_angle)}
    for order in harmonics:
        cosine, sine = harmonic(order)
        columns[cosine] = np.cos(order * pattern_angle)
        columns[sine] = np.sin(order * pattern_angle)
    if tilt:
        columns[TILT[0]], columns[TILT[1]] = np.cos(table_angle), np.sin(table_angle)
    return columns


def inflation(columns: dict[str, Array]) -> dict[str, float]:
    """Factor by which the other terms inflate each term's variance; infinite where it is one of
    them, or none at all (variance inflation factor, uncentred)."""
    names = list(columns)
    matrix = np.column_stack([columns[name] for name in names])
    norms = np.linalg.norm(matrix, axis=0)
    result = {}
    for i, name in enumerate(names):
        rest = np.delete(matrix, i, axis=1) / np.delete(norms, i).clip(1e-300)
        fitted = rest @ np.linalg.lstsq(rest, matrix[:, i], rcond=1e-10)[0]
        left = float(np.sum((matrix[:, i] - fitted) ** 2))
        # a column that is zero, or lies in the others' span to rounding, is not seen
        expected = len(matrix) / (1 if name == MEAN else 2)
        result[name] = expected / left if left > 1e-9 * expected else np.inf
    return result


@dataclass(frozen=True)
class Fit:
    """Least squares: terms by name with their covariance.

    residual: (n,), freedom: degrees of freedom that are left.
    """

    names: tuple[str, ...]
    values: Array
    covariance: Array
    residual: Array
    freedom: int

    def value(self, name: str) -> float:
        """Of one term."""
        return float(self.values[self.names.index(name)])

    def deviation(self, name: str) -> float:
        """Standard error of one term."""
        i = self.names.index(name)
        return float(np.sqrt(self.covariance[i, i]))

    def freedom_of(self, *names: str) -> float:
        """Degrees of freedom of the terms' standard errors, the least."""
        return self.freedom

    def interval(self, name: str, confidence: float = 0.95) -> tuple[float, float]:
        """Student's interval of one term: residuals independent and alike."""
        reach = stats.t.ppf((1 + confidence) / 2, self.freedom) * self.deviation(name)
        return self.value(name) - float(reach), self.value(name) + float(reach)


def fit(columns: dict[str, Array], values: Array) -> Fit:
    """Fit values (n,) by the columns.

    Raises:
        ValueError: fewer values than terms and one more, or terms that can't be told apart.
    """
    matrix = np.column_stack(list(columns.values()))
    freedom = len(values) - matrix.shape[1]
    if freedom < 1:
        raise ValueError(
            f"{len(values)} values can't determine {matrix.shape[1]} terms and their scatter"
        )
    scale = np.linalg.norm(matrix, axis=0)
    q, r = np.linalg.qr(matrix / scale)
    if np.min(np.abs(np.diag(r))) < 1e-6:
        raise ValueError(f"terms {', '.join(columns)} can't be told apart by these values")
    inverse = np.linalg.inv(r)
    solution = inverse @ (q.T @ values) / scale
    residual = values - matrix @ solution
    variance = float(residual @ residual) / freedom
    covariance = variance * (inverse @ inverse.T) / np.outer(scale, scale)
    return Fit(tuple(columns), solution, covariance, residual, freedom)
