"""Coverage of intervals that are right, and of those that aren't."""

import numpy as np
import pytest
from scipy.stats import binomtest

from ins_eval.study.scores.coverage import estimate_coverage

RANDOM = np.random.default_rng(1)
QUANTILES = -np.log([0.95, 0.05])
"""Of an exponential distribution: 90 % lie between."""


def test_exact_binomial_over_triads() -> None:
    """Ten missions of a triad that are all alike count once."""
    flown = np.repeat(RANDOM.exponential(size=(200, 1)), 10, axis=1)
    low, high = (np.full_like(flown, q) for q in QUANTILES)
    inside = int(np.sum((flown[:, 0] >= QUANTILES[0]) & (flown[:, 0] <= QUANTILES[1])))
    found = estimate_coverage(flown, low, high, seed=1)
    interval = binomtest(inside, 200).proportion_ci(0.95)
    assert (found.value, found.low, found.high) == (inside / 200, interval.low, interval.high)


def test_right_intervals_are_found_right() -> None:
    """In 95 % of experiments or a little more; of 200, at least 183 (one in 10^3)."""
    held = 0
    for seed in range(200):
        flown = RANDOM.exponential(size=(150, 3))
        low, high = (np.full_like(flown, q) for q in QUANTILES)
        found = estimate_coverage(flown, low, high, seed)
        held += found.low <= 0.9 <= found.high
    assert held >= 183


@pytest.mark.parametrize("width", [0.7, 1.4])
def test_wrong_intervals_are_found_wrong(width: float) -> None:
    flown = RANDOM.exponential(size=(1000, 3))
    middle, half = np.mean(QUANTILES), width * np.ptp(QUANTILES) / 2
    found = estimate_coverage(
        flown, np.full_like(flown, middle - half), np.full_like(flown, middle + half), 1
    )
    assert not found.low <= 0.9 <= found.high
