"""The report as one HTML page, which needs no network and no script."""

import html
from collections.abc import Sequence
from dataclasses import replace
from importlib.resources import files
from pathlib import Path

import numpy as np
import pandas as pd

from ins_eval.study.report.claims import describe_claim, describe_conditions, judge_claims
from ins_eval.study.report.embedded import embed_study
from ins_eval.study.report.figures.filters import name_calibration
from ins_eval.study.report.lead_case import read_lead_case
from ins_eval.study.report.sections import make_sections
from ins_eval.study.specification import TEST
from ins_eval.study.study_data import StudyData
from ins_eval.study.tables import columns as c
from ins_eval.study.tables.score import ALL
from pyhrg.common.files import stage_files
from pyhrg.common.pages.markup import make_paragraph
from pyhrg.common.pages.shell import make_contents, make_document, read_asset
from pyhrg.common.units import NAUTICAL_MILE

PAGE = "report.html"
TITLE = "Which bench test of a hemispherical gyro tells the navigator's error?"


def render_page(data: StudyData) -> str:
    """The report; the same study gives the same bytes."""
    folder = files("ins_eval.study.report")
    shown = select_shown(data)
    sections = make_sections(shown)
    body = (
        f"<header><h1>{TITLE}</h1>{_render_lead(data)}{_render_claims(data)}</header>"
        f"{make_contents(sections)}"
        f"{_render_filters(shown)}<main>{''.join(section.markup for section in sections)}</main>"
        '<div id="tip" role="status" aria-live="polite" hidden></div>'
        f'<script type="application/json" id="study">{embed_study(shown)}</script>'
    )
    return make_document(TITLE, read_asset(folder, "page.css"), body, read_asset(folder, "page.js"))


def select_shown(data: StudyData) -> StudyData:
    """The study with its judged triads alone, and with distances in nautical miles."""
    return replace(data, table=_convert_distances(data.table[data.table[c.ROLE] == TEST]))


def _convert_distances(table: pd.DataFrame) -> pd.DataFrame:
    """The table with columns in m divided by a nautical mile."""
    converted = table.copy()
    for column in c.COLUMNS:
        if column.unit == "m" and column.kind == "numbers":
            converted[column.name] = [np.asarray(v) / NAUTICAL_MILE for v in table[column.name]]
        elif column.unit == "m":
            converted[column.name] = table[column.name] / NAUTICAL_MILE
    return converted


def write_page(data: StudyData, folder: Path) -> None:
    """Write report.html into a folder, whole or not at all.

    Raises:
        OSError: the folder can't be written.
    """
    with stage_files(folder, (PAGE,)) as aside:
        (aside / PAGE).write_text(render_page(data), encoding="utf-8")


def _render_lead(data: StudyData) -> str:
    """The lead case: three sentences and a drawing; nothing without one."""
    case = read_lead_case(data.about)
    if case is None:
        return ""
    return (
        f'<p class="headline">{html.escape(case.headline)}</p>'
        f'<div class="lead-case"><figure>{case.drawing}</figure>'
        f"<div>{''.join(map(make_paragraph, case.sentences))}</div></div>"
    )


def _render_claims(data: StudyData) -> str:
    verdicts = "".join(
        f"<div><h3>{html.escape(name_calibration(key).capitalize())}</h3>"
        f"<ul>{_list_items([describe_claim(each) for each in judge_claims(data, key)])}</ul></div>"
        for key in data.list_values(c.CALIBRATION)
    )
    failing = describe_conditions(data)
    conditions = f"<p>(d) Where claims fail beside the classes:</p><ul>{_list_items(failing)}</ul>"
    scope = (
        "Judged triads were not used to make any predictor; they are co-simulated, three FMUs at "
        "1 kHz with all noise and a navigator, unless it says linear. In brackets: 95 % intervals."
    )
    return (
        f'<div class="verdicts">{verdicts}</div>{conditions if failing else ""}'
        f"{make_paragraph(scope, 'weak')}"
    )


def _list_items(sentences: Sequence[str]) -> str:
    return "".join(f"<li>{html.escape(sentence)}</li>" for sentence in sentences)


def _render_filters(data: StudyData) -> str:
    """The form of the filters, hidden until the script runs."""
    calibrations = {key: name_calibration(key) for key in data.list_values(c.CALIBRATION)}
    classes = {key: key for key in data.list_values(c.CLASS)}
    predictors = {p.key: p.title for p in c.PREDICTORS}
    return (
        '<form id="filters" hidden aria-label="What the figures show">'
        + _render_choice("calibration", "all", calibrations, next(iter(calibrations)))
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
