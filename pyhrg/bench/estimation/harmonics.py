"""Least squares with harmonics of the pattern angle and of the table angle, and the choice of the
terms that the records can separate.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np
from scipy import stats

from pyhrg.bench.outcome import Finding
from pyhrg.common.arrays import Array
from pyhrg.common.units import DEG

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

    names: of the m terms.
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


SCATTER_POINTS = 2
"""Data points that a fit must have beyond the number of its terms, so that the scatter shows."""
LARGEST_FITTED_INFLATION = 1000.0
"""Largest variance inflation factor (chosen) of a term that is fitted. A smaller inflation only
widens intervals, while a term left out would bias the others."""
CURVATURE_SPAN = 3 * DEG
"""Range of pattern angle, rad, above which the bias map is fitted with its curvature. Below it, a
straight line deviates from the map by less than 0.06 % of the map's amplitude."""


@dataclass(frozen=True)
class PatternBasis:
    """Basis functions for the bias against the pattern angle: a fourth harmonic.

    columns: (n,) each, beside the constant one.
    angle: pattern angle, rad, at which the constant is the bias; None where the constant is the
        mean over the circumference.
    """

    columns: dict[str, Array]
    angle: float | None

    @property
    def place(self) -> str:
        """Pattern angle that the figures are for, in words."""
        if self.angle is None:
            return "mean over the circumference"
        return f"at a pattern angle of {self.angle / DEG:.1f} deg"


def choose_pattern_basis(pattern_angle: Array) -> PatternBasis:
    """Basis for the bias at pattern angles (n,), rad.

    Where the angles cover a period of the fourth harmonic, the functions are cos 4th and sin 4th.
    Elsewhere they are sin 4(th - c) and 1 - cos 4(th - c) about the mean angle c. With a constant
    they span the same fourth harmonic, and the constant is the bias at c, which even a pattern that
    hardly moves determines.
    """
    columns = make_columns(pattern_angle, pattern_angle, (4,), tilt=False)
    if max(compute_inflations(columns).values()) <= LARGEST_INFLATION:
        return PatternBasis({name: columns[name] for name in columns if name != MEAN}, None)
    centre = float(np.mean(pattern_angle))
    off = 4 * (pattern_angle - centre)
    local = {"slope": np.sin(off)}
    if np.ptp(pattern_angle) > CURVATURE_SPAN:
        local["curvature"] = 1 - np.cos(off)
    return PatternBasis(local, centre)


def select_separable(columns: Mapping[str, Array]) -> tuple[dict[str, Array], dict[str, str]]:
    """Columns (n,) that can be fitted together; each is added, in order, while all stay separable.

    Returns those that were added, and by name a sentence on each of the others.
    """
    accepted: dict[str, Array] = {}
    refused: dict[str, str] = {}
    for name, column in columns.items():
        trial = {**accepted, name: column}
        worst = _compute_largest_inflation(trial)
        if len(trial) + SCATTER_POINTS > len(column):
            refused[name] = f"{len(column)} data points are too few to fit {name} as well"
        elif worst <= LARGEST_FITTED_INFLATION:
            accepted[name] = column
        elif np.ptp(column) == 0.0:
            refused[name] = f"{name} has no value: the records don't vary what it depends on"
        else:
            factor = f"{worst:.3g} times" if np.isfinite(worst) else "infinitely"
            refused[name] = (
                f"the records can't separate {name} from the other terms: variance inflated "
                f"{factor}, at most {LARGEST_FITTED_INFLATION:g} is accepted"
            )
    return accepted, refused


def _compute_largest_inflation(columns: Mapping[str, Array]) -> float:
    """Largest variance inflation factor (centred) of the columns but the mean."""
    names = [name for name in columns if name != MEAN]
    if not names:
        return 1.0
    matrix = np.column_stack([columns[name] - np.mean(columns[name]) for name in names])
    norms = np.linalg.norm(matrix, axis=0)
    sizes = np.array([np.linalg.norm(columns[name]) for name in names])
    if np.any(norms <= 1e-9 * sizes):
        return np.inf
    correlation = (matrix / norms).T @ (matrix / norms)
    if np.linalg.cond(correlation) > 1e9:
        return np.inf
    return float(np.max(np.diag(np.linalg.inv(correlation))))
