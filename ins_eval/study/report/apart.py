"""Conditions in which the thesis may fail, judged apart from the classes: a table and panels."""

import html
from collections.abc import Sequence

import numpy as np
import pandas as pd

from ins_eval.study.report.figures.dots import LARGE, positive
from ins_eval.study.report.requirements import figure
from ins_eval.study.report.result import CONDITIONS, StudyResult
from ins_eval.study.tables import columns as c
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
from pyhrg.common.pages.markup import Table, paragraph, table

FIXED, CIRCUMFERENCE, FITTED = "fixed_rule", "circumference_rule", "fitted_map"
COLOURS = {FIXED: "c1", CIRCUMFERENCE: "c0", FITTED: "c2"}
THESIS = ((ADVANTAGE, CIRCUMFERENCE), (VARIANCE_REMOVED, FITTED))
"""Scores above 0: the circumference tells more than the fixed position, and the map than it."""
TOLD = (
    ((MEDIAN_RATIO, FIXED), "flown / promised, fixed position"),
    ((MEDIAN_RATIO, CIRCUMFERENCE), "flown / promised, full circumference"),
    ((SPEARMAN, CIRCUMFERENCE), "rank correlation, full circumference"),
    ((ADVANTAGE, CIRCUMFERENCE), "advantage of the circumference, |ln|"),
    ((R2_RADIAL, FITTED), "R2, fitted map"),
    ((VARIANCE_REMOVED, FITTED), "removed by the fitted map beyond the circumference"),
    ((COVERAGE, FITTED), "inside the fitted map's intervals"),
)


def holds(scores: Sequence[Score]) -> bool:
    """Whether the thesis does, in a condition with these scores."""
    holding = {(s.score, s.predictor) for s in scores if s.holds}
    return holding.issuperset(THESIS)


def by_condition(result: StudyResult) -> dict[str, list[Score]]:
    """Scores of the conditions, in the order of the study; shuffled ones left out."""
    if result.apart is None:
        return {}
    scores = [s for s in result.apart.scores if not s.shuffled]
    names = dict.fromkeys(result.apart.table[c.CLASS])
    return {name: [s for s in scores if s.mission_class == name] for name in names}


def sentence(result: StudyResult) -> str:
    """In which conditions the thesis does not hold, and in which it does; "" without any."""
    found = by_condition(result)
    failing = [name for name, scores in found.items() if not holds(scores)]
    holding = [name for name in found if name not in failing]
    told = [f"Apart from these classes, it does not hold: {'; '.join(failing)}."] if failing else []
    told += [f"It holds as well: {'; '.join(holding)}."] if holding else []
    return " ".join(told)


def apart(result: StudyResult) -> str:
    """What is found in each condition, and each of its flights."""
    found = by_condition(result)
    if not found or result.apart is None:
        return paragraph("No flights in conditions in which the thesis may fail: none were asked.")
    shown = (c.FLOWN_RADIAL, *map(_median, COLOURS))
    limits = svg.decades(np.concatenate([result.apart.table[name] for name in shown]))
    drawn = "".join(_figure(result.apart, name, limits) for name in found)
    return f'{_table(found)}{_legend()}<div class="panels">{drawn}</div>'


def _table(found: dict[str, list[Score]]) -> str:
    first = next(iter(found.values()))[0]
    header = ("Condition", "Thesis", *(title for _, title in TOLD), "triads")
    rows = tuple(
        (
            name,
            "holds" if holds(scores) else "does not hold",
            *(_figure_of(scores, *key) for key, _ in TOLD),
            f"{scores[0].n:,}",
        )
        for name, scores in found.items()
    )
    title = (
        "Gyros calibrated at the mean; the predictors are the study's and know nothing of the "
        "condition. The thesis holds where the advantage and what the map removes are above 0 "
        f"with their intervals: {100 * first.confidence:g} %, bootstrap over triads (coverage: "
        f"exact binomial), seed {first.seed}"
    )
    return f'<div class="wide words">{table(Table(title, header, rows))}</div>'


def _figure_of(scores: Sequence[Score], name: str, predictor: str) -> str:
    chosen = [s for s in scores if (s.score, s.predictor) == (name, predictor)]
    return figure(chosen[0]) if chosen else "–"


def _figure(flights: StudyResult, name: str, limits: tuple[float, float]) -> str:
    rows = flights.table[flights.table[c.CLASS] == name]
    x, y = svg.across(*limits), svg.up(*limits)
    ends = np.array(limits)
    drawn = "".join(_dots(rows, predictor, x, y) for predictor in COLOURS)
    title = html.escape(name)
    what = html.escape(str(flights.about.get(CONDITIONS, {}).get(name, "")))
    return (
        f'<figure><figcaption><b>{title}</b><br><span class="weak">{what}</span><br>'
        f"{len(rows):,} flights of {rows[c.HOURS].max():g} h</figcaption>"
        f'<svg viewBox="0 0 {svg.WIDTH} {svg.HEIGHT}" role="img" '
        f'aria-label="{title}: flown against predicted error; the table above has its figures">'
        f"{svg.frame(x, y, 'predicted, m', 'flown, m')}"
        f'<path class="equal" d="{svg.line(x(ends), y(ends))}"/>{drawn}</svg></figure>'
    )


def _dots(rows: pd.DataFrame, predictor: str, x: svg.Scale, y: svg.Scale) -> str:
    shown = positive(rows, _median(predictor), c.FLOWN_RADIAL)
    at = svg.points(x(shown[_median(predictor)]), y(shown[c.FLOWN_RADIAL]))
    return (
        f'<g transform="scale({1 / svg.FINENESS:g})" stroke-width="{svg.FINENESS * LARGE:g}">'
        f'<path class="dots {COLOURS[predictor]}" d="{at}"/></g>'
    )


def _median(predictor: str) -> str:
    return next(p.median for p in c.PREDICTORS if p.key == predictor)


def _legend() -> str:
    titles = {p.key: p.title for p in c.PREDICTORS}
    entries = "".join(
        f'<li><svg class="{colour}" width="14" height="14" aria-hidden="true">'
        f'<circle cx="7" cy="7" r="5"/></svg> {html.escape(titles[key])}</li>'
        for key, colour in COLOURS.items()
    )
    return f'<ul class="legend" aria-label="Colours of predictors">{entries}</ul>'
