"""Intervals of the largest of several means."""

import numpy as np
import pytest

from pyhrg.bench.estimation.largest import estimate_largest

REPEATS = 1000


@pytest.mark.parametrize("largest", [0.0, 3.0, 100.0])
def test_intervals_cover(largest: float) -> None:
    """At least 950 - 4 sigma of 1000; with one mean that stands out no more than 950 + 4 sigma."""
    generator = np.random.default_rng(3)
    true = np.zeros(22)
    true[4] = -largest
    hits = 0
    for _ in range(REPEATS):
        value, low, high = estimate_largest(true + generator.normal(size=(7, 22)))
        assert low <= value <= high
        hits += low <= largest <= high
    assert hits >= 922
    if largest == 100.0:
        assert hits <= 978


def test_one_sample_has_no_interval() -> None:
    value, low, high = estimate_largest(np.array([[1.0, -3.0]]))
    assert value == 3.0
    assert np.isnan([low, high]).all()
