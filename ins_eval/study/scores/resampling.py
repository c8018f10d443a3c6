"""Intervals over triads: a triad's missions and gyros stay together.

A statistic takes arrays (..., r, m, ...) whose triads are counted by the axis before missions,
with any number of resamples in front, and gives one number a resample.
"""

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
Statistic = Callable[..., Array]

CONFIDENCE = 0.95
DRAWS = 999
_ROOM = 4_000_000
"""Numbers of one array that are resampled at a time."""


@dataclass(frozen=True)
class Estimate:
    """A figure, and the ends of its interval with `CONFIDENCE`."""

    value: float
    low: float
    high: float


def bootstrapped(
    statistic: Statistic, samples: Sequence[Array], seed: int, draws: int = DRAWS
) -> Estimate:
    """A statistic of samples (r, m, ...), and its percentile interval over triads drawn with
    replacement (Davison and Hinkley 1997, section 5.3.1; clusters: section 3.8). Resamples that
    can't tell it, as NaN says, don't count."""
    value = float(statistic(*samples))
    chosen = np.random.default_rng(seed).integers(len(samples[0]), size=(draws, len(samples[0])))
    parts = [statistic(*(sample[rows] for sample in samples)) for rows in _parts(chosen, samples)]
    return _estimate(value, np.concatenate(parts))


def shuffled(
    statistic: Statistic, flown: Array, predicted: Sequence[Array], seed: int, draws: int = DRAWS
) -> Estimate:
    """The negative control: what the statistic is when triads get another's predictions.

    Args:
        statistic: of the flown and the predicted.
        flown: (r, m, ...).
        predicted: (r, m, ...) each; all shuffled alike, none stays in place.
        seed: of the shuffling.

    Returns:
        mean over shuffles, and the range that holds `CONFIDENCE` of them.

    Raises:
        ValueError: fewer than two triads.
    """
    if len(flown) < 2:
        raise ValueError(f"{len(flown)} triads: expected 2 or more to shuffle")
    chosen = _derangements(len(flown), draws, np.random.default_rng(seed))
    parts = []
    for rows in _parts(chosen, [flown, *predicted]):
        same = np.broadcast_to(flown, (len(rows), *flown.shape))
        parts.append(statistic(same, *(sample[rows] for sample in predicted)))
    values = np.concatenate(parts)
    return _estimate(float(np.mean(values)), values)


def _derangements(count: int, draws: int, random: np.random.Generator) -> NDArray[np.intp]:
    """(draws, count): each a cycle through all, in random order."""
    orders = np.argsort(random.random((draws, count)), axis=1)
    chosen = np.empty_like(orders)
    np.put_along_axis(chosen, orders, np.roll(orders, 1, axis=1), axis=1)
    return chosen


def _parts(chosen: NDArray[np.intp], samples: Sequence[Array]) -> Iterator[NDArray[np.intp]]:
    at_once = max(1, _ROOM // max(sample.size for sample in samples))
    for first in range(0, len(chosen), at_once):
        yield chosen[first : first + at_once]


def _estimate(value: float, values: Array) -> Estimate:
    tail = (1 - CONFIDENCE) / 2
    told = values[np.isfinite(values)]
    low, high = np.quantile(told, [tail, 1 - tail]) if len(told) else (np.nan, np.nan)
    return Estimate(value, float(low), float(high))
