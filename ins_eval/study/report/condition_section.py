"""Conditions in which the thesis may fail, scored apart from the classes: a table and panels."""

import html
from collections.abc import Sequence

import numpy as np

from ins_eval.study.report.figures.dots import LARGE, draw_path, scale_dots, select_positive
from ins_eval.study.report.figures.parts import (
    Panel,
    draw_axes,
    draw_equality,
    join_panels,
    make_legend,
)
from ins_eval.study.report.requirements import format_score
from ins_eval.study.study_data import CONDITIONS_KEY, StudyData
from ins_eval.study.tables import columns as c
from ins_eval.study.tables.columns import (
    CIRCUMFERENCE_RULE,
    FITTED_MAP,
    FIXED_RULE,
    PREDICTOR_OF,
)
from ins_eval.study.tables.score import (
    ADVANTAGE,
    COVERAGE,
    MEDIAN_RATIO,
    R2_RADIAL,
    SPEARMAN,
    VARIANCE_REMOVED,
    Score,
)
from pyhrg.common.pages import svg
from pyhrg.common.pages.markup import Table, make_paragraph, make_wide_table

COLOURS = {FIXED_RULE: "c1", CIRCUMFERENCE_RULE: "c0", FITTED_MAP: "c2"}
THESIS = ((ADVANTAGE, CIRCUMFERENCE_RULE), (VARIANCE_REMOVED, FITTED_MAP))
"""The thesis holds where both scores are above 0: the circumference predicts better than the fixed
position, and the fitted map better than the circumference."""
SHOWN_SCORES = (
    ((MEDIAN_RATIO, FIXED_RULE), "flown / predicted, fixed position"),
    ((MEDIAN_RATIO, CIRCUMFERENCE_RULE), "flown / predicted, full circumference"),
    ((SPEARMAN, CIRCUMFERENCE_RULE), "rank correlation, full circumference"),
    ((ADVANTAGE, CIRCUMFERENCE_RULE), "advantage of the circumference, |ln|"),
    ((R2_RADIAL, FITTED_MAP), "R2, fitted map"),
    ((VARIANCE_REMOVED, FITTED_MAP), "residual variance that the fitted map removes"),
    ((COVERAGE, FITTED_MAP), "coverage of the fitted map's intervals"),
)


def does_thesis_hold(scores: Sequence[Score]) -> bool:
    """Whether the thesis holds in a condition with these scores."""
    return {(s.score, s.predictor) for s in scores if s.holds}.issuperset(THESIS)


def group_by_condition(data: StudyData) -> dict[str, list[Score]]:
    """Scores of each condition, in the order of the study; without negative controls."""
    if data.conditions is None:
        return {}
    scores = [s for s in data.conditions.scores if not s.shuffled]
    names = dict.fromkeys(data.conditions.table[c.CLASS])
    return {name: [s for s in scores if s.mission_class == name] for name in names}


def summarize_conditions(data: StudyData) -> str:
    """In which conditions the thesis does not hold, and in which it does; "" without conditions."""
    grouped = group_by_condition(data)
    failing = [name for name, scores in grouped.items() if not does_thesis_hold(scores)]
    holding = [name for name in grouped if name not in failing]
    parts = []
    if failing:
        parts.append(f"the thesis does not hold for: {'; '.join(failing)}.")
    if holding:
        parts.append(f"The thesis holds for: {'; '.join(holding)}.")
    return " ".join(["Conditions scored apart:", *parts]) if parts else ""


def render_conditions(data: StudyData) -> str:
    """A table of scores, and a panel of flights for each condition."""
    grouped = group_by_condition(data)
    if not grouped or data.conditions is None:
        return make_paragraph(
            "This study has no flights in conditions in which the thesis may fail."
        )
    conditions = data.conditions
    shown = (c.FLOWN_RADIAL, *(PREDICTOR_OF[key].median for key in COLOURS))
    limits = svg.find_decades(np.concatenate([conditions.table[name] for name in shown]))
    legend = make_legend(
        (("", colour, PREDICTOR_OF[key].title) for key, colour in COLOURS.items()),
        "Colours of predictors",
    )
    panels = join_panels(_make_panel(conditions, name, limits) for name in grouped)
    return make_wide_table(_tabulate(grouped), "words") + legend + panels


def _tabulate(grouped: dict[str, list[Score]]) -> Table:
    first = next(iter(grouped.values()))[0]
    header = ("Condition", "Thesis", *(title for _, title in SHOWN_SCORES), "triads")
    rows = tuple(
        (
            name,
            "holds" if does_thesis_hold(scores) else "does not hold",
            *(_format_chosen(scores, *key) for key, _ in SHOWN_SCORES),
            f"{scores[0].n:,}",
        )
        for name, scores in grouped.items()
    )
    title = (
        "Gyros calibrated at the mean; the predictors are the study's and do not know the "
        "condition. The thesis holds where the advantage and the removed variance are above 0 "
        f"with their {100 * first.confidence:g} % intervals: bootstrap over triads (coverage: "
        f"exact binomial), seed {first.seed}"
    )
    return Table(title, header, rows)


def _format_chosen(scores: Sequence[Score], name: str, predictor: str) -> str:
    chosen = [s for s in scores if (s.score, s.predictor) == (name, predictor)]
    return format_score(chosen[0]) if chosen else "–"


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
            ("predicted, m", "flown, m"),
            draw_equality(x, y) + scale_dots(paths, LARGE),
            f"{name}: flown against predicted error; the table above has its figures",
        ),
        notes=[
            f'<span class="weak">{what}</span>',
            f"{len(rows):,} flights of {rows[c.HOURS].max():g} h",
        ],
    )
