"""Measures of errors whose statistics are known."""

from functools import partial

import numpy as np
import pytest

from ins_eval.study.scores import measures
from ins_eval.study.scores.resampling import Statistic
from pyhrg.common.arrays import Array

N = 100_000
RANDOM = np.random.default_rng(1)
KNOWN, REFERENCE, REST = RANDOM.normal(size=(3, N, 1))
FLOWN = 10 + 2 * REFERENCE + KNOWN + 0.5 * REST
"""Variance 5.25: a reference tells 4, what is known beyond 1, nobody 0.25."""


def test_r2_about_predicted_is_flown() -> None:
    """Within four sigmas of 1 - 0.25/5.25; a scale or an offset that is wrong counts."""
    predicted = FLOWN - 0.5 * REST
    assert measures.compute_r2(FLOWN, predicted) == pytest.approx(1 - 0.25 / 5.25, abs=2e-3)
    assert measures.compute_r2(FLOWN, FLOWN) == 1.0
    assert measures.compute_r2(FLOWN, np.full_like(FLOWN, FLOWN.mean())) == pytest.approx(
        0, abs=1e-12
    )
    offset = float(measures.compute_r2(FLOWN, FLOWN + 1))
    assert offset == pytest.approx(1 - 1 / FLOWN.var())


def test_r2_of_components_is_about_zero() -> None:
    flown = np.array([[[3.0, 4.0]], [[0.0, 5.0]]])
    assert measures.compute_component_r2(flown, np.zeros_like(flown)) == 0.0
    assert measures.compute_component_r2(flown, 0.9 * flown) == pytest.approx(0.99)


def test_shortfall_and_share_of_a_part() -> None:
    """The reference alone lacks what is known beyond: 1 of the variance of 5.25."""
    lacking = measures.compute_r2_gain(FLOWN, FLOWN - 0.5 * REST, 10 + 2 * REFERENCE)
    assert lacking == pytest.approx(1 / 5.25, abs=3e-3)
    flown, part = np.array([[[3.0, 4.0]]]), np.array([[[0.0, 1.0]]])
    assert measures.compute_power_share(flown, part) == pytest.approx(1 / 25)


def test_skill_is_the_share_of_the_interval_score_that_is_saved() -> None:
    """Intervals that are right save over those without knowledge the ratio of their sigmas, and
    nothing over themselves."""
    half = 1.6448536269514722

    def interval(middle: Array | float, sigma: float) -> list[Array]:
        return [middle + sigma * z + 0 * FLOWN for z in (-half, 0.0, half)]

    blind, reference = interval(10.0, np.sqrt(5.25)), interval(10 + 2 * REFERENCE, np.sqrt(1.25))
    found = measures.compute_skill(FLOWN, *reference, *blind, inside=0.9)
    assert found == pytest.approx(1 - np.sqrt(1.25 / 5.25), abs=0.01)
    assert measures.compute_skill(FLOWN, *blind, *blind, inside=0.9) == 0.0


def test_ratios() -> None:
    flown, predicted = np.array([[1.0], [2.0], [12.0]]), np.array([[1.0], [1.0], [2.0]])
    assert measures.compute_median_ratio(flown, predicted) == 2.0


def test_ranks() -> None:
    """Spearman's correlation of normal pairs is 6/pi asin(rho/2); a mission's scale is nothing."""
    rho, gyros = 0.6, RANDOM.normal(size=(N // 3, 1, 3))
    other = rho * gyros + np.sqrt(1 - rho**2) * RANDOM.normal(size=gyros.shape)
    expected = 6 / np.pi * np.arcsin(rho / 2)
    assert measures.compute_spearman(gyros, other) == pytest.approx(expected, abs=0.01)
    missions = np.exp(gyros) * np.array([1.0, 100.0])[:, None]
    assert measures.compute_spearman(missions, np.repeat(gyros, 2, axis=1)) == pytest.approx(1.0)


def test_ranks_of_single_flights() -> None:
    """Of triads within each mission, whatever its scale."""
    figure = np.exp(RANDOM.normal(size=(50, 1)))
    flown = figure**2 * np.array([1.0, 100.0])
    same = np.repeat(figure, 2, axis=1)
    assert measures.compute_flight_spearman(flown, same) == pytest.approx(1.0)
    assert measures.compute_flight_spearman(flown, -same) == pytest.approx(-1.0)
    assert measures.compute_flight_spearman_gain(flown, same, -same) == pytest.approx(2.0)


@pytest.mark.parametrize(
    ("measure", "count", "last"),
    [
        (measures.compute_r2, 2, ()),
        (measures.compute_component_r2, 2, (2,)),
        (measures.compute_median_ratio, 2, ()),
        (measures.compute_spearman, 2, (3,)),
        (measures.compute_flight_spearman, 2, ()),
        (measures.compute_flight_spearman_gain, 3, ()),
        (measures.compute_r2_gain, 3, ()),
        (partial(measures.compute_skill, inside=0.9), 7, ()),
    ],
)
def test_resamples_in_front_are_taken_one_by_one(
    measure: Statistic, count: int, last: tuple[int, ...]
) -> None:
    samples = np.exp(RANDOM.normal(size=(count, 5, 20, 3, *last)))
    together = measure(*samples)
    single = [measure(*samples[:, i]) for i in range(5)]
    np.testing.assert_allclose(together, single)


def test_a_sample_without_spread_tells_nothing() -> None:
    """As a resample may be: NaN, and no division by zero."""
    same = np.full((3, 1), 5.0)
    assert np.isnan(measures.compute_r2(same, 0.9 * same))
    assert np.isnan(measures.compute_spearman(np.ones((3, 1, 3)), np.ones((3, 1, 3))))
