"""Files of a validation: validation.json, position_error.csv, validation.png."""

import csv
import json
from collections.abc import Sequence
from dataclasses import asdict
from importlib.metadata import version
from pathlib import Path
from typing import Any

import numpy as np

from ins_eval.common.metrics import median_interval
from ins_eval.study.study_data import StudyData
from ins_eval.study.summary.figure import draw_figure
from ins_eval.study.summary.outcome import SHOWN_PREDICTORS, Outcome, list_outcomes
from ins_eval.study.tables.columns import CIRCUMFERENCE_RULE, FIXED_RULE, TRIAD
from ins_eval.study.tables.score import AGREEMENT
from pyhrg.common.units import NAUTICAL_MILE

SCHEMA = "hrg-validation/2"
DOCUMENT, TABLE, FIGURE = "validation.json", "position_error.csv", "validation.png"
FILES = (DOCUMENT, TABLE, FIGURE)


def write_files(data: StudyData, folder: Path) -> None:
    """Write `FILES` into an existing folder."""
    outcomes = list_outcomes(data)
    text = json.dumps(_make_document(data, outcomes), indent=2) + "\n"
    (folder / DOCUMENT).write_text(text)
    _write_table(outcomes, folder / TABLE)
    draw_figure(outcomes, folder / FIGURE)


def _make_document(data: StudyData, outcomes: Sequence[Outcome]) -> dict[str, Any]:
    return {
        "schema": SCHEMA,
        "hrg": version("hrg"),
        "seed": data.about["seed"],
        "calibrations": {outcome.calibration: _describe(outcome) for outcome in outcomes},
        "cosimulated": [asdict(score) for score in data.select(AGREEMENT)],
    }


def _describe(outcome: Outcome) -> dict[str, Any]:
    low, high = outcome.flown_interval
    return {
        "mission": outcome.missions[0],
        "hours": outcome.hours,
        "predicted": {key: _describe_prediction(outcome, key) for key in SHOWN_PREDICTORS},
        "flown": {
            "radial_error_nmi": float(np.median(outcome.flown)) / NAUTICAL_MILE,
            "interval_95_nmi": [low / NAUTICAL_MILE, high / NAUTICAL_MILE],
            "n": len(outcome.flown),
        },
        "verdict": outcome.verdict,
    }


def _describe_prediction(outcome: Outcome, key: str) -> dict[str, Any]:
    ratio = outcome.ratio(key)
    return {
        "radial_error_nmi": float(np.median(outcome.predicted(key))) / NAUTICAL_MILE,
        "flown_over_predicted": ratio.value,
        "flown_over_predicted_interval_95": [ratio.low, ratio.high],
        "judged": ratio.judgement,
    }


def _write_table(outcomes: Sequence[Outcome], path: Path) -> None:
    """A row for each calibration and time, a column for each triad."""
    columns = [
        "calibration",
        "time_s",
        "predicted_fixed_position_m",
        "predicted_full_circumference_m",
        "flown_median_m",
        "flown_median_low_m",
        "flown_median_high_m",
        *(f"triad_{number}_m" for number in outcomes[0].flights[TRIAD]),
    ]
    with path.open("w", newline="") as file:
        writer = csv.writer(file)
        writer.writerow(columns)
        for outcome in outcomes:
            predicted = [outcome.predicted_growth(key) for key in (FIXED_RULE, CIRCUMFERENCE_RULE)]
            for time, *rules, flown in zip(outcome.time, *predicted, outcome.growth.T, strict=True):
                numbers = [time, *rules, np.median(flown), *median_interval(flown), *flown]
                writer.writerow([outcome.calibration, *(f"{value:.6g}" for value in numbers)])
