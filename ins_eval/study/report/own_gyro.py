"""The user's own gyro: a form that predicts its error from bench figures and a mission."""

import html
import math
from typing import Any

from ins_eval.study.report.figures.parts import name_calibration
from ins_eval.study.report.lead_case import read_lead_case
from ins_eval.study.report.mission_constants import (
    BEYOND,
    LARGEST_STABILITY,
    METRES_PER_DEG_H,
    SENTENCE,
    SMALLEST_STABILITY,
    TESTS,
    MissionConstant,
    read_constants,
)
from ins_eval.study.study_data import StudyData
from pyhrg.common.pages.markup import embed_json, make_choice, make_paragraph

LEAD = (
    "Type what your bench says of your gyros (rms of the three): their bias stability at a fixed "
    "position, over the full circumference, or both. The error is that of the usual rule times "
    "the constant of the mission's class; its interval contains start angles, warming and mounting."
)
COMMAND = "hrg predict {mission} --fixed {fixed_deg_h} --circumference {circumference_deg_h}"
"""The command that prints the same."""


def render_own_gyro(data: StudyData) -> str:
    """The form, which the script fills in; without a script the command that prints the same."""
    shown = _choose_figures(data)
    command = COMMAND.format(mission=data.missions[0], **shown)
    inputs = "".join(
        f"<label>{test.name.capitalize()}, deg/h "
        f'<input name="{test.key}" inputmode="decimal" value="{shown[test.key]}" size="8" '
        'autocomplete="off"></label>'
        for test in TESTS
    )
    missions = make_choice("mission", "Mission", {name: name for name in data.missions})
    calibrations = make_choice(
        "calibration", "Calibration", {name: name_calibration(name) for name in data.calibrations}
    )
    return (
        f"{make_paragraph(LEAD)}"
        f'<form id="own-gyro" hidden>{inputs}{missions}{calibrations}</form>'
        '<output id="own-error" form="own-gyro"></output>'
        f'<p class="weak">In the terminal: <code>{html.escape(command)} --study DIR</code></p>'
        f'<script type="application/json" id="constants">{_embed_constants(data)}</script>'
    )


def _choose_figures(data: StudyData) -> dict[str, str]:
    """Figures that the form starts with, deg/h by test: those of the lead case, else the medians of
    the study's triads."""
    case = read_lead_case(data.about)
    medians = (float(data.table[test.figure].median()) for test in TESTS)
    stabilities = medians if case is None else (case.fixed_stability, case.circumference_stability)
    return {test.key: f"{value:.2g}" for test, value in zip(TESTS, stabilities, strict=True)}


def _embed_constants(data: StudyData) -> str:
    """JSON for the page's script: the constants, and the words of a prediction."""
    content = {
        "sentence": SENTENCE,
        "beyond": BEYOND,
        "level": f"{data.interval_percent:g}",
        "metres_per_deg_h": METRES_PER_DEG_H,
        "range": [SMALLEST_STABILITY, LARGEST_STABILITY],
        "constants": [
            _describe(each) for each in read_constants(data) if math.isfinite(each.median)
        ],
    }
    return embed_json(content)


def _describe(constant: MissionConstant) -> dict[str, Any]:
    return {
        "key": constant.test.key,
        "test": constant.test.name,
        "mission": constant.mission,
        "calibration": constant.calibration,
        "hours": constant.hours,
        "ratios": [constant.median, constant.low, constant.high],
        "spearman": f"{constant.spearman:.2f}",
        "ends": [constant.smallest, constant.largest],
    }
