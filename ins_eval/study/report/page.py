"""The report as one HTML page, which needs no network and no script."""

from dataclasses import replace
from importlib.resources import files
from pathlib import Path

import numpy as np
import pandas as pd

from ins_eval.study.report.claim_table import render_claims
from ins_eval.study.report.claims import state_claims
from ins_eval.study.report.embedded import embed_study
from ins_eval.study.report.figures.filters import name_calibration
from ins_eval.study.report.lead_case import read_lead_case
from ins_eval.study.report.sections import make_sections
from ins_eval.study.specification import TEST
from ins_eval.study.study_data import StudyData
from ins_eval.study.tables import columns as c
from ins_eval.study.tables.score import ALL
from pyhrg.common.files import stage_files
from pyhrg.common.pages.markup import make_choice, make_paragraph
from pyhrg.common.pages.shell import make_contents, make_document, read_asset
from pyhrg.common.units import NAUTICAL_MILE

PAGE = "report.html"
TITLE = "Which bench test of a hemispherical resonator gyro predicts the position error?"


def render_page(data: StudyData) -> str:
    """The report; the same study gives the same bytes."""
    folder = files("ins_eval.study.report")
    shown = select_shown(data)
    sections = make_sections(shown)
    body = (
        f"<header><h1>{TITLE}</h1>{_render_opening(data)}{render_claims(data)}</header>"
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


def _render_opening(data: StudyData) -> str:
    """One sentence and one picture: those of the lead case; without one the claims' sentence."""
    case = read_lead_case(data.about)
    if case is None:
        return make_paragraph(state_claims(data), "headline")
    return (
        f"{make_paragraph(case.headline, 'headline')}"
        f'<div class="lead-case"><figure>{case.drawing}</figure>'
        f"<div>{''.join(map(make_paragraph, case.sentences))}</div></div>"
    )


def _render_filters(data: StudyData) -> str:
    """The form of the filters, hidden until the script runs."""
    every = {ALL: "all"}
    calibrations = every | {key: name_calibration(key) for key in data.calibrations}
    classes = every | {key: key for key in data.classes}
    predictors = every | {p.key: p.title for p in c.PREDICTORS}
    return (
        '<form id="filters" hidden aria-label="What the figures show">'
        + make_choice("calibration", "Calibration", calibrations, next(iter(data.calibrations)))
        + make_choice("class", "Class", classes, ALL)
        + make_choice("predictor", "Predictor", predictors, ALL)
        + '</form><p id="empty" class="headline" role="status" hidden></p>'
    )
