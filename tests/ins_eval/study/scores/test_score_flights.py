"""Scores of whole tables, whose truth is known."""

from dataclasses import astuple

import numpy as np
import pandas as pd
import pytest

from ins_eval.study.scores.score_flights import score_flights
from ins_eval.study.tables import columns, score
from ins_eval.study.tables.score import ALL, SCORES, Score
from tests.ins_eval.study.scores.tables import CLASSES, SHIPS, table


@pytest.fixture(scope="module")
def flown() -> pd.DataFrame:
    return table(80)


@pytest.fixture(scope="module")
def judged(flown: pd.DataFrame) -> list[Score]:
    return score_flights(flown, seed=7)


def _one(
    judged: list[Score], name: str, key: str, mission_class: str = ALL, **other: bool
) -> Score:
    shuffled = other.get("shuffled", False)
    found = [
        s
        for s in judged
        if (s.score, s.predictor, s.mission_class, s.shuffled)
        == (name, key, mission_class, shuffled)
    ]
    assert len(found) == 1
    return found[0]


def test_every_figure_has_its_interval_number_and_seed(judged: list[Score]) -> None:
    assert {s.mission_class for s in judged} == {ALL, *CLASSES}
    for s in judged:
        assert s.score in SCORES
        assert s.low <= s.high
        assert (s.n, s.seed, s.confidence) == (80, 7, 0.95)


def test_claims_have_requirements(judged: list[Score]) -> None:
    """The maps of these gyros drift a lot: the interval of R2 holds 0.97; intervals are right."""
    fitted = _one(judged, score.R2_RADIAL, "fitted_map")
    true = _one(judged, score.R2_RADIAL, "true_parameters")
    assert (fitted.asked, fitted.verdict, true.verdict) == (">= 0.97", "undecided", "")
    assert 0.8 < fitted.value < true.value
    assert _one(judged, score.COVERAGE, "fitted_map").verdict == "holds"
    known = _one(judged, score.R2_MOUNTED, "fitted_map")
    assert known.value > _one(judged, score.R2_COMPONENTS, "fitted_map").value
    shortfall = _one(judged, score.R2_SHORTFALL, "fitted_map")
    assert shortfall.value == pytest.approx(true.value - fitted.value)
    size = _one(judged, score.MEDIAN_RATIO, "circumference_class")
    assert (size.asked, size.verdict) == ("within a factor of 1.3", "holds")
    for name in (score.SKILL_OVER_FIXED, score.SKILL_OVER_CLASS):
        skill = _one(judged, name, "circumference_class")
        assert (skill.asked, skill.verdict) == ("above 0", "holds")
    wrong = _one(judged, score.MEDIAN_RATIO, "fixed_rule")
    assert (wrong.asked, wrong.verdict) == ("below 0.5 or above 2", "holds")


def test_too_few_triads_do_not_show_that_nothing_is_ranked() -> None:
    """An interval that is wider than the bound decides nothing, though it holds 0."""
    for count, verdict in ((12, "undecided"), (150, "holds")):
        ship = table(count, classes=SHIPS)
        rank = _one(score_flights(ship, seed=7), score.SPEARMAN, "fixed_rule", "ship")
        assert (rank.asked, rank.verdict) == ("within 0.2 of 0", verdict)
        assert rank.low < 0 < rank.high


def test_coverage_is_held_to_the_level_asked(flown: pd.DataFrame) -> None:
    """Intervals of 90 % are no intervals of 50 %."""
    ships = flown[flown[columns.CLASS] == "ship"]
    judged = score_flights(ships, seed=7, inside=0.5)
    found = _one(judged, score.COVERAGE, "fitted_map", "ship")
    assert (found.asked, found.verdict) == ("0.5 within its interval", "fails")


def test_shuffled_devices_show_nothing(judged: list[Score]) -> None:
    for key in ("fixed_rule", "circumference_rule", "fitted_map"):
        none = _one(judged, score.SPEARMAN, key, shuffled=True)
        assert none.verdict == "holds"
    assert _one(judged, score.SPEARMAN, "fitted_map").low > none.high
    none = _one(judged, score.R2_COMPONENTS, "fitted_map", shuffled=True)
    assert none.verdict == "holds"
    assert none.high < 0 < _one(judged, score.R2_COMPONENTS, "fitted_map").low


def test_where_noise_dominates_no_map_predicts() -> None:
    """Maps a thousand times smaller than noise and the bench's fit."""
    found = score_flights(table(60, spread=1e-3, classes=SHIPS), seed=7)
    assert _one(found, score.R2_RADIAL, "fitted_map", "ship").verdict == "fails"


def test_order_of_rows_is_no_matter(flown: pd.DataFrame, judged: list[Score]) -> None:
    mixed = flown.sample(frac=1, random_state=1)
    for one, other in zip(score_flights(mixed, seed=7), judged, strict=True):
        assert astuple(one) == astuple(other)


def test_a_missing_row_is_named(flown: pd.DataFrame) -> None:
    with pytest.raises(ValueError, match="map, all, test: 80 triads, 3 missions and 239 rows"):
        score_flights(flown.iloc[1:], seed=7)
    twice = pd.concat([flown.iloc[1:], flown.iloc[[1]]])
    with pytest.raises(ValueError, match="expected one row for each triad and mission"):
        score_flights(twice, seed=7)


def test_a_row_that_is_there_twice(flown: pd.DataFrame) -> None:
    one = flown[flown[columns.MISSION] == flown[columns.MISSION].iloc[0]]
    with pytest.raises(ValueError, match="80 triads, 1 missions and 81 rows"):
        score_flights(pd.concat([one, one.iloc[[5]]]), seed=7)


def test_too_few_triads(flown: pd.DataFrame) -> None:
    with pytest.raises(ValueError, match="1 triads: expected 2 or more"):
        score_flights(flown[flown[columns.TRIAD] == 0], seed=7)


def test_values_are_finite(judged: list[Score]) -> None:
    assert np.all(np.isfinite([(s.value, s.low, s.high) for s in judged]))
