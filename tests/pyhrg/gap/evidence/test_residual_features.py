"""Lines, stretches of other noise and noise in spells are found in residuals; steady noise has none
of them."""

import re

import numpy as np
import pytest

from pyhrg.common.arrays import Array
from pyhrg.gap.evidence.residual_features import (
    ResidualFeature,
    find_period,
    find_residual_features,
)
from pyhrg.gap.evidence.residuals import Residual
from pyhrg.gap.whitening.whitening import NoiseModel

ROWS = 4000
TESTS = 6
WHITE = NoiseModel(1.0)
KINDS = ("line", "stretch", "spells")


def found(
    series: list[Array], noise: NoiseModel = WHITE, wrong: float = 0.0
) -> list[ResidualFeature]:
    """A line, a stretch and spells, in tests of 1 s a row."""
    return list(find_residual_features(rest(series, noise, wrong)))


def rest(series: list[Array], noise: NoiseModel = WHITE, wrong: float = 0.0) -> list[Residual]:
    return [
        Residual(f"t{i}", "gyro_angle", x, np.ones(len(x)), 1.0, noise, model_error=wrong)
        for i, x in enumerate(series)
    ]


def steady(seed: int) -> list[Array]:
    generator = np.random.default_rng(seed)
    return list(generator.standard_normal((TESTS, ROWS)))


def test_steady_noise_is_steady() -> None:
    """Negative control: of 40 campaigns, seeds 0 to 39, none has odds of one in ten."""
    odds = [one.log_odds for seed in range(40) for one in found(steady(seed))]
    assert max(odds) < np.log(0.1)


def test_a_walk_is_steady_noise() -> None:
    noise = NoiseModel(1.0, angle_random_walk=0.5)
    generator = np.random.default_rng(1)
    walks = [x + 0.5 * np.cumsum(generator.standard_normal(ROWS)) for x in steady(2)]
    assert all(one.log_odds < np.log(0.1) for one in found(walks, noise))


def test_a_line_is_found_whatever_its_phase_in_each_test() -> None:
    """A line of 10 sigma in all tests, 4 sigma in each; its period within half a line's width."""
    generator = np.random.default_rng(3)
    time = np.arange(ROWS)
    size = 10 * np.sqrt(2 / (ROWS * TESTS))
    series = [x + size * np.sin(2 * np.pi * (time / 17.3 + generator.random())) for x in steady(4)]
    line, stretch, _ = found(series)
    assert line.log_odds > 5
    match = re.fullmatch(r"periodic in (.*) s in 6 tests \(output angle\)", line.words)
    assert match
    assert float(match[1]) == pytest.approx(17.3, abs=17.3**2 / ROWS / 2)
    assert stretch.log_odds < 0


def test_a_line_of_one_phase_is_found_where_no_test_shows_it() -> None:
    """A line of 7 sigma in all tests, less than 3 sigma in each; its period within a fifth of its
    width. Of a phase of its own in each test it is lost."""
    generator = np.random.default_rng(5)
    time = np.arange(ROWS)
    size = 7 * np.sqrt(2 / (ROWS * TESTS))

    def add(phases: np.ndarray) -> list[Array]:
        pairs = zip(steady(6), phases, strict=True)
        return [x + size * np.sin(2 * np.pi * (time / 17.3 + p)) for x, p in pairs]

    period = find_period(rest(add(np.full(TESTS, 0.3))))
    assert period == pytest.approx(17.3, abs=17.3**2 / ROWS / 5)
    assert find_period(rest(add(generator.random(TESTS)))) is None
    assert find_period(rest(steady(6))) is None


def test_a_model_error_is_no_line() -> None:
    series = steady(5)
    series[0] = series[0] + 0.3 * np.sin(np.arange(ROWS))
    assert found(series)[0].log_odds > 20
    assert found(series, wrong=10.0)[0].log_odds < 0


@pytest.mark.parametrize("rows", [4000, 4100])
def test_a_slow_drift_is_no_line(rows: int) -> None:
    """A drift of 2.6 cycles, for transforms of any length."""
    series = steady(6)
    drift = 0.5 * np.cos(2 * np.pi * 2.6 * np.arange(rows) / rows)
    series[1] = np.random.default_rng(7).standard_normal(rows) + drift
    assert found(series)[0].log_odds < 0


def test_an_offset_in_a_short_test_is_no_line() -> None:
    series = [*steady(8), np.random.default_rng(9).standard_normal(200) + 0.35]
    assert found(series)[0].log_odds < 0


@pytest.mark.parametrize("length", [10, 100])
def test_noise_that_comes_and_goes_is_found(length: int) -> None:
    """Spells of twice the noise, a tenth of the time, of which no stretch stands out."""
    generator, series = np.random.default_rng(12), steady(13)
    for x in series:
        for begin in generator.integers(0, ROWS, ROWS // (10 * length)):
            x[begin : begin + length] *= 2
    line, stretch, spells = found(series)
    assert line.log_odds < 0
    assert stretch.log_odds < spells.log_odds - 10
    match = re.fullmatch(r"noise that comes and goes in spells of (.*) rows.*", spells.words)
    assert match
    assert length / 4 < int(match[1]) < 4 * length
    assert found(series, wrong=100.0)[2].log_odds < 0


def test_a_loud_stretch_is_no_line() -> None:
    series = steady(10)
    series[0][:500] *= 6
    line, stretch, *_ = found(series)
    assert line.log_odds < 0 < 50 < stretch.log_odds


def test_steady_noise_with_heavy_tails_is_steady() -> None:
    """Student's t noise of 6 degrees of freedom, in 20 campaigns."""
    generator = np.random.default_rng(11)
    for _ in range(20):
        series = list(generator.standard_t(6, (TESTS, ROWS)) / np.sqrt(1.5))
        assert all(one.log_odds < 0 for one in found(series))


@pytest.mark.parametrize("factor", [0.5, 1.5])
def test_a_stretch_is_found_where_it_is(factor: float) -> None:
    series = steady(7)
    series[2][1000:1500] *= factor
    line, stretch, *_ = found(series)
    assert stretch.log_odds > 10
    assert stretch.words.startswith("noise of its own in t2 from 1")
    assert line.log_odds < 0


def test_a_stretch_of_wandering_noise_is_found_over_more_rows() -> None:
    """A walk of a fifth of the noise a row: over 64 rows it exceeds the noise."""
    series = steady(8)
    series[3][2000:] += 0.2 * np.cumsum(np.random.default_rng(9).standard_normal(2000))
    noise = NoiseModel(1.0, angle_random_walk=0.02)
    _, stretch, _ = found(series, noise)
    assert stretch.log_odds > 10
    assert "in t3" in stretch.words


def test_a_level_difference_within_the_tolerance_is_no_stretch() -> None:
    """A level difference of 6 %, which is significant in so many rows, but within the tolerance."""
    series = [np.random.default_rng(12).standard_normal(100_000)]
    series[0][:50_000] *= 1.06
    assert found(series)[0].log_odds < 0
    assert found(series)[1].log_odds < 0
    series[0][:50_000] *= 1.06
    assert found(series)[1].log_odds > 5


def test_a_model_error_is_no_stretch() -> None:
    series = steady(13)
    series[4][1000:1032] += 4.0
    assert found(series)[1].log_odds > 20
    assert found(series, wrong=32 * 4.0**2)[1].log_odds < 0


@pytest.mark.parametrize("values", [np.ones(20), np.zeros(1000)])
def test_few_rows_and_zeros_are_left_out(values: Array) -> None:
    assert (
        find_residual_features(
            [Residual("t", "amplitude", values, np.ones(len(values)), 1.0, WHITE)]
        )
        == ()
    )


@pytest.mark.parametrize("rows", [40, 100, 300])
@pytest.mark.parametrize("size", [0.0, 1.0])
def test_short_tests_are_searched_too(rows: int, size: float) -> None:
    """A short test of noise, and one of constant rows."""
    values = 1.0 + size * np.random.default_rng(14).standard_normal(rows)
    steps = np.ones(rows)
    both = find_residual_features([Residual("t", "amplitude", values - size, steps, 1.0, WHITE)])
    assert len(both) == 3
    assert all(np.isfinite(one.log_odds) for one in both)
