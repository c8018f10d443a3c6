"""Statistics against simulation and exact counts."""

import numpy as np
import pytest
from scipy.stats import binom

from ins_eval.common.metrics import MIN_SAMPLE_FOR_MEDIAN, compute_paired_ratio, median_interval


@pytest.mark.parametrize("n", [6, 7, 8, 9, 15, 20, 21, 50, 101])
def test_median_interval_is_the_narrowest_that_holds_95_percent(n: int) -> None:
    low, high = median_interval(np.arange(n))
    assert low + high == n - 1
    rank = int(low)
    assert binom.cdf(rank, n, 0.5) <= 0.025 < binom.cdf(rank + 1, n, 0.5)


def test_too_few_for_an_interval() -> None:
    with pytest.raises(ValueError, match="5 values can't bound the median"):
        median_interval(np.arange(MIN_SAMPLE_FOR_MEDIAN - 1))


@pytest.mark.parametrize(("n", "factor"), [(6, 1.0), (16, 0.2)])
def test_interval_of_a_paired_ratio_holds_it(n: int, factor: float) -> None:
    """500 samples, seed 1, of radii whose halves are shared: 95 % within three deviations."""
    generator = np.random.default_rng(1)
    held = 0
    for _ in range(500):
        shared, own, other = generator.normal(size=(3, n, 2))
        ratio = compute_paired_ratio(
            factor * np.hypot(*(shared + own).T), np.hypot(*(shared + other).T)
        )
        held += ratio.low <= factor <= ratio.high
    assert held / 500 == pytest.approx(0.95, abs=3 * np.sqrt(0.95 * 0.05 / 500))


def test_paired_ratio_of_a_sample_to_itself_is_1() -> None:
    ratio = compute_paired_ratio([1.0, 2.0, 5.0], [1.0, 2.0, 5.0])
    assert (ratio.low, ratio.value, ratio.high) == (1.0, 1.0, 1.0)
