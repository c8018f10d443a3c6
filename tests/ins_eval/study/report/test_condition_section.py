"""Conditions judged apart: told by what their scores say, and kept out of everything else."""

import html
from dataclasses import replace

import pytest

from ins_eval.study.report.condition_section import (
    does_thesis_hold,
    group_by_condition,
    render_conditions,
    summarize_conditions,
)
from ins_eval.study.report.page import render_page
from ins_eval.study.report.requirements import format_score
from ins_eval.study.study_data import StudyData
from ins_eval.study.tables import columns as c
from ins_eval.study.tables import score as scored
from tests.ins_eval.study.report.synthetic import CONDITIONS, synthetic


@pytest.fixture(scope="module")
def result() -> StudyData:
    return synthetic(12)


def test_conditions_are_in_no_other_figure(result: StudyData) -> None:
    assert result.conditions
    assert not set(result.table[c.CLASS]) & set(CONDITIONS)
    assert not {s.mission_class for s in result.scores} & set(CONDITIONS)
    assert set(result.conditions.table[c.CLASS]) == set(CONDITIONS)
    assert {s.half for s in result.conditions.scores} == {"condition"}


def test_where_it_holds_and_where_not_is_said_on_top(result: StudyData) -> None:
    told = summarize_conditions(result)
    assert told == (
        "Conditions scored apart: the thesis does not hold for: self-calibrated. "
        "The thesis holds for: straight & level."
    )
    assert html.escape(told) in render_page(result).split("</header>")[0]


@pytest.mark.parametrize("broken", [scored.ADVANTAGE, scored.VARIANCE_REMOVED])
def test_each_half_of_the_thesis_must_hold(result: StudyData, broken: str) -> None:
    scores = group_by_condition(result)["straight & level"]
    assert does_thesis_hold(scores)
    assert not does_thesis_hold(
        [replace(s, holds=False) if s.score == broken else s for s in scores]
    )
    assert not does_thesis_hold([s for s in scores if s.score != broken])


def test_figures_have_intervals_number_and_seed(result: StudyData) -> None:
    text = render_conditions(result)
    for scores in group_by_condition(result).values():
        for s in scores:
            if s.score in (scored.ADVANTAGE, scored.VARIANCE_REMOVED):
                assert format_score(s) in text
                assert f"<td>{s.n}</td>" in text
                assert f"seed {s.seed}" in text
    assert text.count("<figure>") == len(CONDITIONS)


def test_a_study_without_conditions_says_so() -> None:
    without = synthetic(12, conditions=False)
    assert without.conditions is None
    assert "no flights in conditions" in render_conditions(without)
    assert summarize_conditions(without) == ""
