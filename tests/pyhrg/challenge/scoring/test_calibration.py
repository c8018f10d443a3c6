"""The calibration error, on probabilities whose truth is drawn."""

import numpy as np
import pytest
from scipy.stats import binom

from pyhrg.challenge.scoring.score import compute_squared_error, score_calibration


def claims(n: int, seed: int, excess: float = 0.0) -> list[tuple[float, bool]]:
    """Probabilities that are too high by an excess."""
    generator = np.random.default_rng(seed)
    given = generator.uniform(0.2, 0.8, n)
    so = generator.random(n) < given - excess
    return list(zip(given.tolist(), so.tolist(), strict=True))


def test_right_probabilities_have_none_on_average() -> None:
    squares = [compute_squared_error(np.array(claims(400, seed))) for seed in range(200)]
    assert abs(np.mean(squares)) < 4 * np.std(squares) / np.sqrt(len(squares))


def test_an_excess_is_measured() -> None:
    squares = [compute_squared_error(np.array(claims(1000, seed, 0.15))) for seed in range(40)]
    assert np.mean(squares) == pytest.approx(0.15**2, abs=4 * np.std(squares) / np.sqrt(40))


def test_interval_covers_the_error() -> None:
    """An excess of 0.15, 20 times 150 campaigns of two claims: 0.999 of such counts are higher."""
    covered = 0
    for seed in range(20):
        campaigns = [claims(2, 1000 * seed + i, 0.15) for i in range(150)]
        figure = score_calibration("", campaigns, seed, "about", 0.15)
        covered += figure.passed is True
    assert covered >= binom.ppf(1e-3, 20, 0.9)


def test_right_probabilities_pass() -> None:
    campaigns = [claims(2, seed) for seed in range(500)]
    assert score_calibration("", campaigns, 1, "at most", 0.05).passed


def test_interval_of_a_wrong_claimant_leaves_the_target_out() -> None:
    campaigns = [claims(2, seed, 0.15) for seed in range(500)]
    figure = score_calibration("", campaigns, 1, "at most", 0.05)
    assert figure.passed is False
    assert figure.low < figure.value < figure.high


def test_same_seed_same_interval() -> None:
    campaigns = [claims(2, seed) for seed in range(50)]
    assert score_calibration("", campaigns, 3, "at most", 0.05) == score_calibration(
        "", campaigns, 3, "at most", 0.05
    )
