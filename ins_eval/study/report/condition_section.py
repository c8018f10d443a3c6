"""Claim (d), where the other claims fail: by mission class, and in conditions scored apart."""

import html

from ins_eval.study.report.claims import (
    JudgedClaim,
    format_score,
    judge_claims,
    judge_condition,
    list_conditions,
    name_requirement,
)
from ins_eval.study.report.figures.filters import name_calibration
from ins_eval.study.study_data import CONDITIONS_KEY, StudyData
from ins_eval.study.tables import columns as c
from pyhrg.common.pages.markup import Table, make_paragraph, make_wide_table

CHANCE = (
    "Where a 95 % interval decides, one valid requirement or control in twenty fails by chance. "
    "Undecided: the interval lies partly within what is required."
)
HEADER = ("Claim", "Requirement", "Score", "Required", "Verdict", "n")


def render_classes(data: StudyData) -> str:
    """A table of all requirements by class, and their verdicts."""
    rows = tuple(
        (name_calibration(calibration), *row)
        for calibration in data.list_values(c.CALIBRATION)
        for each in judge_claims(data, calibration)
        for row in _list_rows(each)
    )
    header = ("Calibration", "Class", *HEADER)
    table = Table("Requirements by mission class", header, rows)
    return make_wide_table(table, "words") + make_paragraph(CHANCE, "weak")


def render_conditions(data: StudyData) -> str:
    """A table of all requirements in each condition, and what differs there."""
    names = list_conditions(data)
    if not names:
        return make_paragraph("This study has no flights in conditions in which a claim may fail.")
    rows = tuple(
        row for name in names for each in judge_condition(data, name) for row in _list_rows(each)
    )
    title = (
        "Gyros calibrated at the mean, flown by the linear model; the predictors are the study's "
        "and do not know the condition"
    )
    told = data.about.get(CONDITIONS_KEY, {})
    listed = "".join(
        f"<li><b>{html.escape(name)}</b>: {html.escape(told.get(name, ''))}</li>" for name in names
    )
    table = make_wide_table(Table(title, ("Condition", *HEADER), rows), "words")
    return f"<ul>{listed}</ul>{table}"


def _list_rows(judged: JudgedClaim) -> list[tuple[str, ...]]:
    """Class or condition, and `HEADER`, of each requirement."""
    return [
        (
            score.mission_class,
            judged.claim.letter,
            name_requirement(judged.claim, score),
            format_score(score),
            score.asked or "–",
            score.verdict or "beside it",
            f"{score.n}",
        )
        for score in [*judged.by_class, *judged.beside]
    ]
