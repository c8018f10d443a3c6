"""Intervals of parameters, from the covariance of a vector."""

from collections.abc import Callable
from dataclasses import replace
from functools import partial
from types import SimpleNamespace
from typing import cast

import numpy as np
import pytest

from pyhrg.common.arrays import Array
from pyhrg.gap.effects.catalogue import EFFECTS
from pyhrg.gap.evidence.evidence import Fit
from pyhrg.gap.evidence.hypothesis import Hypothesis, compute_sigma_along
from pyhrg.gap.evidence.posterior import Posterior
from pyhrg.gap.evidence.search import Ranking
from pyhrg.gap.findings.verdict import compute_intervals

AXIS = EFFECTS["damping_anisotropy"]


def axis_at(degrees: float, magnitude: float = 1e-6) -> Array:
    angle = np.radians(4 * degrees)
    return magnitude * np.array([np.cos(angle), np.sin(angle)])


def _along(covariance: Array) -> Callable[[Array], float]:
    return partial(compute_sigma_along, covariance=covariance)


@pytest.mark.parametrize("degrees", [0.0, 0.01, 45.0, 89.99])
def test_an_axis_has_its_spread_wherever_the_turn_begins(degrees: float) -> None:
    found = compute_intervals(AXIS, axis_at(degrees), _along(np.eye(2) * 1e-8**2))
    low, high = found["damping_axis_deg"]
    assert high - low == pytest.approx(2 * 1.96 * np.degrees(1e-2) / 4, rel=1e-6)
    assert (low + high) / 2 % 90 == pytest.approx(degrees % 90, abs=1e-6)
    assert found["damping_anisotropy_per_s"] == pytest.approx((0.9804e-6, 1.0196e-6), rel=1e-6)


def test_an_axis_that_can_not_be_told_may_be_anywhere() -> None:
    low, high = compute_intervals(AXIS, axis_at(10.0, 1e-9), _along(np.eye(2) * 1e-8**2))[
        "damping_axis_deg"
    ]
    assert high - low == pytest.approx(90)
    found = compute_intervals(AXIS, np.zeros(2), _along(np.eye(2) * 1e-8**2))
    assert found["damping_anisotropy_per_s"][0] == 0.0


def test_correlation_counts() -> None:
    """Along and across the vector, by draws."""
    covariance = np.array([[4.0, 1.5], [1.5, 1.0]]) * 1e-16
    vector = axis_at(12.0)
    low, high = compute_intervals(AXIS, vector, _along(covariance))["damping_axis_deg"]
    drawn = np.random.default_rng(1).multivariate_normal(vector, covariance, 20000)
    angles = np.degrees(np.arctan2(drawn[:, 1], drawn[:, 0])) / 4
    assert (high - low) / 3.92 == pytest.approx(float(np.std(angles)), rel=0.02)


def test_a_delay_near_zero_has_its_whole_spread() -> None:
    found = compute_intervals(EFFECTS["loop_delay"], np.array([1e-6]), _along(np.array([[1e-8]])))
    low, high = found["loop_delay_s"]
    assert high - low == pytest.approx(2 * 1.96e-4)


def test_an_interval_holds_the_sets_that_may_be_wrong() -> None:
    """95 % of a mixture of three sets under two noises, by draws."""
    effect = EFFECTS["loop_delay"]
    sets = [((0.0, 1.0), 0.7), ((0.5, 2.0), 0.2), ((4.0, 0.5), 0.1)]
    fits = [
        Fit((effect,), 0.0, 0.0, (np.array([mean]),), (np.array([[sigma**2]]),))
        for (mean, sigma), _ in sets
    ]
    empty = Fit((), 0.0, 0.0, (), ())
    rankings = [
        Ranking((fits[0], empty), (0.5, 0.5), 0.0),
        Ranking((fits[1], fits[2]), (2 / 3, 1 / 3), 0.0),
    ]
    hypotheses = [cast(Hypothesis, SimpleNamespace(ranking=ranking)) for ranking in rankings]
    posterior = Posterior(tuple(hypotheses), (0.7, 0.15))
    sigma = posterior.compute_sigma(effect, np.zeros(1), np.ones(1))
    generator = np.random.default_rng(2)
    weights = np.array([0.35, 0.1, 0.05]) / 0.5
    chosen = generator.choice(3, 200000, p=weights)
    means, sigmas = np.array([own for own, _ in sets]).T
    drawn = generator.normal(means[chosen], sigmas[chosen])
    assert np.mean(np.abs(drawn) < 1.96 * sigma) == pytest.approx(0.95, abs=0.002)
    alone = replace(posterior, hypotheses=posterior.hypotheses[:1], probabilities=(1.0,))
    assert alone.compute_sigma(effect, np.zeros(1), np.ones(1)) == pytest.approx(1.0, rel=1e-5)
