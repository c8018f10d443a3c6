"""Unknowns: explanations of a record that are no noise term (docs/methods/noise.md, Eq. 9 to 11).

Each unknown is an alternative to the standard normal distribution of the whitened coefficients,
with its size marginalised. Over white records its Bayes factor to "white" is 1 or less on average.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from scipy.fft import idct
from scipy.special import gammaln, logsumexp

from pyhrg.common.arrays import Array

PRIOR_SHAPES = np.geomspace(0.5, 2000.0, 13)
"""Shapes of the inverse gamma distributions, mean about 1, that the prior of a variance mixes with
equal weights (chosen)."""
LINE_POWERS = np.geomspace(3.0, 3e6, 13)
"""Variances of a line's two coefficients over that of the noise, with equal prior weights
(chosen)."""
TIME_BLOCKS = 16
"""Blocks of time whose powers are compared (chosen)."""
MIN_COEFFICIENTS = 8
"""Smallest number of coefficients in a block of time (chosen)."""


@dataclass(frozen=True)
class Unknown:
    """An unknown explanation, its coordinate as in a diagnosis, and the natural logarithm of its
    Bayes factor to white noise."""

    name: str
    coordinate: str
    log_ratio: float


def split_octaves(m: int) -> list[slice]:
    """Octaves of m coefficients from the highest frequencies down. The 16 or fewer slowest
    coefficients are one octave."""
    edges = [m]
    while edges[-1] > 16:
        edges.append(edges[-1] // 2)
    return [slice(low, high) for high, low in zip(edges, [*edges[1:], 0], strict=True)]


def sum_octaves(coefficients: Array) -> tuple[Array, Array]:
    """(k,) sum of squares of the coefficients in each octave, and (k,) their number."""
    bands = split_octaves(len(coefficients))
    power = np.array([np.sum(coefficients[band] ** 2) for band in bands])
    return power, np.array([band.stop - band.start for band in bands])


def assess_unknowns(white: Array) -> tuple[Unknown, ...]:
    """All unknowns of (m,) whitened coefficients."""
    return _assess_excess(white), _assess_line(white), _assess_time_variation(white)


def _assess_excess(white: Array) -> Unknown:
    """Power that differs from the noise model, octave by octave."""
    parts = average_logs(_compute_log_marginals(*sum_octaves(white)))
    return Unknown("excess in the spectrum", "noise", _combine_parts(parts))


def _assess_line(white: Array) -> Unknown:
    """One periodic signal: two neighbouring coefficients that are too large, at any frequency
    (Eq. 10)."""
    variance = 1 + LINE_POWERS[:, np.newaxis]
    power = white[1:] ** 2 + white[:-1] ** 2
    logs = -np.log(variance) + power / 2 * (1 - 1 / variance)
    return Unknown("periodic signal", "time", float(average_logs(average_logs(logs))))


def _assess_time_variation(white: Array) -> Unknown:
    """Power that changes over the record, in each octave by itself; its mean is free (Eq. 11)."""
    bands = [
        band
        for band in split_octaves(len(white))
        if band.stop - band.start >= MIN_COEFFICIENTS * TIME_BLOCKS
    ]
    # the transform is orthonormal, so an octave's time series is white if its coefficients are
    parts = [_compute_time_log_ratio(idct(white[band], norm="ortho")) for band in bands]
    return Unknown("noise that changes with time", "time", _combine_parts(np.array(parts)))


def _compute_time_log_ratio(values: Array) -> float:
    """Log Bayes factor of blocks of time whose variances are drawn from one inverse gamma
    distribution."""
    blocks = np.array_split(values / np.sqrt(np.mean(values**2)), TIME_BLOCKS)
    power = np.array([np.sum(block**2) for block in blocks])
    count = np.array([len(block) for block in blocks])
    return float(average_logs(np.sum(_compute_log_marginals(power, count), axis=1)))


def _compute_log_marginals(power: Array, count: Array) -> Array:
    """(13, k) log Bayes factors of k unknown variances to variances of 1, for sums of `count`
    squares: in closed form for an inverse gamma prior of each shape and of equal scale (Eq. 9)."""
    shape, half = PRIOR_SHAPES[:, np.newaxis], count / 2
    return np.asarray(
        gammaln(shape + half)
        - gammaln(shape)
        + shape * np.log(shape)
        - (shape + half) * np.log(shape + power / 2)
        + power / 2
    )


def average_logs(logs: Array | Sequence[float | Array]) -> Array:
    """Logarithm of the mean over the first axis, of numbers by their logarithms."""
    return np.asarray(logsumexp(logs, axis=0) - np.log(len(logs)))


def _combine_parts(logs: Array) -> float:
    """Log Bayes factor of independent parts, each of which is white with probability 1/2."""
    return float(np.sum(np.logaddexp(0.0, logs) - np.log(2)))
