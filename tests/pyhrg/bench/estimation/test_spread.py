"""Deviation of values that differ by more than noise: coverage of its interval."""

import numpy as np
import pytest

from pyhrg.bench.estimation.sizes import estimate_excess, estimate_spread

FREEDOM = 12
"""Of the noise's estimate."""


@pytest.mark.parametrize("difference", [0.0, 0.5, 3.0, 1e4])
def test_interval_holds_the_deviation_in_the_mean_square(difference: float) -> None:
    """200 repeats, four sigma of the binomial about 95 %."""
    generator, means = np.random.default_rng(1), difference * np.arange(6)
    truth = np.sqrt(1 + np.var(means, ddof=1))
    noises = np.sqrt(generator.chisquare(FREEDOM, 200) / FREEDOM)
    values = means + generator.standard_normal((200, 6))
    found = [estimate_spread("", v, s, FREEDOM, "1") for v, s in zip(values, noises, strict=True)]
    share = np.mean([f.si_low <= truth <= f.si_high for f in found])
    assert share == pytest.approx(0.95, abs=0.062)
    assert all(f.si_low < f.si_value < f.si_high for f in found)


@pytest.mark.parametrize("size", [1e-3, 0.2, 1.0, 5.0, 1e3, 1e7])
def test_interval_holds_its_estimate(size: float) -> None:
    """Far below the noise as well, where noise alone should have made more."""
    found = estimate_spread("", size * np.array([-1.0, 0.0, 1.0]), 1.0, 30, "1")
    assert found.si_value == pytest.approx(size)
    assert 0 < found.si_low < size < found.si_high


def test_without_excess_the_interval_is_the_chi_square_one() -> None:
    found = estimate_spread("", [-0.1, 0.0, 0.1], 1.0, 30, "1")
    assert (found.si_low, found.si_high) == pytest.approx((0.0520661, 0.628468), rel=1e-4)


def test_far_above_noise_the_interval_is_that_of_a_normal_distance() -> None:
    """Student's quantile of 30 degrees of freedom is 2.0423; root mean square of 2 deviations."""
    found = estimate_spread("", [-1e3, 0.0, 1e3], 1.0, 30, "1")
    assert (found.si_high - found.si_low) / 2 == pytest.approx(2.0423 / np.sqrt(2), rel=1e-3)


def test_without_noise_there_is_no_interval() -> None:
    found = estimate_spread("", [1.0, 2.0], float("nan"), 5, "1")
    assert np.isnan(found.si_low)
    assert "no interval" in found.note


@pytest.mark.parametrize("excess", [0.0, 1.0, 10.0, 1e4])
def test_excess_interval_holds_the_deviation_of_the_means(excess: float) -> None:
    """200 repeats, four sigma of the binomial; without excess the high end never fails."""
    generator = np.random.default_rng(2)
    means = excess * np.sqrt(5 / 2) * np.array([-1.0, 0.0, 0.0, 0.0, 0.0, 1.0])
    squares = np.var(means + generator.standard_normal((200, 6)), axis=1, ddof=1)
    noises = np.sqrt(generator.chisquare(FREEDOM, 200) / FREEDOM)
    found = [
        estimate_excess("", square, noise, (5, FREEDOM), "1")
        for square, noise in zip(squares, noises, strict=True)
    ]
    share = np.mean([f.si_low <= excess <= f.si_high for f in found])
    assert share == pytest.approx(0.95 if excess else 0.975, abs=0.062 if excess else 0.045)
    assert all(f.si_low <= f.si_value <= f.si_high and f.si_high > 0 for f in found)
