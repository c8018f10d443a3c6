"""Claim (d), where the other claims fail: by mission class, and in conditions scored apart."""

import html

import numpy as np

from ins_eval.study.report.claims import (
    CLAIMS,
    format_score,
    judge_claims,
    judge_condition,
    list_conditions,
)
from ins_eval.study.report.figures.dots import LARGE, draw_path, scale_dots, select_positive
from ins_eval.study.report.figures.filters import name_calibration
from ins_eval.study.report.figures.parts import (
    Panel,
    draw_axes,
    draw_equality,
    join_panels,
    make_legend,
)
from ins_eval.study.study_data import CONDITIONS_KEY, StudyData
from ins_eval.study.tables import columns as c
from ins_eval.study.tables.columns import (
    CIRCUMFERENCE_RULE,
    FITTED_MAP,
    FIXED_RULE,
    PREDICTOR_OF,
)
from ins_eval.study.tables.score import Score
from pyhrg.common.pages import svg
from pyhrg.common.pages.markup import Table, make_paragraph, make_wide_table

COLOURS = {FIXED_RULE: "c1", CIRCUMFERENCE_RULE: "c0", FITTED_MAP: "c2"}
CHANCE = (
    "Where a 95 % interval decides, one valid requirement or control in twenty fails by chance. "
    "Undecided: the interval lies partly within what is required."
)


def render_classes(data: StudyData) -> str:
    """A table of all requirements by class, and their verdicts."""
    header = ("Claim", "Requirement", "Calibration", "Class", "Score", "Required", "Verdict", "n")
    rows = [
        (
            each.claim.letter,
            _name_part(s),
            name_calibration(calibration),
            s.mission_class,
            format_score(s),
            s.asked,
            s.verdict,
            f"{s.n}",
        )
        for calibration in data.list_values(c.CALIBRATION)
        for each in judge_claims(data, calibration)
        for s in each.by_class
    ]
    table = Table("Requirements by mission class", header, tuple(rows))
    return make_wide_table(table, "words") + make_paragraph(CHANCE, "weak")


def render_conditions(data: StudyData) -> str:
    """A table of scores, and a panel of flights for each condition."""
    names = list_conditions(data)
    if not names or data.conditions is None:
        return make_paragraph("This study has no flights in conditions in which a claim may fail.")
    conditions = data.conditions
    shown = (c.FLOWN_RADIAL, *(PREDICTOR_OF[key].median for key in COLOURS))
    limits = svg.find_decades(np.concatenate([conditions.table[name] for name in shown]))
    legend = make_legend(
        (("", colour, PREDICTOR_OF[key].title) for key, colour in COLOURS.items()),
        "Colours of predictors",
    )
    panels = join_panels(_make_panel(conditions, name, limits) for name in names)
    return make_wide_table(_tabulate(data, names), "words") + legend + panels


def _tabulate(data: StudyData, names: list[str]) -> Table:
    header = ("Condition", "Claim", "Requirement", "Score", "Required", "Verdict", "n")
    rows = tuple(
        (name, each.claim.letter, _name_part(s), format_score(s), s.asked, s.verdict, f"{s.n}")
        for name in names
        for each in judge_condition(data, name)
        for s in each.by_class
    )
    title = (
        "Gyros calibrated at the mean, flown by the linear model; the predictors are the study's "
        "and do not know the condition"
    )
    return Table(title, header, rows)


def _name_part(score: Score) -> str:
    return next(
        words
        for claim in CLAIMS
        for key, predictor, words in claim.parts
        if (key, predictor) == (score.score, score.predictor)
    )


def _make_panel(conditions: StudyData, name: str, limits: tuple[float, float]) -> Panel:
    rows = conditions.table[conditions.table[c.CLASS] == name]
    x, y = svg.make_horizontal_scale(*limits), svg.make_vertical_scale(*limits)
    paths = ""
    for key, colour in COLOURS.items():
        median = PREDICTOR_OF[key].median
        shown = select_positive(rows, median, c.FLOWN_RADIAL)
        paths += draw_path(shown, (median, x), (c.FLOWN_RADIAL, y), colour)
    what = html.escape(str(conditions.about.get(CONDITIONS_KEY, {}).get(name, "")))
    return Panel(
        title=name,
        body=draw_axes(
            x,
            y,
            ("predicted, nmi", "flown, nmi"),
            draw_equality(x, y) + scale_dots(paths, LARGE),
            f"{name}: flown against predicted error; the table above has its figures",
        ),
        notes=[
            f'<span class="weak">{what}</span>',
            f"{len(rows):,} flights of {rows[c.HOURS].max():g} h",
        ],
    )
