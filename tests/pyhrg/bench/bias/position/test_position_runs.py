"""Within and between positions of made-up data points."""

from dataclasses import replace

import numpy as np
import pytest

from pyhrg.bench.bias.position.positions import (
    describe_leakage,
    estimate_between,
    estimate_within,
)
from pyhrg.bench.estimation.harmonics import Fit, fit
from pyhrg.bench.readings.segments import Points
from tests.pyhrg.bench.cases import make_points


def run(rates: list[list[float]]) -> Points:
    """Of rates by position."""
    count = [len(group) for group in rates]
    rate = np.concatenate([np.array(group) for group in rates])
    return make_points(rate, np.repeat(np.arange(len(rates)), count))


def means(runs: list[Points]) -> list[Fit]:
    """Fits by nothing but a mean."""
    return [fit({"mean": np.ones(len(one))}, one.rate) for one in runs]


def test_variances_of_an_analysis_by_hand() -> None:
    """Means 0 and 4, variance 2 within: between 8 - 2/2; the mean alone doesn't fit."""
    runs = [run([[-1.0, 1.0], [3.0, 5.0]])]
    within, between = (
        estimate_within("within", runs),
        estimate_between("between", runs, means(runs)),
    )
    assert within.si_value == pytest.approx(np.sqrt(2))
    assert between.si_value == pytest.approx(np.sqrt(7))
    assert within.si_low < within.si_value < within.si_high
    assert between.si_low < between.si_value < between.si_high


def test_drift_within_positions_is_not_noise() -> None:
    """Points 10 apart in each position, as the fitted line says; the means 5 apart."""
    runs = [run([[0.0, 10.1], [5.0, 14.9], [10.0, 20.1], [15.0, 24.9]])]
    drift, step = np.tile([0.0, 1.0], 4), np.repeat(np.arange(4.0), 2)
    line = fit({"mean": np.ones(8), "drift": drift, "step": step}, runs[0].rate)
    found = estimate_between("between", runs, [line])
    assert found.si_value == pytest.approx(5 * np.sqrt(5 / 3), rel=0.01)
    assert found.si_high - found.si_low < 0.5


def test_equal_positions_differ_by_zero() -> None:
    """Negative control: the interval holds zero."""
    runs = [run(np.random.default_rng(4).standard_normal((16, 3)).tolist())]
    found = estimate_between("between", runs, means(runs))
    assert found.si_low == 0.0
    assert 0 < found.si_high < 2


def test_one_point_a_position_has_no_scatter_within() -> None:
    found = estimate_within("within", [run([[0.0], [4.0]])])
    assert np.isnan(found.si_value)
    assert "can't be separated" in found.note


@pytest.mark.parametrize(
    ("step", "share"), [(168.75, 0.0), (45.0, 0.0), (90.0, 1.0), (105.0, 0.108)]
)
def test_leakage_of_the_fourth_harmonic_into_the_mean(step: float, share: float) -> None:
    """Sixteen steps of 60 deg of the harmonic's phase leave sin 120 / (16 sin 30) deg of it."""
    points = replace(run([[0.0]] * 16), pattern_angle=np.radians(step) * np.arange(16))
    told = describe_leakage(points)
    assert f"{share:.0%}" in told if share else not told
