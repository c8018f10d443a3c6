"""What may explain a record better than any noise term: the competitors.

Each is a distribution of the whitened coefficients beside the standard normal one, with its own
size marginalised, so that its evidence ratio to "white" is 1 or less on average where they are
white.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.fft import idct
from scipy.special import gammaln, logsumexp

Array = NDArray[np.float64]

SHAPES = np.geomspace(0.5, 2000.0, 13)
"""Of the inverse gamma distributions, mean about 1, that a variance's prior mixes evenly."""
LINE_POWERS = np.geomspace(3.0, 3e6, 13)
"""Variances of a line's coefficients over the noise's, evenly likely."""
BLOCKS = 16
"""Of time."""
LEAST = 8
"""Coefficients in a block of time that a change is looked for in."""


@dataclass(frozen=True)
class Unknown:
    """A competitor: name, coordinate as in a diagnosis, log of the evidence ratio to white noise;
    by frequency or time where it is looked for, the log ratios of the parts."""

    name: str
    coordinate: str
    log_ratio: float
    parts: Array


def octaves(m: int) -> list[slice]:
    """Of m coefficients, the fastest first; all that is slower than eight of them is the last."""
    edges = [m]
    while edges[-1] > 16:
        edges.append(edges[-1] // 2)
    return [slice(low, high) for high, low in zip(edges, [*edges[1:], 0], strict=True)]


def scale_ratio(power: Array, count: Array) -> Array:
    """Log evidence ratio that sums of `count` squares have a variance that is not 1.

    The variance has an inverse gamma distribution of equal shape and scale, the shape from `SHAPES`
    evenly; its marginal is in closed form.
    """
    a = SHAPES.reshape(-1, *[1] * np.ndim(power))
    half = np.asarray(count) / 2
    logs = (
        gammaln(a + half)
        - gammaln(a)
        + a * np.log(a)
        - (a + half) * np.log(a + power / 2)
        + power / 2
    )
    return np.asarray(logsumexp(logs, axis=0) - np.log(len(SHAPES)))


def _spiked(logs: Array) -> float:
    """Of independent parts, each of which is white with even odds."""
    return float(np.sum(np.logaddexp(0.0, logs) - np.log(2)))


def excess(white: Array) -> Unknown:
    """Power that is not as promised, octave by octave."""
    bands = octaves(len(white))
    power = np.array([np.sum(white[band] ** 2) for band in bands])
    parts = scale_ratio(power, np.array([band.stop - band.start for band in bands]))
    return Unknown("excess in the spectrum", "noise", _spiked(parts), parts)


def lines(white: Array) -> Unknown:
    """One periodic signal: two neighbouring coefficients that are too large, anywhere."""
    variance = 1 + LINE_POWERS[:, np.newaxis]
    power = white[1:] ** 2 + white[:-1] ** 2
    logs = -np.log(variance) + power / 2 * (1 - 1 / variance)
    parts = logsumexp(logs, axis=0) - np.log(len(LINE_POWERS))
    total = float(logsumexp(parts) - np.log(len(parts)))
    return Unknown("periodic signal", "time", total, parts)


def in_time(white: Array, band: slice) -> Array:
    """(k,) an octave's share of the record over time: as white as its coefficients are."""
    return np.asarray(idct(white[band], norm="ortho"))


def time_variation(white: Array) -> Unknown:
    """Power that changes over the record, in each octave by itself; its mean may be anything."""
    bands = [band for band in octaves(len(white)) if band.stop - band.start >= LEAST * BLOCKS]
    parts = np.array([_varying(in_time(white, band)) for band in bands])
    return Unknown("noise that changes with time", "time", _spiked(parts), parts)


def _varying(values: Array) -> float:
    blocks = np.array_split(values / np.sqrt(np.mean(values**2)), BLOCKS)
    power = np.array([np.sum(block**2) for block in blocks])
    count = np.array([len(block) for block in blocks])
    logs = [_shared(power, count, shape) for shape in SHAPES]
    return float(logsumexp(logs) - np.log(len(SHAPES)))


def _shared(power: Array, count: Array, a: float) -> float:
    """Of blocks whose variances are drawn from one inverse gamma distribution."""
    half = count / 2
    return float(
        np.sum(
            gammaln(a + half)
            - gammaln(a)
            + a * np.log(a)
            - (a + half) * np.log(a + power / 2)
            + power / 2
        )
    )


def competitors(white: Array) -> tuple[Unknown, ...]:
    """All of them, of (m,) whitened coefficients."""
    return excess(white), lines(white), time_variation(white)
