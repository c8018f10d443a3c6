"""Bootstrap and permutation intervals over triads; a triad's missions and gyros stay together.

A statistic takes arrays (..., r, m, ...) of r triads and m missions, with any number of resamples
in front, and gives one number for each resample.
"""

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ins_eval.study.tables.score import Score
from pyhrg.common.arrays import Array

Statistic = Callable[..., Array]

CONFIDENCE = 0.95
DRAWS = 999
_MOST_NUMBERS = 4_000_000
"""Largest size of an array that is resampled at once; it bounds memory. Chosen."""


@dataclass(frozen=True)
class Estimate:
    """An estimate and the ends of its interval at `CONFIDENCE`."""

    value: float
    low: float
    high: float

    def score(self, **fields: Any) -> Score:
        """The score that this estimate gives; `fields` are the others of `Score`."""
        return Score(
            value=self.value, low=self.low, high=self.high, confidence=CONFIDENCE, **fields
        )


def bootstrap(
    statistic: Statistic, samples: Sequence[Array], seed: int, draws: int = DRAWS
) -> Estimate:
    """A statistic of samples (r, m, ...), and its percentile interval.

    Triads are drawn with replacement (Davison and Hinkley 1997, section 5.3.1; clusters: section
    3.8). Resamples whose statistic is NaN do not count.
    """
    value = float(statistic(*samples))
    chosen = np.random.default_rng(seed).integers(len(samples[0]), size=(draws, len(samples[0])))
    parts = [
        statistic(*(sample[rows] for sample in samples)) for rows in _split_rows(chosen, samples)
    ]
    return _make_estimate(value, np.concatenate(parts))


def shuffle_devices(
    statistic: Statistic, flown: Array, predicted: Sequence[Array], seed: int
) -> Estimate:
    """The negative control: the statistic when each triad has another triad's predictions.

    Args:
        flown: (r, m, ...) flown errors.
        predicted: (r, m, ...) each; all are permuted alike, and no triad keeps its own.

    Returns:
        mean over permutations, and the range that holds `CONFIDENCE` of them.

    Raises:
        ValueError: fewer than two triads.
    """
    if len(flown) < 2:
        raise ValueError(f"{len(flown)} triads: expected 2 or more to shuffle")
    chosen = _draw_derangements(len(flown), DRAWS, np.random.default_rng(seed))
    parts = []
    for rows in _split_rows(chosen, [flown, *predicted]):
        parts.append(statistic(flown[np.newaxis], *(sample[rows] for sample in predicted)))
    values = np.concatenate(parts)
    return _make_estimate(float(np.mean(values)), values)


def _draw_derangements(count: int, draws: int, random: np.random.Generator) -> NDArray[np.intp]:
    """(draws, count) permutations; each is one cycle through all in random order."""
    orders = np.argsort(random.random((draws, count)), axis=1)
    chosen = np.empty_like(orders)
    np.put_along_axis(chosen, orders, np.roll(orders, 1, axis=1), axis=1)
    return chosen


def _split_rows(chosen: NDArray[np.intp], samples: Sequence[Array]) -> Iterator[NDArray[np.intp]]:
    at_once = max(1, _MOST_NUMBERS // max(sample.size for sample in samples))
    for first in range(0, len(chosen), at_once):
        yield chosen[first : first + at_once]


def _make_estimate(value: float, values: Array) -> Estimate:
    tail = (1 - CONFIDENCE) / 2
    finite = values[np.isfinite(values)]
    low, high = np.quantile(finite, [tail, 1 - tail]) if len(finite) else (np.nan, np.nan)
    return Estimate(value, float(low), float(high))
