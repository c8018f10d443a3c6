"""Conditions judged apart: told by what their scores say, and kept out of everything else."""

import html

import pytest

from ins_eval.study.report.claims import describe_conditions, judge_condition
from ins_eval.study.report.condition_section import render_conditions
from ins_eval.study.report.page import render_page
from ins_eval.study.study_data import StudyData
from ins_eval.study.tables import columns as c
from tests.ins_eval.study.report.synthetic import CONDITIONS, synthetic


@pytest.fixture(scope="module")
def result() -> StudyData:
    return synthetic(12)


def test_conditions_are_in_no_other_figure(result: StudyData) -> None:
    assert result.conditions
    assert not set(result.table[c.CLASS]) & set(CONDITIONS)
    assert not {s.mission_class for s in result.scores} & set(CONDITIONS)
    assert set(result.conditions.table[c.CLASS]) == set(CONDITIONS)
    assert {s.role for s in result.conditions.scores} == {"condition"}


def test_where_claims_fail_is_said_on_top(result: StudyData) -> None:
    top = render_page(result).split("</header>")[0]
    for line in describe_conditions(result):
        assert html.escape(line) in top


def test_figures_have_intervals_and_number(result: StudyData) -> None:
    text = render_conditions(result)
    for name in CONDITIONS:
        for judged in judge_condition(result, name):
            for s in judged.by_class:
                assert html.escape(s.asked) in text
                assert f"<td>{s.n}</td>" in text
    for name, what in CONDITIONS.items():
        assert f"<b>{html.escape(name)}</b>: {what}" in text


def test_a_study_without_conditions_says_so() -> None:
    without = synthetic(12, conditions=False)
    assert without.conditions is None
    assert "no flights in conditions" in render_conditions(without)
