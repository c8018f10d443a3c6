"""Unknowns: explanations of a record that are no noise term (docs/methods/noise.md, Eq. 9 to 11).

Each unknown is an alternative to the standard normal distribution of the whitened coefficients,
with its size marginalised. Over white records its Bayes factor to "white" is 1 or less on average.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.fft import idct
from scipy.special import gammaln, logsumexp

Array = NDArray[np.float64]

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
    """An unknown explanation.

    name: of the explanation.
    coordinate: as in a diagnosis.
    log_ratio: natural logarithm of its Bayes factor to white noise.
    parts: the same for each octave or line that was examined.
    """

    name: str
    coordinate: str
    log_ratio: float
    parts: Array


def split_octaves(m: int) -> list[slice]:
    """Octaves of m coefficients from the highest frequencies down. The 16 or fewer slowest
    coefficients are one octave."""
    edges = [m]
    while edges[-1] > 16:
        edges.append(edges[-1] // 2)
    return [slice(low, high) for high, low in zip(edges, [*edges[1:], 0], strict=True)]


def compute_variance_log_ratio(power: Array, count: Array) -> Array:
    """Log Bayes factor of an unknown variance to a variance of 1, for sums of squares.

    The variance has an inverse gamma prior of equal shape and scale; the shapes are mixed with
    equal weights.

    Args:
        power: (...) sums of squares.
        count: (...) number of squares in each sum.
    """
    shapes = PRIOR_SHAPES.reshape(-1, *[1] * np.ndim(power))
    logs = _compute_log_marginal(power, count, shapes)
    return np.asarray(logsumexp(logs, axis=0) - np.log(len(PRIOR_SHAPES)))


def _compute_log_marginal(power: Array, count: Array, shape: Array | float) -> Array:
    """Log Bayes factor with one inverse gamma prior, in closed form (Eq. 9)."""
    half = np.asarray(count) / 2
    return np.asarray(
        gammaln(shape + half)
        - gammaln(shape)
        + shape * np.log(shape)
        - (shape + half) * np.log(shape + power / 2)
        + power / 2
    )


def _combine_parts(logs: Array) -> float:
    """Log Bayes factor of independent parts, each of which is white with probability 1/2."""
    return float(np.sum(np.logaddexp(0.0, logs) - np.log(2)))


def assess_excess(white: Array) -> Unknown:
    """Power that differs from the noise model, octave by octave."""
    bands = split_octaves(len(white))
    power = np.array([np.sum(white[band] ** 2) for band in bands])
    parts = compute_variance_log_ratio(power, np.array([band.stop - band.start for band in bands]))
    return Unknown("excess in the spectrum", "noise", _combine_parts(parts), parts)


def assess_line(white: Array) -> Unknown:
    """One periodic signal: two neighbouring coefficients that are too large, at any frequency
    (Eq. 10)."""
    variance = 1 + LINE_POWERS[:, np.newaxis]
    power = white[1:] ** 2 + white[:-1] ** 2
    logs = -np.log(variance) + power / 2 * (1 - 1 / variance)
    parts = logsumexp(logs, axis=0) - np.log(len(LINE_POWERS))
    total = float(logsumexp(parts) - np.log(len(parts)))
    return Unknown("periodic signal", "time", total, parts)


def transform_to_time(white: Array, band: slice) -> Array:
    """(k,) an octave as a time series. The transform is orthonormal, so it is white if the
    coefficients are."""
    return np.asarray(idct(white[band], norm="ortho"))


def assess_time_variation(white: Array) -> Unknown:
    """Power that changes over the record, in each octave by itself; its mean is free (Eq. 11)."""
    bands = [
        band
        for band in split_octaves(len(white))
        if band.stop - band.start >= MIN_COEFFICIENTS * TIME_BLOCKS
    ]
    parts = np.array([_compute_time_log_ratio(transform_to_time(white, band)) for band in bands])
    return Unknown("noise that changes with time", "time", _combine_parts(parts), parts)


def _compute_time_log_ratio(values: Array) -> float:
    blocks = np.array_split(values / np.sqrt(np.mean(values**2)), TIME_BLOCKS)
    power = np.array([np.sum(block**2) for block in blocks])
    count = np.array([len(block) for block in blocks])
    # the variances of all blocks are drawn from one inverse gamma distribution
    logs = [float(np.sum(_compute_log_marginal(power, count, shape))) for shape in PRIOR_SHAPES]
    return float(logsumexp(logs) - np.log(len(PRIOR_SHAPES)))


def assess_unknowns(white: Array) -> tuple[Unknown, ...]:
    """All unknowns of (m,) whitened coefficients."""
    return assess_excess(white), assess_line(white), assess_time_variation(white)
