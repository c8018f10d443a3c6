"""Deviation of values that differ by more than noise: coverage of its interval."""

import numpy as np
import pytest

from pyhrg.bench.estimation.spread import spread_finding


@pytest.mark.parametrize("difference", [0.0, 0.5, 3.0, 1e4])
def test_interval_holds_the_deviation_in_the_mean_square(difference: float) -> None:
    """200 repeats, four sigma of the binomial; without difference the low end never fails."""
    generator, means = np.random.default_rng(1), difference * np.arange(6)
    truth = np.sqrt(1 + np.var(means, ddof=1))
    found = [spread_finding("", means + generator.standard_normal(6), 1.0, "1") for _ in range(200)]
    share = np.mean([f.low <= truth <= f.high for f in found])
    assert share == pytest.approx(0.95 if difference else 0.975, abs=0.062 if difference else 0.045)


def test_without_noise_there_is_no_interval() -> None:
    found = spread_finding("", [1.0, 2.0], float("nan"), "1")
    assert np.isnan(found.low)
    assert "no interval" in found.note


def test_a_deviation_below_the_noise_is_said_to_be() -> None:
    found = spread_finding("", [1.0, 1.1, 1.05], 1.0, "1")
    assert found.value < found.low
    assert "less than noise alone" in found.note
