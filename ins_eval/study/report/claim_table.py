"""The claims as one table: a row for each figure that is required, a column for each class."""

import html
from collections.abc import Sequence

from ins_eval.study.report.claims import (
    JudgedClaim,
    judge_claims,
    judge_conditions,
    list_conditions,
    name_requirement,
)
from ins_eval.study.report.figures.matrix import render_estimate
from ins_eval.study.report.figures.parts import make_fold, name_calibration
from ins_eval.study.study_data import CONDITIONS_KEY, StudyData
from ins_eval.study.tables.score import ALL, FAILS, HOLDS, Score
from pyhrg.common.pages.markup import make_paragraph

CAPTION = (
    "Each figure with its 95 % interval; n judged triads, which no predictor was made on. A claim "
    "holds in a class if the whole interval of each of its figures is within what is required; it "
    "is undecided if a part is. One valid requirement in twenty fails by chance. Grey figures "
    "explain a claim and decide nothing. The population draws a gyro's noise independently of its "
    "map: the fixed position's rank correlation is 0 by construction."
)
CONDITION = "linear flights, mean calibrated"
NO_CONDITIONS = "This study has no flights in conditions in which a claim may fail."


def render_claims(data: StudyData) -> str:
    """Claims (a) to (c) by class for each calibration, the mean first; then (d)."""
    classes = data.classes
    bodies = "".join(_render_calibration(data, name, classes) for name in data.calibrations)
    return _make_table(CAPTION, classes, bodies + _render_failures(data, len(classes)))


def render_conditions(data: StudyData) -> str:
    """What differs in each condition, and the claims by condition."""
    if data.conditions is None:
        return make_paragraph(NO_CONDITIONS)
    words, names = data.about.get(CONDITIONS_KEY, {}), data.conditions.classes
    listed = "".join(
        f"<li><b>{html.escape(name)}</b>: {html.escape(words.get(name, ''))}</li>" for name in names
    )
    title = (
        "Gyros calibrated at the mean, flown by the linear model; the predictors are the study's "
        "and do not know the condition"
    )
    rows = "".join(_render_claim(each, names) for each in judge_conditions(data))
    table = _make_table(title, names, f"<tbody>{rows}</tbody>")
    return f"<ul>{listed}</ul>{make_fold('All figures by condition', table)}"


def _make_table(caption: str, classes: Sequence[str], bodies: str) -> str:
    heads = ("Claim and verdict", "Figure, and what is required", *classes, "n")
    head = "".join(f'<th scope="col">{html.escape(name)}</th>' for name in heads)
    return (
        f'<div class="wide"><table class="claims"><caption>{html.escape(caption)}</caption>'
        f"<thead><tr>{head}</tr></thead>{bodies}</table></div>"
    )


def _render_calibration(data: StudyData, calibration: str, classes: Sequence[str]) -> str:
    """The claims of a calibration under its name."""
    name = name_calibration(calibration).capitalize()
    rows = "".join(_render_claim(each, classes) for each in judge_claims(data, calibration))
    rows = rows or f'<tr><td colspan="{len(classes) + 3}">This study has no scores of it.</td></tr>'
    width = len(classes) + 3
    return (
        f'<tbody><tr class="group"><th scope="rowgroup" colspan="{width}">{html.escape(name)}</th>'
        f"</tr>{rows}</tbody>"
    )


def _render_claim(judged: JudgedClaim, classes: Sequence[str]) -> str:
    """Rows of a claim: its requirements, then the figures that explain it."""
    scores = [s for s in (*judged.by_class, *judged.beside) if s.mission_class != ALL]
    kinds = list(dict.fromkeys((s.score, s.predictor) for s in scores))
    rows = []
    for number, kind in enumerate(kinds):
        here = {s.mission_class: s for s in scores if (s.score, s.predictor) == kind}
        first = next(iter(here.values()))
        asked = f"<br><small>required: {html.escape(first.asked)}</small>" if first.asked else ""
        cells = "".join(_render_cell(name, here.get(name)) for name in classes)
        counts = " to ".join(str(n) for n in sorted({s.n for s in here.values()}))
        claim = _render_head(judged.claim.letter, judged.claim.statement, judged.verdict, kinds)
        style = "" if first.asked else ' class="beside"'
        rows.append(
            f"<tr{style}>{'' if number else claim}"
            f"<td>{html.escape(name_requirement(judged.claim, first))}{asked}</td>"
            f"{cells}{_render_count(counts)}</tr>"
        )
    return "".join(rows)


def _render_head(letter: str, statement: str, verdict: str, rows: Sequence[object]) -> str:
    style = verdict if verdict in (HOLDS, FAILS) else "undecided"
    return (
        f'<th scope="rowgroup" rowspan="{len(rows)}">({letter}) {html.escape(statement)}'
        f'<br><span class="{style}">{verdict}</span></th>'
    )


def _render_cell(name: str, score: Score | None) -> str:
    label = f' data-label="{html.escape(name)}"'
    if score is None:
        return f"<td{label}>–</td>"
    verdict = f'<br><span class="{score.verdict}">{score.verdict}</span>' if score.verdict else ""
    return f"<td{label}><span>{render_estimate(score)}{verdict}</span></td>"


def _render_count(text: str) -> str:
    return f'<td data-label="n">{text}</td>'


def _render_failures(data: StudyData, width: int) -> str:
    """Claim (d): a row for each condition with what fails in it."""
    results = list_conditions(data)
    failed = sum(bool(each.figures[FAILS]) for each in results)
    verdict = f"claims fail in {failed} of {len(results)} conditions"
    statement = "Where the claims fail beside the classes"
    rows = []
    for number, each in enumerate(results):
        head = "" if number else _render_head("d", statement, verdict, results)
        text = "<br>".join(map(html.escape, each.lines))
        rows.append(
            f"<tr>{head}<td>{html.escape(each.name)}<br><small>{CONDITION}</small></td>"
            f'<td class="failing" colspan="{width}">{text}</td>'
            f"{_render_count(str(each.n))}</tr>"
        )
    if not rows:
        rows.append(
            f'<tr><th scope="row">(d) {statement}</th><td colspan="{width + 2}">{NO_CONDITIONS}'
            "</td></tr>"
        )
    return f"<tbody>{''.join(rows)}</tbody>"
