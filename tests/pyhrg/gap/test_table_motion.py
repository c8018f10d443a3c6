"""Rates whose means over rows are the encoder's increments."""

import numpy as np
import pytest
from numpy.typing import NDArray

from pyhrg.gap.table_motion import rates_at_bounds

Array = NDArray[np.float64]


def angles(rates: Array, interval: float) -> Array:
    return np.asarray(np.cumsum((rates[1:] + rates[:-1]) / 2) * interval)


@pytest.mark.parametrize("n", [2, 3, 5])
def test_few_rows(n: int) -> None:
    rates = 0.1 * np.arange(n + 1.0)
    found = rates_at_bounds(angles(rates, 0.5), 0.5)
    np.testing.assert_allclose(angles(found, 0.5), angles(rates, 0.5), atol=1e-8)


@pytest.mark.parametrize("interval", [0.1, 1.0])
def test_a_smooth_profile_is_found(interval: float) -> None:
    time = np.arange(0, 200 + interval / 2, interval)
    rates = 0.3 * np.sin(2 * np.pi * time / 50) ** 2
    found = rates_at_bounds(angles(rates, interval), interval)
    np.testing.assert_allclose(found, rates, atol=1e-4)


def test_a_spin_that_is_reached_over_one_row_is_found() -> None:
    rates = np.concatenate([np.zeros(20), np.full(50, 0.09), np.zeros(30)])
    found = rates_at_bounds(angles(rates, 1.0), 1.0)
    np.testing.assert_allclose(angles(found, 1.0), angles(rates, 1.0), atol=1e-8)
    np.testing.assert_allclose(found[25:65], 0.09, atol=0.01)


def test_a_table_at_rest_has_no_rate() -> None:
    assert not rates_at_bounds(np.zeros(10), 1.0).any()
