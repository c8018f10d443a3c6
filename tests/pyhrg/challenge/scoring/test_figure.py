"""Figures and their exact intervals."""

import math

import numpy as np
import pytest
from scipy.stats import binom

from pyhrg.challenge.scoring.figure import proportion, quantile


@pytest.mark.parametrize(("hits", "n"), [(0, 20), (3, 20), (19, 20), (20, 20)])
def test_ends_are_where_the_binomial_leaves_a_tail(hits: int, n: int) -> None:
    figure = proportion("", [i < hits for i in range(n)], "at most", 0.1)
    if hits:
        assert binom.sf(hits - 1, n, figure.low) == pytest.approx(0.025)
    if hits < n:
        assert binom.cdf(hits, n, figure.high) == pytest.approx(0.025)
    assert figure.low <= hits / n <= figure.high


def test_interval_covers_at_least_as_often_as_it_says() -> None:
    generator, true, covered = np.random.default_rng(1), 0.07, []
    for _ in range(400):
        figure = proportion("", (generator.random(60) < true).tolist(), "about", true)
        covered.append(figure.passed is True)
    assert sum(covered) >= binom.ppf(1e-4, 400, 0.95)


@pytest.mark.parametrize(
    ("hits", "sense", "target", "passed"),
    [
        (6, "at most", 0.02, True),
        (20, "at most", 0.02, False),
        (0, "at most", 0.02, True),
        (280, "at least", 0.95, True),
        (250, "at least", 0.95, False),
        (300, "about", 0.95, False),
        (285, "about", 0.95, True),
    ],
)
def test_passes_where_the_interval_includes_the_target_or_is_better(
    hits: int, sense: str, target: float, passed: bool
) -> None:
    outcomes = [i < hits for i in range(300)]
    assert proportion("", outcomes, sense, target).passed is passed  # type: ignore[arg-type]


def test_without_cases_there_is_no_verdict() -> None:
    for figure in (proportion("", [], "at most", 0.1), quantile("", [], 0.5, "at most", 1.1)):
        assert figure.passed is None
        assert math.isnan(figure.value)


def test_interval_of_a_quantile_covers_it() -> None:
    generator, covered = np.random.default_rng(2), 0
    for _ in range(400):
        values = generator.exponential(size=80).tolist()
        covered += quantile("", values, 0.9, "about", -math.log(0.1)).passed is True
    assert covered >= binom.ppf(1e-4, 400, 0.95)


def test_interval_of_a_quantile_is_open_where_values_are_few() -> None:
    figure = quantile("", [1.0, 1.1, 1.2], 0.9, "at most", 1.3)
    assert figure.high == math.inf
