"""Intervals of a length."""

import numpy as np
import pytest

from pyhrg.bench.estimation.magnitude import estimate_magnitude

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
