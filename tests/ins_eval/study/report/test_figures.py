"""The figures that the report works out itself: the budget."""

from dataclasses import astuple

import numpy as np
import pandas as pd
import pytest
from scipy.stats import binom

from ins_eval.study.report.figures.budget import compute_shares, estimate_rms
from ins_eval.study.tables import columns as c


def flights(triads: int, missions: int, seed: int) -> pd.DataFrame:
    """North and east standard normal: a radial rms of sqrt 2."""
    generator = np.random.default_rng(seed)
    return pd.DataFrame(
        {
            c.TRIAD: np.repeat(np.arange(triads), missions),
            "north": generator.standard_normal(triads * missions),
            "east": generator.standard_normal(triads * missions),
        }
    )


def test_rms_is_that_of_the_radial_error() -> None:
    rows = pd.DataFrame({c.TRIAD: [0, 1], "north": [3.0, 0.0], "east": [4.0, 5.0]})
    assert estimate_rms(rows, "north", "east").value == pytest.approx(5.0)


def test_rms_intervals_hold_the_truth_as_often_as_they_say() -> None:
    n = 300
    found = [estimate_rms(flights(200, 2, seed), "north", "east") for seed in range(n)]
    held = sum(r.low <= np.sqrt(2) <= r.high for r in found)
    low, high = binom.ppf([0.005, 0.995], n, 0.95)
    assert low <= held <= high


def test_flights_of_one_triad_count_as_one() -> None:
    single = flights(60, 1, seed=1)
    copied = pd.concat([single] * 4)
    found, expected = estimate_rms(copied, "north", "east"), estimate_rms(single, "north", "east")
    assert astuple(found) == pytest.approx(astuple(expected))


def test_shares_add_up() -> None:
    rows = flights(50, 1, seed=2)
    part = estimate_rms(rows, "north", "east")
    held = compute_shares({"map": part, "noise": part})
    assert held == {"map": 0.5, "noise": 0.5}
