"""Least squares on a log's rows, which are white noise plus differences of white noise.

Increments of an angle are: white rate noise adds to each, white angle noise is subtracted from the
next one again. Means of a loop's force or frequency are as well. Over a stretch of n rows without
gap the covariance q h I + r (2, -1 tridiagonal) is diagonal in sines (discrete sine transform I),
with eigenvalues q h + r (2 - 2 cos(pi j / (n + 1))), so that generalised least squares costs no
more than a transform. The ratio of the two noises is estimated from the residuals.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.fft import dst
from scipy.optimize import minimize_scalar

from pyhrg.bench.harmonics import Fit, fit

Array = NDArray[np.float64]

TURNS = 3
"""Of estimating noise and terms in turn: the ratio of noises hardly depends on the terms."""
RATIOS = (-16.0, 12.0)
"""Range of the logarithm of r over q 1 s: all rate noise to all angle noise."""


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


def row_fit(parts: Sequence[Part], names: Sequence[str]) -> Fit:
    """Fit terms to all parts together; residuals of the result are whitened.

    Raises:
        ValueError: fewer rows than terms and one more, or terms that can't be told apart.
    """
    noise = dict.fromkeys({part.channel for part in parts}, (1.0, 0.0))
    found = _fit(parts, names, noise)
    for _ in range(TURNS):
        for channel in noise:
            own = [part for part in parts if part.channel == channel]
            noise[channel] = _noise(own, [_residual(part, found) for part in own])
        found = _fit(parts, names, noise)
    return found


def inflations(parts: Sequence[Part], names: Sequence[str]) -> dict[str, float]:
    """Factor by which the other terms inflate each term's variance; infinite where a term lies in
    their span or is zero (variance inflation factor, uncentred)."""
    matrix = np.vstack([_matrix(part, names) for part in parts])
    norms = np.linalg.norm(matrix, axis=0)
    matrix = np.linalg.qr(matrix, mode="r")
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


def _fit(
    parts: Sequence[Part], names: Sequence[str], noise: Mapping[str, tuple[float, float]]
) -> Fit:
    columns, values = [], []
    for part in parts:
        weight = np.sqrt(_spectrum(part, *noise[part.channel]))[:, None]
        both = np.column_stack([_matrix(part, names), part.values])
        white = _sines(both) / weight
        columns.append(white[:, :-1])
        values.append(white[:, -1])
    stacked = np.vstack(columns)
    return fit(dict(zip(names, stacked.T, strict=True)), np.concatenate(values))


def _matrix(part: Part, names: Sequence[str]) -> Array:
    zero = np.zeros(len(part))
    return np.column_stack([part.columns.get(name, zero) for name in names])


def _residual(part: Part, found: Fit) -> Array:
    return np.asarray(part.values - _matrix(part, found.names) @ found.values)


def _sines(values: Array) -> Array:
    return np.asarray(dst(values, type=1, norm="ortho", axis=0))


def _spectrum(part: Part, rate: float, angle: float) -> Array:
    """(n,) variances in sines, of a rate noise per second and an angle noise per reading."""
    n = len(part)
    return np.asarray(
        rate * part.interval + angle * (2 - 2 * np.cos(np.pi * np.arange(1, n + 1) / (n + 1)))
    )


def _noise(parts: Sequence[Part], residuals: Sequence[Array]) -> tuple[float, float]:
    """Rate noise and angle noise (units of the values, squared) of greatest likelihood."""
    powers = np.concatenate([_sines(residual) ** 2 for residual in residuals])
    if not np.any(powers):
        return 1.0, 0.0

    def shape(ratio: float) -> Array:
        return np.concatenate([_spectrum(part, 1.0, np.exp(ratio)) for part in parts])

    def unlikely(ratio: float) -> float:
        spectrum = shape(ratio)
        return float(np.log(np.mean(powers / spectrum)) + np.mean(np.log(spectrum)))

    ratio = float(minimize_scalar(unlikely, bounds=RATIOS, method="bounded").x)
    size = float(np.mean(powers / shape(ratio)))
    return size, size * float(np.exp(ratio))
