"""Scores of predictors: a proper score, perfect and shuffled predictions."""

import numpy as np
import pandas as pd
import pytest
from scipy.stats import norm

from ins_eval.study.challenge.score_predictions import (
    FIELDS,
    NAIVE,
    ChallengeScores,
    score_predictions,
)
from ins_eval.study.scores import measures
from ins_eval.study.tables import columns as c
from tests.ins_eval.study.scores.tables import table

COUNT = 12


@pytest.fixture(scope="module")
def flights() -> pd.DataFrame:
    """Half of the triads are training triads."""
    flown = table(2 * COUNT)
    return flown.assign(**{c.ROLE: np.where(flown[c.TRIAD] < COUNT, "train", "test")})


@pytest.fixture(scope="module")
def scores(flights: pd.DataFrame) -> ChallengeScores:
    judged = flights[flights[c.ROLE] == "test"]
    keys, error = judged[[c.TRIAD, c.MISSION]].to_numpy(), judged[c.FLOWN_RADIAL].to_numpy()
    other = error.reshape(-1, COUNT)[:, ::-1].reshape(-1)

    def told(median: np.ndarray) -> pd.DataFrame:
        columns = np.column_stack([keys, 0.9 * median, median, 1.1 * median])
        return pd.DataFrame(columns, columns=FIELDS).infer_objects()

    return score_predictions(flights, {"perfect": told(error), "shuffled": told(other)}, 3, 0.9)


def select(scores: ChallengeScores, predictor: str) -> pd.Series:
    rows = scores.table[scores.table["predictor"] == predictor]
    return rows[rows[c.CLASS] == "car"].iloc[0]


def test_interval_score_is_the_sum_of_quantile_losses() -> None:
    """Of 5, 50 and 95 %, over 1.5 (Bracher et al. 2021, Eq. 3 and 7)."""
    generator = np.random.default_rng(1)
    flown = generator.exponential(1.0, (50, 2))
    ends = np.sort(generator.exponential(1.0, (3, 50, 2)), axis=0)
    losses = [
        np.mean(np.where(flown >= q, share * (flown - q), (share - 1) * (flown - q)))
        for share, q in zip((0.05, 0.5, 0.95), ends, strict=True)
    ]
    found = measures.compute_interval_score(flown, *ends, inside=0.9)
    assert found == pytest.approx(sum(losses) / 1.5, rel=1e-12)


@pytest.mark.parametrize(("factor", "shift"), [(0.5, 0.0), (2.0, 0.0), (1.0, 0.5), (1.0, -0.5)])
def test_belief_that_is_right_scores_best(factor: float, shift: float) -> None:
    flown = 10 + np.random.default_rng(2).normal(size=(4000, 1))

    def score(factor: float, shift: float) -> float:
        ends = (np.full_like(flown, 10 + shift + factor * norm.ppf(p)) for p in (0.05, 0.5, 0.95))
        return float(measures.compute_interval_score(flown, *ends, inside=0.9))

    assert score(factor, shift) > 1.05 * score(1.0, 0.0)


def test_perfect_and_shuffled_predictions(scores: ChallengeScores) -> None:
    perfect, shuffled = (select(scores, name) for name in ("perfect", "shuffled"))
    assert (perfect["r2"], perfect["spearman"], perfect["coverage"]) == (1, 1, 1)
    assert perfect["coverage_low"] == pytest.approx(0.025 ** (1 / COUNT), rel=1e-6)
    assert shuffled["r2"] < 0.5
    assert shuffled["interval_score_nmi"] > 5 * perfect["interval_score_nmi"]


def test_naive_predictor_is_of_the_training_triads(scores: ChallengeScores) -> None:
    naive, fitted = select(scores, NAIVE.title), select(scores, "Fitted map")
    assert naive["r2"] <= 0
    assert naive["interval_score_nmi"] > fitted["interval_score_nmi"]


def test_table_is_printed_by_class(scores: ChallengeScores) -> None:
    blocks = str(scores).split("\n\n")
    assert [block.split(":")[0] for block in blocks] == ["all", "car", "ship"]
    assert all(f"n = {COUNT} triads" in block for block in blocks)
    line = next(line for line in blocks[2].splitlines() if line.startswith(NAIVE.title))
    assert "not defined" in line
    assert blocks[1].count("\n") == 1 + 1 + len(c.PREDICTORS) + 2
