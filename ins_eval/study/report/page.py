"""The report as one HTML page, which needs no network and no script."""

import html
from collections.abc import Sequence
from importlib.resources import files
from pathlib import Path

from ins_eval.study.report.condition_section import summarize_conditions
from ins_eval.study.report.embedded import embed_study
from ins_eval.study.report.figures.filters import name_calibration
from ins_eval.study.report.sections import make_sections
from ins_eval.study.report.verdict import count_requirements, list_verdicts
from ins_eval.study.specification import TEST
from ins_eval.study.study_data import StudyData
from ins_eval.study.tables import columns as c
from ins_eval.study.tables.score import ALL
from pyhrg.common.files import stage_files
from pyhrg.common.pages.markup import make_paragraph
from pyhrg.common.pages.shell import make_contents, make_document, read_asset

PAGE = "report.html"
TITLE = "Does the full circumference predict the navigator's error?"


def render_page(data: StudyData) -> str:
    """The report; the same study gives the same bytes."""
    folder = files("ins_eval.study.report")
    sections = make_sections(data)
    body = (
        f"<header><h1>{TITLE}</h1>{_render_verdict(data)}</header>{make_contents(sections)}"
        f"{_render_filters(data)}<main>{''.join(section.markup for section in sections)}</main>"
        '<div id="tip" role="status" aria-live="polite" hidden></div>'
        f'<script type="application/json" id="study">{embed_study(data)}</script>'
    )
    return make_document(TITLE, read_asset(folder, "page.css"), body, read_asset(folder, "page.js"))


def write_page(data: StudyData, folder: Path) -> None:
    """Write report.html into a folder, whole or not at all.

    Raises:
        OSError: the folder can't be written.
    """
    with stage_files(folder, (PAGE,)) as aside:
        (aside / PAGE).write_text(render_page(data), encoding="utf-8")


def _render_verdict(data: StudyData) -> str:
    verdicts = "".join(
        f"<div><h3>{html.escape(title.capitalize())}</h3><ul>{_list_items(sentences)}</ul></div>"
        for title, sentences in list_verdicts(data)
        if sentences
    )
    conditions = summarize_conditions(data)
    scope = "All figures are of gyros and mission classes on which no predictor was made."
    return (
        f'<p class="headline">{html.escape(count_requirements(data))} '
        '<a href="#breaks">Which, and where not.</a></p>'
        f"{make_paragraph(conditions) if conditions else ''}"
        f'<div class="verdicts">{verdicts}</div>{make_paragraph(scope, "weak")}'
    )


def _list_items(sentences: Sequence[str]) -> str:
    return "".join(f"<li>{html.escape(sentence)}</li>" for sentence in sentences)


def _render_filters(data: StudyData) -> str:
    """The form of the filters, hidden until the script runs."""
    calibrations = {key: name_calibration(key) for key in data.list_values(c.CALIBRATION)}
    halves = {key: f"{key} half" for key in data.list_values(c.HALF)}
    classes = {key: key for key in data.list_values(c.CLASS)}
    predictors = {p.key: p.title for p in c.PREDICTORS}
    return (
        '<form id="filters" hidden aria-label="What the figures show">'
        + _render_choice("calibration", "all", calibrations, next(iter(calibrations)))
        + _render_choice("half", "both", halves, TEST)
        + _render_choice("class", "all", classes, ALL)
        + _render_choice("predictor", "all", predictors, ALL)
        + "</form>"
    )


def _render_choice(key: str, every: str, options: dict[str, str], selected: str) -> str:
    listed = "".join(
        f'<option value="{html.escape(value)}"{" selected" if value == selected else ""}>'
        f"{html.escape(text)}</option>"
        for value, text in {ALL: every, **options}.items()
    )
    select = f'<select name="{key}" autocomplete="off">{listed}</select>'
    return f"<label>{key.capitalize()} {select}</label>"
