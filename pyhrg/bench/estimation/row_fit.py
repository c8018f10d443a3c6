"""Generalised least squares on rows whose noise is white noise plus differenced white noise.

Increments of an angle have such noise: white rate noise adds to each row, and the white noise of an
angle adds to one row and is subtracted from the next. Row means of a loop's force or frequency have
it as well. Over n rows without gap the covariance q h I + r T, T tridiagonal (2, -1), is diagonal
in sines (discrete sine transform I). Its eigenvalues are q h + r (2 - 2 cos(pi j / (n + 1))).

The densities q and r are estimated by restricted maximum likelihood (iterated MINQUE: C. R. Rao
1971; Searle, Casella and McCulloch, Variance Components, 1992, ch. 11). A short record hardly
determines q, and its estimate may be zero. Each density is therefore replaced by its mean over
positive values, intervals use Satterthwaite's degrees of freedom, and the covariance is enlarged
for the uncertainty of the weights (M. G. Kenward, J. H. Roger, Biometrics 53, 1997).
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np
from scipy import stats
from scipy.fft import dst

from pyhrg.bench.estimation.harmonics import Fit
from pyhrg.common.arrays import Array

ITERATION_LIMIT = 12
"""Iterations for the densities after which they are taken as they are."""
CONVERGENCE_SHARE = 1e-3
"""The densities have converged when none changes by more than this share of itself."""
SMALLEST_FREEDOM = 1.0
"""Smallest degrees of freedom that an interval is computed with."""


@dataclass(frozen=True)
class Part:
    """Rows of one stretch without gap.

    Attributes:
        columns: (n,) of each term by its name; a term without a column is zero here.
        values: (n,) to be fitted.
        interval: length of a row, s.
        channel: name; parts of the same channel have the same noise densities.
    """

    columns: Mapping[str, Array]
    values: Array
    interval: float
    channel: str = ""

    def __len__(self) -> int:
        return len(self.values)

    def matrix(self, names: Sequence[str]) -> Array:
        """(n, m) columns in the order of the names."""
        zero = np.zeros(len(self))
        return np.column_stack([self.columns.get(name, zero) for name in names])

    def variances(self) -> tuple[Array, Array]:
        """(n,) variances of the sine-transformed rows for unit rate noise and unit angle noise."""
        return np.full(len(self), self.interval), compute_eigenvalues(len(self))


def compute_eigenvalues(count: int) -> Array:
    """(count,) eigenvalues of the tridiagonal matrix (2, -1), ordered as the sine transform."""
    return 2 - 2 * np.cos(np.pi * np.arange(1, count + 1) / (count + 1))


def fit_rows(parts: Sequence[Part], names: Sequence[str]) -> Fit:
    """Fit of common terms to all parts together; their degrees of freedom are Satterthwaite's."""
    values = np.concatenate([_transform(part.values) for part in parts])
    matrix = np.vstack([_transform(part.matrix(names)) for part in parts])
    scale = np.linalg.norm(matrix, axis=0)
    if len(values) < len(names) + 2:
        raise ValueError(f"{len(values)} rows can't determine {len(names)} terms and their scatter")
    if np.min(scale) == 0 or np.linalg.cond(matrix / scale) > 1e6:
        raise ValueError(f"terms {', '.join(names)} can't be separated by these rows")
    problem = _Problem(values, matrix / scale, _make_components(parts))
    densities, spread = problem.average_positive(problem.estimate_densities())
    solution, covariance, residual = problem.solve(densities)
    freedoms = problem.compute_freedoms(densities, spread)
    covariance = problem.widen(covariance, densities, spread)
    return Fit(
        tuple(names),
        solution / scale,
        covariance / np.outer(scale, scale),
        residual,
        int(max(SMALLEST_FREEDOM, np.min(freedoms))),
        freedoms,
    )


@dataclass(frozen=True)
class _Problem:
    """The fit after the sine transform.

    Attributes:
        values: (n,).
        matrix: (n, m) columns of the terms.
        components: (c, n) variance of each row per unit of each of the c densities.
    """

    values: Array
    matrix: Array
    components: Array

    def solve(self, densities: Array) -> tuple[Array, Array, Array]:
        """Terms (m,), their covariance (m, m) and the whitened residual (n,)."""
        weight = 1 / np.sqrt(densities @ self.components)
        q, r = np.linalg.qr(self.matrix * weight[:, None])
        inverse = np.linalg.inv(r)
        white = self.values * weight
        shares = q.T @ white
        residual = np.asarray(white - q @ shares)
        return np.asarray(inverse @ shares), np.asarray(inverse @ inverse.T), residual

    def estimate_densities(self) -> Array:
        """(c,) densities of maximum restricted likelihood, none negative."""
        ordinary = (
            self.values - self.matrix @ np.linalg.lstsq(self.matrix, self.values, rcond=None)[0]
        )
        # where there is no noise, the rounding of the values is the floor
        tiny = (1e-16 * float(np.sqrt(np.mean(self.values**2))) + 1e-40) ** 2
        own = self.components > 0
        means = np.array(
            [np.mean(ordinary[o] ** 2 / c[o]) for o, c in zip(own, self.components, strict=True)]
        )
        floor = np.maximum(1e-12 * means, tiny)
        densities = np.maximum(means / 2, floor)
        for _ in range(ITERATION_LIMIT):
            before = densities
            residual = self.solve(densities)[2]
            relative = self.components / (densities @ self.components)
            powers = relative @ residual**2
            densities = np.maximum(
                np.linalg.solve(self.compute_information(densities), powers), floor
            )
            if np.all(np.abs(densities - before) < CONVERGENCE_SHARE * before):
                break
        return densities

    def compute_information(self, densities: Array) -> Array:
        """(c, c) tr(P V_i P V_j): twice the Fisher information of the densities in the restricted
        likelihood."""
        variance = densities @ self.components
        relative = self.components / variance
        q = np.linalg.qr(self.matrix / np.sqrt(variance)[:, None])[0]
        inner = [(q * part[:, None]).T @ q for part in relative]
        count = range(len(relative))
        both = [
            [_compute_trace(q, relative[i], relative[j], inner[i], inner[j]) for j in count]
            for i in count
        ]
        return np.array(both)

    def average_positive(self, densities: Array) -> tuple[Array, Array]:
        """Mean (c,) and covariance (c, c) of the densities, given that none is negative: those of
        normal distributions about the estimates, truncated at zero."""
        covariance = 2 * np.linalg.inv(self.compute_information(densities))
        deviation = np.sqrt(np.diag(covariance))
        edge = -densities / deviation
        mean, variance = stats.truncnorm.stats(edge, np.inf, moments="mv")
        shrunk = np.sqrt(variance)
        spread = np.asarray(covariance * np.outer(shrunk, shrunk), dtype=np.float64)
        return np.asarray(densities + deviation * mean), spread

    def widen(self, covariance: Array, densities: Array, spread: Array) -> Array:
        """Covariance (m, m) of the terms, enlarged for the uncertainty of the weights (Kenward and
        Roger)."""
        variance = densities @ self.components
        relative = self.components / variance
        white = self.matrix / np.sqrt(variance)[:, None]
        once = [(white * part[:, None]).T @ white for part in relative]
        added = np.zeros_like(covariance)
        for i, first in enumerate(relative):
            for j, second in enumerate(relative):
                both = (white * (first * second)[:, None]).T @ white
                added += spread[i, j] * (both - once[i] @ covariance @ once[j])
        return np.asarray(covariance + 2 * covariance @ added @ covariance)

    def compute_freedoms(self, densities: Array, spread: Array) -> Array:
        """(m,) degrees of freedom of the terms: 2 v^2 over the variance of their variance v."""
        variance = densities @ self.components
        covariance = self.solve(densities)[1]
        weighted = (
            (self.matrix * (part / variance**2)[:, None]).T @ self.matrix
            for part in self.components
        )
        gradient = np.array([np.diag(covariance @ each @ covariance) for each in weighted])
        uncertain = np.einsum("im,ij,jm->m", gradient, spread, gradient)
        return np.maximum(2 * np.diag(covariance) ** 2 / uncertain, SMALLEST_FREEDOM)


def _compute_trace(
    q: Array, first: Array, second: Array, inner_first: Array, inner_second: Array
) -> float:
    both = np.sum(q**2 * (first * second)[:, None])
    return float(first @ second - 2 * both + np.sum(inner_first * inner_second.T))


def _make_components(parts: Sequence[Part]) -> Array:
    """(c, n) variances per unit of rate noise and of angle noise, for each channel."""
    channels = list(dict.fromkeys(part.channel for part in parts))
    rows = np.zeros((2 * len(channels), sum(len(part) for part in parts)))
    begin = 0
    for part in parts:
        own = 2 * channels.index(part.channel)
        rows[own : own + 2, begin : begin + len(part)] = part.variances()
        begin += len(part)
    return rows


def _transform(values: Array) -> Array:
    return np.asarray(dst(values, type=1, norm="ortho", axis=0))


def compute_inflations(parts: Sequence[Part], names: Sequence[str]) -> dict[str, float]:
    """Variance inflation factor (uncentred) of each term, see `compute_matrix_inflations`."""
    matrix = np.vstack([part.matrix(names) for part in parts])
    return dict(zip(names, compute_matrix_inflations(matrix), strict=True))


def compute_matrix_inflations(matrix: Array) -> list[float]:
    """Variance inflation factor (uncentred) of each of m columns (n, m); infinite where a column is
    zero or lies in the span of the others."""
    norms = np.linalg.norm(matrix, axis=0)
    matrix = np.asarray(np.linalg.qr(matrix, mode="r"))
    matrix = matrix / np.where(norms, norms, 1.0)
    result = []
    for i, own in enumerate(matrix.T):
        others = np.delete(matrix, i, axis=1)
        fitted = others @ np.linalg.lstsq(others, own, rcond=1e-10)[0]
        square = float(np.sum((own - fitted) ** 2))
        result.append(1 / square if square > 1e-9 else np.inf)
    return result
