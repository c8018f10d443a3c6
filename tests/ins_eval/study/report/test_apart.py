"""Conditions judged apart: told by what their scores say, and kept out of everything else."""

import html
from dataclasses import replace

import pytest

from ins_eval.study.report.apart import apart, by_condition, holds, sentence
from ins_eval.study.report.page import page
from ins_eval.study.report.requirements import figure
from ins_eval.study.report.result import StudyResult
from ins_eval.study.tables import columns as c
from ins_eval.study.tables import score as scored
from tests.ins_eval.study.report.synthetic import CONDITIONS, synthetic


@pytest.fixture(scope="module")
def result() -> StudyResult:
    return synthetic(12)


def test_conditions_are_in_no_other_figure(result: StudyResult) -> None:
    assert result.apart
    assert not set(result.table[c.CLASS]) & set(CONDITIONS)
    assert not {s.mission_class for s in result.scores} & set(CONDITIONS)
    assert set(result.apart.table[c.CLASS]) == set(CONDITIONS)
    assert {s.half for s in result.apart.scores} == {"condition"}


def test_where_it_holds_and_where_not_is_said_on_top(result: StudyResult) -> None:
    told = sentence(result)
    assert told == (
        "Apart from these classes, it does not hold: self-calibrated. It holds as well: "
        "straight & level."
    )
    assert html.escape(told) in page(result).split("</header>")[0]


@pytest.mark.parametrize("broken", [scored.ADVANTAGE, scored.VARIANCE_REMOVED])
def test_each_half_of_the_thesis_must_hold(result: StudyResult, broken: str) -> None:
    scores = by_condition(result)["straight & level"]
    assert holds(scores)
    assert not holds([replace(s, holds=False) if s.score == broken else s for s in scores])
    assert not holds([s for s in scores if s.score != broken])


def test_figures_have_intervals_number_and_seed(result: StudyResult) -> None:
    text = apart(result)
    for scores in by_condition(result).values():
        for s in scores:
            if s.score in (scored.ADVANTAGE, scored.VARIANCE_REMOVED):
                assert figure(s) in text
                assert f"<td>{s.n}</td>" in text
                assert f"seed {s.seed}" in text
    assert text.count("<figure>") == len(CONDITIONS)


def test_a_study_without_conditions_says_so() -> None:
    without = synthetic(12, conditions=False)
    assert without.apart is None
    assert "none were asked" in apart(without)
    assert sentence(without) == ""
