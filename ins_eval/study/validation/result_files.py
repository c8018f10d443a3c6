"""Files of a validation: validation.json, position_error.csv, validation.png."""

import json
from collections.abc import Sequence
from dataclasses import asdict
from importlib.metadata import version
from pathlib import Path
from typing import Any

import numpy as np
import pandas as pd

from ins_eval.common.metrics import median_interval
from ins_eval.study.report.claims import judge_claims, list_conditions
from ins_eval.study.report.lead_case import LeadCase, read_lead_case
from ins_eval.study.study_data import StudyData
from ins_eval.study.summary.figure import draw_figure
from ins_eval.study.summary.text import SHOWN_PREDICTORS, Outcome, list_outcomes
from ins_eval.study.tables.columns import (
    CIRCUMFERENCE_CLASS,
    CIRCUMFERENCE_RULE,
    FIXED_CLASS,
    FIXED_RULE,
    TRIAD,
)
from ins_eval.study.tables.score import AGREEMENT, CLASS_CONSTANT, STEADY_AGREEMENT
from pyhrg.common.units import NAUTICAL_MILE

SCHEMA = "hrg-validation/4"
PREDICTED = {
    "fixed_position_usual_rule": FIXED_RULE,
    "full_circumference_usual_rule": CIRCUMFERENCE_RULE,
    "fixed_position_class_constant": FIXED_CLASS,
    "full_circumference_class_constant": CIRCUMFERENCE_CLASS,
}
"""Predictors in position_error.csv by the middle of their columns' names; all grow with time."""
DOCUMENT, TABLE, FIGURE = "validation.json", "position_error.csv", "validation.png"
FILES = (DOCUMENT, TABLE, FIGURE)


def write_files(data: StudyData, folder: Path) -> None:
    """Write `FILES` into an existing folder."""
    outcomes = list_outcomes(data)
    text = json.dumps(_make_document(data, outcomes), indent=2) + "\n"
    (folder / DOCUMENT).write_text(text)
    _write_table(outcomes, folder / TABLE)
    draw_figure(data, folder / FIGURE)


def _make_document(data: StudyData, outcomes: Sequence[Outcome]) -> dict[str, Any]:
    case = read_lead_case(data.about)
    return {
        "schema": SCHEMA,
        "hrg": version("hrg"),
        "seed": data.about["seed"],
        **({} if case is None else _describe_lead(case)),
        "claims": {key: _describe_claims(data, key) for key in data.calibrations},
        "conditions": [asdict(condition) for condition in list_conditions(data)],
        "class_constants": [score.describe() for score in data.select(CLASS_CONSTANT)],
        "flights": [_describe(outcome) for outcome in outcomes],
        "linear_to_cosimulated": [
            score.describe() for key in (AGREEMENT, STEADY_AGREEMENT) for score in data.select(key)
        ],
    }


def _describe_lead(case: LeadCase) -> dict[str, Any]:
    """The lead case; all its flights are co-simulated."""
    flown, interval = case.final / NAUTICAL_MILE, case.median_interval
    return {
        "case": f"{case.device}, mean over the circumference removed, {case.mission}, "
        f"{case.time[-1] / 3600:g} h",
        "predicted": {
            "fixed_position": {
                "bias_stability_deg_h": case.fixed_stability,
                "radial_error_nmi": case.promised_fixed / NAUTICAL_MILE,
            },
            "full_circumference": {
                "bias_stability_deg_h": case.circumference_stability,
                "radial_error_nmi": case.promised_circumference / NAUTICAL_MILE,
            },
        },
        "flown": {
            "radial_error_nmi": float(np.median(flown)),
            "interval_95_nmi": interval and [end / NAUTICAL_MILE for end in interval],
            "smallest_nmi": float(flown.min()),
            "largest_nmi": float(flown.max()),
            "n": len(flown),
            "co_simulated": len(flown),
        },
        "sentences": list(case.sentences),
    }


def _describe_claims(data: StudyData, calibration: str) -> list[dict[str, Any]]:
    return [
        {
            "claim": each.claim.letter,
            "statement": each.claim.statement,
            "verdict": each.verdict,
            "n": each.n,
            "overall": [score.describe() for score in each.overall],
            "by_class": [score.describe() for score in each.by_class],
            "beside": [score.describe() for score in each.beside],
        }
        for each in judge_claims(data, calibration)
    ]


def _describe(outcome: Outcome) -> dict[str, Any]:
    low, high = outcome.flown_interval
    return {
        "calibration": outcome.calibration,
        "mission": outcome.mission,
        "hours": outcome.hours,
        "predicted": {key: _describe_prediction(outcome, key) for key in SHOWN_PREDICTORS},
        "flown": {
            "radial_error_nmi": float(np.median(outcome.flown)) / NAUTICAL_MILE,
            "interval_95_nmi": [low / NAUTICAL_MILE, high / NAUTICAL_MILE],
            "n": len(outcome.flown),
            "co_simulated": outcome.cosimulated,
        },
    }


def _describe_prediction(outcome: Outcome, key: str) -> dict[str, Any]:
    ratio = outcome.ratio(key)
    return {
        "radial_error_nmi": float(np.median(outcome.get_predicted(key))) / NAUTICAL_MILE,
        "flown_over_predicted": ratio.value,
        "flown_over_predicted_interval_95": [ratio.low, ratio.high],
    }


def _write_table(outcomes: Sequence[Outcome], path: Path) -> None:
    """A row for each calibration, mission and time, a column for each triad."""
    columns = [
        "calibration",
        "mission",
        "time_s",
        *(f"predicted_{name}_m" for name in PREDICTED),
        "flown_median_m",
        "flown_median_low_m",
        "flown_median_high_m",
        *(f"triad_{number}_m" for number in outcomes[0].flights[TRIAD]),
    ]
    rows = []
    for outcome in outcomes:
        predicted = [outcome.get_predicted_growth(key) for key in PREDICTED.values()]
        for time, *medians, flown in zip(outcome.time, *predicted, outcome.growth.T, strict=True):
            numbers = [float(time), *medians, np.median(flown), *median_interval(flown), *flown]
            rows.append((outcome.calibration, outcome.mission, *numbers))
    table = pd.DataFrame(rows, columns=columns)
    table.to_csv(path, index=False, float_format="%.6g", na_rep="nan", lineterminator="\r\n")
