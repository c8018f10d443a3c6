"""The report as one HTML page, which needs no network and no script: its sections in order, and for
its script the points and each panel's scores in words.
"""

import math
from collections.abc import Iterable
from dataclasses import replace
from importlib.resources import files
from pathlib import Path
from typing import Any

import numpy as np
import pandas as pd

from ins_eval.study.report.claim_table import render_claims, render_conditions
from ins_eval.study.report.claims import format_score, state_claims
from ins_eval.study.report.figures.budget import render_budget
from ins_eval.study.report.figures.dots import render_ranking, render_scatter
from ins_eval.study.report.figures.matrix import IntervalAxis, render_matrices
from ins_eval.study.report.figures.parts import make_fold, name_calibration
from ins_eval.study.report.figures.phase import render_phase_diagram
from ins_eval.study.report.lead_case import read_lead_case
from ins_eval.study.report.own_gyro import render_own_gyro
from ins_eval.study.specification import TEST
from ins_eval.study.study_data import (
    CONDITIONS_KEY,
    LEAD_KEY,
    PHASE_KEY,
    WITNESS_KEY,
    StudyData,
)
from ins_eval.study.tables import columns as c
from ins_eval.study.tables import score
from ins_eval.study.tables.columns import COLUMNS
from ins_eval.study.tables.score import ALL, MEDIAN_RATIO, R2_RADIAL, SPEARMAN, Score
from ins_eval.study.witness.judge import WitnessScore, list_figures
from pyhrg.common.files import stage_files
from pyhrg.common.pages.markup import (
    PageSection,
    Table,
    embed_json,
    make_choice,
    make_contents,
    make_document,
    make_paragraph,
    make_wide_table,
    read_asset,
)
from pyhrg.common.units import NAUTICAL_MILE

DIGITS = 4
"""Significant digits of a point's numbers. Chosen: more are not visible."""
NAMES = (c.CALIBRATION, c.CLASS, c.MISSION, c.FLOWN_BY)
NUMBERS = (c.FLOWN_RADIAL, *(p.median for p in c.PREDICTORS))
SHORT_NAMES = {R2_RADIAL: "R²", MEDIAN_RATIO: "flown/predicted", SPEARMAN: "Spearman"}


def embed_study(data: StudyData) -> str:
    """JSON that can stand inside a script element."""
    table = data.table
    content: dict[str, Any] = {
        "triad": table[c.TRIAD].tolist(),
        "names": {name: _encode(table[name]) for name in NAMES},
        "numbers": {name: [_round(v) for v in table[name]] for name in NUMBERS},
        "captions": list_captions(data.scores),
    }
    return embed_json(content)


def list_captions(scores: Iterable[Score]) -> dict[str, str]:
    """Scores with intervals, by panel, calibration and class, which are joined by "|"."""
    captions: dict[str, list[str]] = {}
    for s in scores:
        if s.score in SHORT_NAMES and not s.shuffled and s.predictor:
            panel = f"rank_{s.predictor}" if s.score == SPEARMAN else s.predictor
            key = "|".join((panel, s.calibration, s.mission_class))
            text = f"{SHORT_NAMES[s.score]} {format_score(s)}, n {s.n:,}"
            captions.setdefault(key, []).append(text)
    return {key: "; ".join(parts) for key, parts in sorted(captions.items())}


def _encode(column: pd.Series) -> dict[str, Any]:
    codes, levels = pd.factorize(column, sort=True)
    return {"levels": list(map(str, levels)), "codes": codes.tolist()}


def _round(value: float) -> float | int | None:
    if not math.isfinite(value):
        return None
    short = float(f"{value:.{DIGITS}g}")
    return int(short) if short.is_integer() else short


R2 = IntervalAxis(-0.2, 1.0, 1.0)
RATIO = IntervalAxis(0.1, 100.0, 1.0, log=True)
SKILL = IntervalAxis(-0.5, 1.0, 0.0)
CORRELATION = IntervalAxis(-0.5, 1.0, 0.0)
DIFFERENCE = IntervalAxis(0.0, 0.05, 0.01)


def make_sections(data: StudyData) -> list[PageSection]:
    """The sections, by anchor, title and content."""
    return [
        PageSection("own", "Predict the error of your own gyro", render_own_gyro(data)),
        PageSection("predicted", "Predicted against flown", _render_predictions(data)),
        PageSection("size", "Size of the error: flown over predicted", _render_ratios(data)),
        PageSection("ranking", "Ranking of gyros", _render_ranking(data)),
        PageSection("coverage", "Intervals and their coverage", _render_coverage(data)),
        PageSection("breaks", "Conditions in which claims fail", render_conditions(data)),
        *_make_witness_section(data),
        PageSection("phase", "Where each test tells the truth", render_phase_diagram(data)),
        PageSection("budget", "Error budget", _render_budget(data)),
        PageSection("control", "Negative control", _render_control(data)),
        PageSection("method", "What was studied, and how", _render_method(data)),
    ]


def _render_predictions(data: StudyData) -> str:
    lead = (
        "Each dot is a triad's flight. On the dashed line the flown error is the predicted one; "
        "above it the flown error is larger. R2 is 1 for exact predictions; below 0 the mean of "
        "the flown errors is nearer to them than the predictions are."
    )
    components = render_matrices(data, score.R2_COMPONENTS, R2)
    return (
        make_paragraph(lead)
        + render_scatter(data)
        + render_matrices(data, score.R2_RADIAL, R2)
        + make_fold(
            "R2 by components, and without the mounting",
            components + render_matrices(data, score.R2_MOUNTED, R2),
        )
    )


def _render_ratios(data: StudyData) -> str:
    lead = (
        "1 is an accurate prediction; at 10 the flown error is ten times the predicted one. The "
        "usual rule takes 0.01 deg/h for 1 nmi/h; the class constant is that of a mission class, "
        "from linear flights of the training triads. It makes any figure right in the median, so "
        "that the circumference must also save interval score over figures that know less."
    )
    constants = render_matrices(data, score.CLASS_CONSTANT, RATIO)
    skills = (
        render_matrices(data, key, SKILL)
        for key in (score.SKILL_OVER_FIXED, score.SKILL_OVER_CLASS)
    )
    ratios = render_matrices(data, score.MEDIAN_RATIO, RATIO)
    return make_paragraph(lead) + ratios + "".join(skills) + constants


def _render_ranking(data: StudyData) -> str:
    lead = (
        "Does a gyro that the bench finds better also err less? The upper table and the dots are "
        "of the linear model: the rms over 16 power-on angles and three mountings removes the luck "
        "of a single flight, and is not flown. The population draws a gyro's noise independently "
        "of its map, so that the fixed position's rank is 0 by construction. The last tables have "
        "the co-simulated flights, each from one start angle."
    )
    ranks = render_matrices(data, score.SPEARMAN, CORRELATION)
    flights = render_matrices(data, score.FLIGHT_SPEARMAN, CORRELATION)
    gains = render_matrices(data, score.FLIGHT_SPEARMAN_GAIN, CORRELATION)
    return make_paragraph(lead) + render_ranking(data) + ranks + flights + gains


def _render_coverage(data: StudyData) -> str:
    level = data.interval_percent / 100
    axis = IntervalAxis(min(0.5, level / 2), 1.0, level)
    lead = f"Intervals that should contain {data.interval_percent:g} % of the flown errors."
    return make_paragraph(lead) + render_matrices(data, score.COVERAGE, axis)


def _render_budget(data: StudyData) -> str:
    lead = "The parts of the error by the linear model, and the error that was flown."
    return make_paragraph(lead) + render_budget(data)


def _render_control(data: StudyData) -> str:
    lead = "Each triad gets the predictions of another one; these must not predict its error."
    return make_paragraph(lead) + "".join(
        render_matrices(data, key, axis, shuffled=True)
        for key, axis in ((score.SPEARMAN, CORRELATION), (score.R2_COMPONENTS, R2))
    )


def _make_witness_section(data: StudyData) -> list[PageSection]:
    """One section where a study has read channels, else none."""
    scores = [WitnessScore(**each) for each in data.about.get(WITNESS_KEY, [])]
    if not scores:
        return []
    lead = (
        "Forces, frequency and pattern angle of each gyro were recorded in flight. They tell how "
        "far its map has drifted since the bench. R2 is that of the horizontal error; a corrected "
        "flight is the same record, navigated after the estimated maps were taken out. The control "
        "has the channels of another triad."
    )
    header = ("calibration", "class", "self-test", "score", "value (95 %)", "triads")
    table = make_wide_table(Table("Self-witness", header, list_figures(scores)))
    title = "What the gyros tell of themselves"
    return [PageSection("witness", title, make_paragraph(lead) + table)]


def _render_method(data: StudyData) -> str:
    left_out = (CONDITIONS_KEY, LEAD_KEY, PHASE_KEY, WITNESS_KEY)
    facts = tuple((k, _format_fact(v)) for k, v in data.about.items() if k not in left_out)
    rows = tuple((column.name, column.unit or "–", column.what) for column in COLUMNS)
    columns = make_wide_table(Table("Columns", ("name", "unit", ""), rows))
    return (
        make_wide_table(Table("What was studied", ("", ""), facts))
        + "".join(
            render_matrices(data, key, DIFFERENCE)
            for key in (score.AGREEMENT, score.STEADY_AGREEMENT)
        )
        + make_fold("Columns of study.parquet", columns)
    )


def _format_fact(value: Any) -> str:
    if isinstance(value, dict):
        return ", ".join(f"{key} {_format_fact(inner)}" for key, inner in value.items())
    return ", ".join(map(_format_fact, value)) if isinstance(value, list) else str(value)


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
