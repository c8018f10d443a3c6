"""The claims as one table; conditions judged apart, and kept out of everything else."""

import html
import re

import pytest

from ins_eval.study.report.claim_table import render_claims, render_conditions
from ins_eval.study.report.claims import (
    judge_claims,
    judge_conditions,
    list_conditions,
    name_requirement,
)
from ins_eval.study.report.page import render_page
from ins_eval.study.study_data import StudyData
from ins_eval.study.tables import columns as c
from pyhrg.common.pages.svg import format_estimate
from tests.elements import elements
from tests.ins_eval.study.report.synthetic import CONDITIONS, MISSIONS, synthetic


@pytest.fixture(scope="module")
def result() -> StudyData:
    return synthetic(12)


def test_conditions_are_in_no_other_figure(result: StudyData) -> None:
    assert result.conditions
    assert not set(result.table[c.CLASS]) & set(CONDITIONS)
    assert not {s.mission_class for s in result.scores} & set(CONDITIONS)
    assert set(result.conditions.table[c.CLASS]) == set(CONDITIONS)
    assert {s.role for s in result.conditions.scores} == {"condition"}


def test_every_requirement_of_every_class_is_in_the_table(result: StudyData) -> None:
    """With verdict, interval and number; the mean calibration first."""
    text = render_claims(result)
    elements(text)
    mean, whole, failures = text.split("<tbody>")[1:]
    assert "Mean calibrated" in mean
    assert "Whole map calibrated" in whole
    for calibration, body in (("mean", mean), ("map", whole)):
        judged = judge_claims(result, calibration)
        assert [each.claim.letter for each in judged] == re.findall(r">\(([a-d])\) ", body)
        for each in judged:
            for s in each.by_class:
                row = body.split(f"<td>{html.escape(name_requirement(each.claim, s))}<br>")[1:]
                value, low, high = format_estimate(s.value, s.low, s.high)
                cell = f"<b>{value}</b><br><small>{low} to {high}</small>"
                assert any(cell in each_row.split("</tr>")[0] for each_row in row)
    for name in dict.fromkeys(MISSIONS.values()):
        assert f'<th scope="col">{name}</th>' in text
        assert mean.count(f'data-label="{name}"') == whole.count(f'data-label="{name}"') > 5
    assert failures.count("(d) ") == 1


def test_rows_are_as_wide_as_the_head(result: StudyData) -> None:
    """A claim's cell reaches over its rows; of each row all columns are filled."""
    table = render_claims(result)
    width = table.split("</thead>")[0].count("<th ")
    left = 0
    for row in table.split("</thead>")[1].split("<tr")[1:]:
        spans = [int(span) for span in re.findall(r'colspan="(\d+)"', row)]
        cells = len(re.findall("<t[dh]", row)) - len(spans) + sum(spans) + (left > 0)
        assert cells == width
        (rows,) = re.findall(r'rowspan="(\d+)"', row) or (left,)
        left = int(rows) - 1 if int(rows) else 0


def test_where_claims_fail_is_said_on_top(result: StudyData) -> None:
    top = render_page(result).split("</header>")[0]
    for each in list_conditions(result):
        assert f"<td>{html.escape(each.name)}<br>" in top
        assert f'<td data-label="n">{each.n}</td>' in top
        for figure in each.lines:
            assert html.escape(figure) in top


def test_figures_have_intervals_and_number(result: StudyData) -> None:
    text = render_conditions(result)
    for name in CONDITIONS:
        assert f'<th scope="col">{html.escape(name)}</th>' in text
    for judged in judge_conditions(result):
        for s in judged.by_class:
            assert html.escape(s.asked) in text
            assert f'<td data-label="n">{s.n}</td>' in text
    for name, what in CONDITIONS.items():
        assert f"<b>{html.escape(name)}</b>: {what}" in text


def test_a_study_without_conditions_says_so() -> None:
    without = synthetic(12, conditions=False)
    assert without.conditions is None
    assert "no flights in conditions" in render_conditions(without)
    assert "no flights in conditions" in render_claims(without)
