"""Statistics against simulation and exact counts."""

import numpy as np
import pytest
from scipy.stats import binom

from ins_eval.metrics import FEWEST_FOR_MEDIAN, median_interval, median_radius, paired_ratio
from ins_eval.validation.verdict import Ratio, verdict


@pytest.mark.parametrize("n", [6, 7, 8, 9, 15, 20, 21, 50, 101])
def test_median_interval_is_the_narrowest_that_holds_95_percent(n: int) -> None:
    low, high = median_interval(np.arange(n))
    assert low + high == n - 1
    rank = int(low)
    assert binom.cdf(rank, n, 0.5) <= 0.025 < binom.cdf(rank + 1, n, 0.5)


def test_too_few_for_an_interval() -> None:
    with pytest.raises(ValueError, match="5 values can't hold the median"):
        median_interval(np.arange(FEWEST_FOR_MEDIAN - 1))


@pytest.mark.parametrize("deviations", [(1.0, 1.0), (3.0, 1.0), (1.0, 0.01), (2.0, 0.0)])
def test_median_radius(deviations: tuple[float, float]) -> None:
    """Against 200 000 draws, seed 1."""
    draws = np.random.default_rng(1).normal(size=(200_000, 2)) * deviations
    turn = np.array([[0.6, -0.8], [0.8, 0.6]])
    covariance = turn @ np.diag(np.square(deviations)) @ turn.T
    expected = np.median(np.hypot(*draws.T))
    assert median_radius(covariance) == pytest.approx(expected, rel=0.01)


def test_median_radius_of_a_circle_is_rayleighs() -> None:
    assert median_radius(4 * np.eye(2)) == pytest.approx(2 * np.sqrt(2 * np.log(2)), rel=1e-9)


RATIOS = {
    "true": Ratio(1.1, 0.8, 1.4),
    "consistent": Ratio(0.8, 0.45, 1.3),
    "too good": Ratio(100, 80, 120),
    "too bad": Ratio(0.1, 0.08, 0.13),
    "undecided": Ratio(4.4, 1.8, 9.0),
}


@pytest.mark.parametrize("fixed", RATIOS)
@pytest.mark.parametrize("circumference", RATIOS)
def test_headline_and_lines_agree(fixed: str, circumference: str) -> None:
    """The headline says of a test what its own line says, and nothing that its line does not."""
    assert {name: r.word for name, r in RATIOS.items()} == {name: name for name in RATIOS}
    headline = verdict(RATIOS[fixed], RATIOS[circumference]).splitlines()[0]
    for test, word in (("full-circumference", circumference), ("fixed-position", fixed)):
        if f"{test} test told the truth" in headline:
            assert word == "true"
        if f"{test} test is consistent" in headline:
            assert word == "consistent"
        if f"{test} test did not" in headline or f"{test} test is not" in headline:
            assert word in ("too good", "too bad")
    if "Neither" in headline:
        assert {fixed, circumference} <= {"too good", "too bad"}


def test_verdict_of_the_paper() -> None:
    text = verdict(RATIOS["too good"], RATIOS["true"])
    assert text.startswith("The full-circumference test told the truth; the fixed-position")
    agreeing = verdict(Ratio(1.2, 0.9, 1.5), Ratio(1.0, 0.8, 1.3))
    assert agreeing.startswith("The two tests agree")


@pytest.mark.parametrize(
    ("ratio", "word"),
    [
        (Ratio(3.0, 2.1, 4.0), "too good"),
        (Ratio(0.3, 0.2, 0.4), "too bad"),
        (Ratio(1.5, 0.8, 2.5), "consistent"),
        (Ratio(1.2, 0.6, 1.9), "true"),
        (Ratio(2.4, 1.8, 3.0), "undecided"),
    ],
)
def test_ratio_in_a_word(ratio: Ratio, word: str) -> None:
    assert ratio.word == word


@pytest.mark.parametrize(("n", "factor"), [(6, 1.0), (16, 0.2)])
def test_interval_of_a_paired_ratio_holds_it(n: int, factor: float) -> None:
    """500 samples, seed 1, of radii whose halves are shared: 95 % within three deviations."""
    generator = np.random.default_rng(1)
    held = 0
    for _ in range(500):
        shared, own, other = generator.normal(size=(3, n, 2))
        ratio = paired_ratio(factor * np.hypot(*(shared + own).T), np.hypot(*(shared + other).T))
        held += ratio.low <= factor <= ratio.high
    assert held / 500 == pytest.approx(0.95, abs=3 * np.sqrt(0.95 * 0.05 / 500))


def test_paired_ratio_of_a_sample_to_itself_is_1() -> None:
    ratio = paired_ratio([1.0, 2.0, 5.0], [1.0, 2.0, 5.0])
    assert (ratio.low, ratio.value, ratio.high) == (1.0, 1.0, 1.0)
