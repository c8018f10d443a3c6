"""Intervals that hold what they are of as often as they say, and a control that shows nothing."""

import numpy as np
import pytest
from scipy.stats import binom

from ins_eval.study.scores import measures
from ins_eval.study.scores.resampling import bootstrap, shuffle_devices


def test_interval_of_r2_holds_it() -> None:
    """150 triads, R2 = 0.8, 300 times, seed 1: percentile intervals fall a little short of 95 %,
    not below 91 %; one in 10^4 beyond either side."""
    random, n, times = np.random.default_rng(1), 150, 300
    held = 0
    for number in range(times):
        predicted = random.normal(size=(n, 1))
        flown = predicted + 0.5 * random.normal(size=(n, 1))
        found = bootstrap(measures.compute_r2, [flown, predicted], seed=number, draws=399)
        held += found.low <= 0.8 <= found.high
    assert binom.ppf(1e-4, times, 0.91) <= held <= binom.isf(1e-4, times, 0.96)


def test_interval_of_r2_is_too_narrow_for_forty_triads() -> None:
    """Errors whose sizes spread over a decade, R2 = 0.957 (2e6 triads), 300 times, seed 1: 90 %
    instead of 95 %, one in 10^4 beyond either side of 87 to 94 %."""
    random, n, times = np.random.default_rng(1), 40, 300
    held = 0
    for number in range(times):
        size = np.exp(random.uniform(0, np.log(10), size=(n, 1, 1)))
        known, rest = random.normal(size=(2, n, 1, 2))
        predicted, flown = (
            np.linalg.norm(size * each, axis=-1) for each in (known, known + 0.2 * rest)
        )
        found = bootstrap(measures.compute_r2, [flown, predicted], seed=number, draws=399)
        held += found.low <= 0.957 <= found.high
    assert binom.ppf(1e-4, times, 0.87) <= held <= binom.isf(1e-4, times, 0.94)


def test_interval_of_a_mean_is_students() -> None:
    """Of 2000 triads: 1.96 sigmas either way, within 10 %."""
    sample = np.random.default_rng(4).normal(size=(2000, 1))
    found = bootstrap(lambda a: np.mean(a, axis=(-2, -1)), [sample], seed=1)
    assert found.high - found.low == pytest.approx(2 * 1.96 / np.sqrt(2000), rel=0.1)


def test_a_triads_missions_stay_together() -> None:
    """The same mission flown four times tells nothing more: the interval stays, to the bit."""
    random = np.random.default_rng(2)
    flown, predicted = np.exp(random.normal(size=(2, 40, 1)))
    once = bootstrap(measures.compute_median_ratio, [flown, predicted], seed=1)
    four = [np.repeat(sample, 4, axis=1) for sample in (flown, predicted)]
    assert bootstrap(measures.compute_median_ratio, four, seed=1) == once


def test_seeds() -> None:
    flown, predicted = np.exp(np.random.default_rng(2).normal(size=(2, 40, 2)))
    first, again, other = (
        bootstrap(measures.compute_median_ratio, [flown, predicted], seed) for seed in (1, 1, 2)
    )
    assert first == again
    assert first.value == other.value
    assert (first.low, first.high) != (other.low, other.high)


def test_parts_are_no_matter(monkeypatch: pytest.MonkeyPatch) -> None:
    flown, predicted = np.random.default_rng(2).normal(size=(2, 40, 2))
    whole = bootstrap(measures.compute_r2, [flown, predicted], seed=1)
    monkeypatch.setattr("ins_eval.study.scores.resampling._MOST_NUMBERS", 1000)
    assert bootstrap(measures.compute_r2, [flown, predicted], seed=1) == whole


def test_shuffled_predictions_show_nothing() -> None:
    """A perfect prediction of others': ranks don't correlate, and R2 is -1 of equal spreads."""
    truth = np.random.default_rng(3).normal(size=(300, 2, 3))
    ranks = shuffle_devices(measures.compute_spearman, truth, [truth], seed=1)
    assert ranks.low < 0 < ranks.high
    assert ranks.high - ranks.low < 0.3
    pairs = truth[..., :2]
    found = shuffle_devices(measures.compute_component_r2, pairs, [pairs], seed=1)
    assert found.value == pytest.approx(-1, abs=0.02)


def test_resamples_that_tell_nothing_do_not_count() -> None:
    """Of two triads half of the resamples are one triad twice, whose R2 nobody knows."""
    flown, predicted = np.array([[1.0], [2.0]]), np.array([[1.1], [2.1]])
    found = bootstrap(measures.compute_r2, [flown, predicted], seed=1)
    assert (found.low, found.value, found.high) == pytest.approx((0.96,) * 3)


def test_nobody_keeps_his_own() -> None:
    who = np.arange(3.0)[:, None]
    own = shuffle_devices(lambda a, b: np.sum(a == b, axis=(-2, -1)), who, [who], seed=1)
    assert (own.value, own.high) == (0.0, 0.0)


def test_one_triad_cannot_be_shuffled() -> None:
    one = np.ones((1, 1))
    with pytest.raises(ValueError, match="1 triads: expected 2 or more"):
        shuffle_devices(measures.compute_r2, one, [one], seed=1)
