"""A figure of merit: estimate, 95 % interval and target."""

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Literal

import numpy as np
from scipy.stats import beta, binom

CONFIDENCE = 0.95
RESAMPLES = 400
"""Number of bootstrap resamples for an interval."""
Sense = Literal["at most", "at least", "about"]


@dataclass(frozen=True)
class Figure:
    """One figure, its 95 % interval, and its target; a figure without a case has no value.

    It passes when the interval includes the target, or is better.
    """

    name: str
    n: int
    value: float
    low: float
    high: float
    sense: Sense
    target: float

    @property
    def passed(self) -> bool | None:
        """Whether the target is met; None where there is no case."""
        if not self.n:
            return None
        meets_high, meets_low = self.low <= self.target, self.high >= self.target
        if self.sense == "at most":
            return meets_high
        return meets_low if self.sense == "at least" else meets_high and meets_low


def proportion(name: str, outcomes: Sequence[float], sense: Sense, target: float) -> Figure:
    """A share of cases, with the exact interval of C. Clopper and E. Pearson (1934); or a mean of
    numbers from 0 to 1, with the interval of a share of the same size, whose variance is larger."""
    n, hits = len(outcomes), sum(outcomes)
    if not n:
        return Figure(name, 0, math.nan, 0.0, 1.0, sense, target)
    tail = (1 - CONFIDENCE) / 2
    low = float(beta.ppf(tail, hits, n - hits + 1)) if hits else 0.0
    high = float(beta.isf(tail, hits + 1, n - hits)) if hits < n else 1.0
    return Figure(name, n, hits / n, low, high, sense, target)


def f1(name: str, right: int, wrong: int, target: float) -> Figure:
    """The F1 score, 2 r / (2 r + w), of r right names and w wrong or missing ones. The exact
    interval of the share r / (r + w) gives its own."""
    share = proportion(name, [True] * right + [False] * wrong, "at least", target)
    value, low, high = (2 * s / (1 + s) for s in (share.value, share.low, share.high))
    return replace(share, value=value, low=low, high=high)


def mean(name: str, values: Sequence[float], seed: int, sense: Sense, target: float) -> Figure:
    """A mean over campaigns, with its interval by resampling them (percentiles)."""
    if not values:
        return Figure(name, 0, math.nan, -math.inf, math.inf, sense, target)
    drawn = np.random.default_rng(seed).choice(values, (RESAMPLES, len(values))).mean(axis=1)
    tail = (1 - CONFIDENCE) / 2
    low, high = np.quantile(drawn, (tail, 1 - tail)).tolist()
    return Figure(name, len(values), float(np.mean(values)), low, high, sense, target)


def quantile(
    name: str, values: Sequence[float], share: float, sense: Sense, target: float
) -> Figure:
    """A quantile with its interval between order statistics, which holds for any distribution
    (W. Thompson, 1936). An end is infinite where there are too few values."""
    n = len(values)
    if not n:
        return Figure(name, 0, math.nan, -math.inf, math.inf, sense, target)
    ordered = np.sort(values)
    tail = (1 - CONFIDENCE) / 2
    below = int(binom.ppf(tail, n, share)) - 1
    above = int(binom.ppf(1 - tail, n, share))
    low = float(ordered[below]) if below >= 0 else -math.inf
    high = float(ordered[above]) if above < n else math.inf
    return Figure(name, n, float(np.quantile(ordered, share)), low, high, sense, target)
