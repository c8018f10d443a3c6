"""The verdict says what the scores say, and nothing else."""

from dataclasses import replace

import pytest

from ins_eval.study.report.failures import render_controls, render_failures
from ins_eval.study.report.requirements import tabulate_requirements
from ins_eval.study.report.verdict import count_requirements, list_sentences
from ins_eval.study.specification import TEST
from ins_eval.study.study_data import StudyData
from ins_eval.study.tables import score as scored
from ins_eval.study.tables.score import ALL, Score
from tests.ins_eval.study.report.synthetic import synthetic

BLANK = Score("", "", "map", ALL, TEST, 0.0, 0.0, 0.0, 0.95, 100, 1)


TABLE = synthetic(4).table
ABOUT = {"interval_percent": 90}


def told(*scores: Score) -> str:
    return " ".join(list_sentences(StudyData(TABLE, scores, ABOUT), "map"))


def opening(*holds: bool | None, half: str = TEST, shuffled: bool = False) -> str:
    asked = replace(BLANK, mission_class="ship", half=half, shuffled=shuffled)
    scores = [replace(asked, holds=h) for h in holds]
    return count_requirements(StudyData(TABLE, scores, ABOUT))


def test_headline_counts_what_was_asked() -> None:
    assert opening(True, True) == "The thesis holds: all 2 requirements on the test half are met."
    assert opening(True, False, None) == "The thesis holds in part: 1 of 2 requirements are met."
    assert opening(False) == "The thesis does not hold: none of 1 requirements is met."
    assert opening(None).startswith("This study has no requirements")


def test_headline_takes_no_credit_for_the_seen_half_and_for_controls() -> None:
    assert opening(True, half="train").startswith("This study has no requirements")
    assert opening(True, shuffled=True).startswith("This study has no requirements")


@pytest.mark.parametrize(
    ("value", "low", "high", "words"),
    [
        (15, 12, 19, "is too optimistic"),
        (0.2, 0.1, 0.3, "is too pessimistic"),
        (1.1, 0.9, 1.4, "predicts the error within a factor of 2"),
        (1.9, 1.2, 2.6, "is consistent with the flights"),
    ],
)
def test_promises(value: float, low: float, high: float, words: str) -> None:
    ratio = replace(
        BLANK, score=scored.MEDIAN_RATIO, predictor="fixed_rule", value=value, low=low, high=high
    )
    assert f"Fixed position {words}" in told(ratio)


@pytest.mark.parametrize(
    ("low", "high", "words"),
    [
        (0.93, 0.99, "nearly all"),
        (0.3, 0.6, "part"),
        (-0.2, 0.3, "not significantly above none"),
        (0.01, 0.08, "almost none"),
        (-4, -1, "none"),
    ],
)
def test_explained_variance(low: float, high: float, words: str) -> None:
    r2 = replace(BLANK, score=scored.R2_RADIAL, predictor="fitted_map", low=low, high=high)
    assert f"flights: Fitted map {words}, R2" in told(r2)


@pytest.mark.parametrize(
    ("low", "high", "words"), [(0.86, 0.93, ", compatible"), (0.7, 0.8, ", not compatible")]
)
def test_coverage(low: float, high: float, words: str) -> None:
    covered = replace(BLANK, score=scored.COVERAGE, predictor="fitted_map", low=low, high=high)
    assert words in told(covered)


def test_coverage_is_held_to_the_level_asked() -> None:
    covered = replace(BLANK, score=scored.COVERAGE, predictor="fitted_map", low=0.7, high=0.8)
    text = " ".join(list_sentences(StudyData(TABLE, [covered], {"interval_percent": 75}), "map"))
    assert "inside 75 % intervals" in text
    assert ", compatible with 0.75" in text


def test_ranking_that_is_not_certain_is_said_so() -> None:
    rank = replace(BLANK, score=scored.SPEARMAN, predictor="fixed_rule", low=-0.1, high=0.2)
    assert "Fixed position not significantly, Spearman" in told(rank)


def test_classes_that_fail_are_named_with_their_figures() -> None:
    asked = replace(
        BLANK, score=scored.R2_RADIAL, predictor="fitted_map", holds=True, asked=">= 0.95"
    )
    ship = replace(asked, mission_class="ship", holds=False, value=0.9, low=0.85, high=0.94)
    made = StudyData(TABLE, [replace(asked, mission_class="car"), ship], ABOUT)
    (row,) = tabulate_requirements(made).rows
    assert row[2:] == ("1 of 2; not in ship: 0.9 (0.85 to 0.94), required >= 0.95", "–")
    assert "1 of 2; not in ship" in render_failures(made)


def test_an_oracle_that_fails_does_not_break_the_thesis() -> None:
    oracle = replace(
        BLANK, score=scored.COVERAGE, predictor="oracle", mission_class="ship", holds=False
    )
    assert count_requirements(StudyData(TABLE, [oracle], ABOUT)).startswith(
        "This study has no requirements"
    )


def test_notes_are_told_once_with_every_class() -> None:
    note = replace(BLANK, score=scored.ADVANTAGE, predictor="circumference_rule", note="No gain.")
    made = StudyData(TABLE, [replace(note, mission_class=name) for name in ("car", "ship")], ABOUT)
    text = render_failures(made)
    assert text.count("No gain.") == 1
    assert "car: 0 (0 to 0); ship: 0 (0 to 0)" in text


def test_controls_that_show_something_are_counted() -> None:
    control = replace(BLANK, score=scored.SPEARMAN, predictor="fixed_rule", shuffled=True)
    made = [replace(control, holds=True), replace(control, holds=False, mission_class="car")]
    text = render_controls(StudyData(TABLE, made, ABOUT))
    assert "1 of 2 negative controls on the test half fail" in text
    assert "car: 0 (0 to 0)" in text


def test_a_control_that_shows_something_warns() -> None:
    control = replace(BLANK, score=scored.SPEARMAN, predictor="fixed_rule", shuffled=True)
    nothing = told(replace(control, low=-0.1, high=0.1))
    assert "shuffled: none is above 0: Fixed position Spearman 0 (−0.1 to 0.1)." in nothing
    assert "it FAILS in" in told(replace(control, low=0.1, high=0.3))


def test_other_calibrations_and_the_seen_half_are_left_out() -> None:
    r2 = replace(BLANK, score=scored.R2_RADIAL, predictor="fitted_map")
    assert told(replace(r2, calibration="mean"), replace(r2, half="train")) == ""
