"""Least squares on a log's rows, which are white noise plus differences of white noise.

Increments of an angle are: white rate noise adds to each, white angle noise is subtracted from the
next one again. Means of a loop's force or frequency are as well. Over a stretch of n rows without
gap the covariance q h I + r (2, -1 tridiagonal) is diagonal in sines (discrete sine transform I),
with eigenvalues q h + r (2 - 2 cos(pi j / (n + 1))), so that generalised least squares costs no
more than a transform.

Densities q and r are estimated by restricted maximum likelihood (iterated MINQUE: C. R. Rao 1971;
Searle, Casella and McCulloch, Variance Components, 1992, ch. 11). Where a record is too short to
show q, its estimate is uncertain and may be zero: each is replaced by its mean over positive values
and the intervals get Satterthwaite's degrees of freedom. Weights that are estimated cost precision
too (M. G. Kenward, J. H. Roger, Biometrics 53, 1997).
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy import stats
from scipy.fft import dst

from pyhrg.bench.estimation.harmonics import Fit

Array = NDArray[np.float64]

ROUNDS = 12
SETTLED = 1e-3
"""The densities' iteration is done when none changes by more than this share."""
FEWEST_FREEDOM = 1.0


@dataclass(frozen=True)
class Part:
    """Rows of one stretch without gap.

    columns: (n,) of each term by its name; a term that is missing is zero.
    values: (n,) what is to be fitted.
    interval: of a row, s.
    channel: parts of the same channel share their noise.
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
        """(n,) variances in sines for unit rate noise and unit angle noise."""
        n = len(self)
        share = np.pi * np.arange(1, n + 1) / (n + 1)
        unit_angle: Array = 2 - 2 * np.cos(share)
        return np.full(n, self.interval), unit_angle


@dataclass(frozen=True)
class RowFit(Fit):
    """Generalised least squares, with degrees of freedom for each term.

    freedoms: (m,) after Satterthwaite; `freedom` is the least of them.
    """

    freedoms: Array

    def freedom_of(self, *names: str) -> float:
        """Of the terms, the least."""
        return float(min(self.freedoms[self.names.index(name)] for name in names))

    def interval(self, name: str, confidence: float = 0.95) -> tuple[float, float]:
        """Student's interval of one term."""
        reach = float(stats.t.ppf((1 + confidence) / 2, self.freedom_of(name)))
        reach *= self.deviation(name)
        return self.value(name) - reach, self.value(name) + reach


def row_fit(parts: Sequence[Part], names: Sequence[str]) -> RowFit:
    """Fit terms to all parts together; residuals of the result are whitened.

    Raises:
        ValueError: fewer rows than terms and two more, or terms that can't be told apart.
    """
    values = np.concatenate([_sines(part.values) for part in parts])
    matrix = np.vstack([_sines(part.matrix(names)) for part in parts])
    scale = np.linalg.norm(matrix, axis=0)
    if len(values) < len(names) + 2:
        raise ValueError(f"{len(values)} rows can't determine {len(names)} terms and their scatter")
    if np.min(scale) == 0 or np.linalg.cond(matrix / scale) > 1e6:
        raise ValueError(f"terms {', '.join(names)} can't be told apart by these rows")
    problem = _Problem(values, matrix / scale, _components(parts))
    densities = problem.likely()
    densities, spread = problem.positive(densities)
    solution, covariance, residual = problem.solved(densities)
    freedoms = problem.freedoms(densities, spread)
    covariance = problem.widened(covariance, densities, spread)
    return RowFit(
        tuple(names),
        solution / scale,
        covariance / np.outer(scale, scale),
        residual,
        int(max(FEWEST_FREEDOM, np.min(freedoms))),
        freedoms,
    )


@dataclass(frozen=True)
class _Problem:
    """In sines: values (n,), matrix (n, m), and components (c, n): the variances' parts."""

    values: Array
    matrix: Array
    components: Array

    def solved(self, densities: Array) -> tuple[Array, Array, Array]:
        """Terms, their covariance, and the whitened residual."""
        weight = 1 / np.sqrt(densities @ self.components)
        q, r = np.linalg.qr(self.matrix * weight[:, None])
        inverse = np.linalg.inv(r)
        white = self.values * weight
        shares = q.T @ white
        residual = np.asarray(white - q @ shares)
        return np.asarray(inverse @ shares), np.asarray(inverse @ inverse.T), residual

    def likely(self) -> Array:
        """(c,) densities of greatest restricted likelihood, none negative."""
        left = self.values - self.matrix @ np.linalg.lstsq(self.matrix, self.values, rcond=None)[0]
        # floor: rounding of the values, where there is no noise
        tiny = (1e-16 * float(np.sqrt(np.mean(self.values**2))) + 1e-40) ** 2
        own = self.components > 0
        means = np.array(
            [np.mean(left[o] ** 2 / c[o]) for o, c in zip(own, self.components, strict=True)]
        )
        floor = np.maximum(1e-12 * means, tiny)
        densities = np.maximum(means / 2, floor)
        for _ in range(ROUNDS):
            before = densities
            residual = self.solved(densities)[2]
            relative = self.components / (densities @ self.components)
            powers = relative @ residual**2
            densities = np.maximum(np.linalg.solve(self.information(densities), powers), floor)
            if np.all(np.abs(densities - before) < SETTLED * before):
                break
        return densities

    def information(self, densities: Array) -> Array:
        """(c, c) tr(P V_i P V_j), twice the restricted information of the densities."""
        variance = densities @ self.components
        relative = self.components / variance
        q = np.linalg.qr(self.matrix / np.sqrt(variance)[:, None])[0]
        inner = [(q * part[:, None]).T @ q for part in relative]
        count = range(len(relative))
        both = [
            [_trace(q, relative[i], relative[j], inner[i], inner[j]) for j in count] for i in count
        ]
        return np.array(both)

    def positive(self, densities: Array) -> tuple[Array, Array]:
        """Mean and covariance (c, c) of the densities, given that none is negative: of a normal
        distribution about the estimate that is cut off at zero."""
        covariance = 2 * np.linalg.inv(self.information(densities))
        deviation = np.sqrt(np.diag(covariance))
        edge = -densities / deviation
        mean, variance = stats.truncnorm.stats(edge, np.inf, moments="mv")
        shrunk = np.sqrt(variance)
        spread = np.asarray(covariance * np.outer(shrunk, shrunk), dtype=np.float64)
        return np.asarray(densities + deviation * mean), spread

    def widened(self, covariance: Array, densities: Array, spread: Array) -> Array:
        """Covariance (m, m) of the terms with what the weights' uncertainty adds."""
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

    def freedoms(self, densities: Array, spread: Array) -> Array:
        """(m,) of the terms: 2 v^2 over the variance of v, their variance."""
        variance = densities @ self.components
        covariance = self.solved(densities)[1]
        slopes = []
        for part in self.components:
            weighted = (self.matrix * (part / variance**2)[:, None]).T @ self.matrix
            slopes.append(np.diag(covariance @ weighted @ covariance))
        gradient = np.array(slopes)
        uncertain = np.einsum("im,ij,jm->m", gradient, spread, gradient)
        return np.maximum(2 * np.diag(covariance) ** 2 / uncertain, FEWEST_FREEDOM)


def _trace(q: Array, first: Array, second: Array, inner_first: Array, inner_second: Array) -> float:
    both = np.sum(q**2 * (first * second)[:, None])
    return float(first @ second - 2 * both + np.sum(inner_first * inner_second.T))


def _components(parts: Sequence[Part]) -> Array:
    """(c, n) rate noise and angle noise of each channel."""
    channels = list(dict.fromkeys(part.channel for part in parts))
    rows = np.zeros((2 * len(channels), sum(len(part) for part in parts)))
    begin = 0
    for part in parts:
        own = 2 * channels.index(part.channel)
        rows[own : own + 2, begin : begin + len(part)] = part.variances()
        begin += len(part)
    return rows


def _sines(values: Array) -> Array:
    return np.asarray(dst(values, type=1, norm="ortho", axis=0))


def inflations(parts: Sequence[Part], names: Sequence[str]) -> dict[str, float]:
    """Factor by which the other terms inflate each term's variance; infinite where a term lies in
    their span or is zero (variance inflation factor, uncentred)."""
    matrix = np.vstack([part.matrix(names) for part in parts])
    norms = np.linalg.norm(matrix, axis=0)
    matrix = np.asarray(np.linalg.qr(matrix, mode="r"))
    result = {}
    for i, name in enumerate(names):
        if norms[i] == 0.0:
            result[name] = np.inf
            continue
        rest = np.delete(matrix / np.where(norms, norms, 1.0), i, axis=1)
        own = matrix[:, i] / norms[i]
        left = float(np.sum((own - rest @ np.linalg.lstsq(rest, own, rcond=1e-10)[0]) ** 2))
        result[name] = 1 / left if left > 1e-9 else np.inf
    return result
