"""Intervals of a length, and of the largest of several means."""

import numpy as np
import pytest

from pyhrg.bench.estimation.sizes import estimate_largest, estimate_magnitude

REPEATS = 1000


@pytest.mark.parametrize("length", [0.0, 1.0, 3.0, 10.0, 300.0])
@pytest.mark.parametrize("sizes", [(1.0,) * 6, (1.0, 1.0, 1.0, 1.0, 0.5, 0.5)])
def test_intervals_cover(length: float, sizes: tuple[float, ...]) -> None:
    """950 +- 7 of 1000, 4 sigma; at length 0 one side of the interval only can miss: 975."""
    generator = np.random.default_rng(3)
    true = np.zeros(6)
    true[0] = length
    covariance = np.diag(np.square(sizes))
    hits = 0
    for _ in range(REPEATS):
        values = true + np.array(sizes) * generator.normal(size=6)
        _, low, high = estimate_magnitude(values, covariance)
        hits += low <= length <= high
    expected, deviation = (975, 5) if length == 0.0 else (950, 7)
    assert abs(hits - expected) <= 4 * deviation + 6  # 6: the approximation, 0.6 %


def test_noise_is_taken_off() -> None:
    value, low, high = estimate_magnitude(np.array([3.0, 4.0]), np.eye(2))
    assert value == pytest.approx(np.sqrt(23))
    assert low < value < high


def test_without_noise_it_is_the_length() -> None:
    assert estimate_magnitude(np.array([3.0, 4.0]), np.zeros((2, 2))) == (5.0, 5.0, 5.0)


@pytest.mark.parametrize("largest", [0.0, 3.0, 100.0])
def test_intervals_of_the_largest_cover(largest: float) -> None:
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
