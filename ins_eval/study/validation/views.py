"""Views of a study's results: validation.json, position_error.csv, validation.png."""

import csv
import json
from dataclasses import asdict, replace
from importlib.metadata import version
from pathlib import Path
from typing import Any

import numpy as np

from ins_eval.common.metrics import median_interval
from ins_eval.study.report.result import StudyResult, read
from ins_eval.study.run.block import Arrays
from ins_eval.study.run.run import Experiment
from ins_eval.study.specification import Study
from ins_eval.study.tables.score import AGREEMENT
from ins_eval.study.validation.figure import draw
from ins_eval.study.validation.outcome import CIRCUMFERENCE, FIXED, TOLD, Outcome, outcomes
from pyhrg.common.units import NAUTICAL_MILE

SCHEMA = "hrg-validation/2"
DOCUMENT, TABLE, FIGURE = "validation.json", "position_error.csv", "validation.png"


def with_views(study: Experiment) -> Experiment:
    """The study's experiment, which writes views of its results too."""

    def conclude(what: Study, arrays: Arrays, folder: Path) -> None:
        study.conclude(what, arrays, folder)
        write(read(folder), folder)

    return replace(study, conclude=conclude, files=(DOCUMENT, TABLE, FIGURE, *study.files))


def write(result: StudyResult, folder: Path) -> None:
    """Write the views into an existing folder."""
    told = list(outcomes(result))
    text = json.dumps(document(result), indent=2) + "\n"
    (folder / DOCUMENT).write_text(text)
    _write_errors(told, folder / TABLE)
    draw(told, folder / FIGURE)


def document(result: StudyResult) -> dict[str, Any]:
    """Content of validation.json."""
    return {
        "schema": SCHEMA,
        "hrg": version("hrg"),
        "seed": result.about["seed"],
        "calibrations": {o.calibration: _outcome(o) for o in outcomes(result)},
        "cosimulated": [asdict(s) for s in result.picked(AGREEMENT)],
    }


def _outcome(outcome: Outcome) -> dict[str, Any]:
    low, high = outcome.interval
    return {
        "mission": outcome.mission,
        "hours": outcome.hours,
        "predicted": {key: _promise(outcome, key) for key in TOLD},
        "flown": {
            "radial_error_nmi": float(np.median(outcome.flown)) / NAUTICAL_MILE,
            "interval_95_nmi": [low / NAUTICAL_MILE, high / NAUTICAL_MILE],
            "n": len(outcome.flown),
        },
        "verdict": outcome.verdict,
    }


def _promise(outcome: Outcome, key: str) -> dict[str, Any]:
    kept = outcome.ratio(key)
    return {
        "radial_error_nmi": float(np.median(outcome.predicted(key))) / NAUTICAL_MILE,
        "flown_over_predicted": kept.value,
        "flown_over_predicted_interval_95": [kept.low, kept.high],
        "judged": kept.word,
    }


def _write_errors(told: list[Outcome], path: Path) -> None:
    """A row a calibration and time; a column a triad."""
    triads = told[0].flights["triad"]
    names = [f"triad_{number}_m" for number in triads]
    ends = ["flown_median_low_m", "flown_median_high_m"]
    promises = ["predicted_fixed_position_m", "predicted_full_circumference_m"]
    with path.open("w", newline="") as file:
        writer = csv.writer(file)
        writer.writerow(["calibration", "time_s", *promises, "flown_median_m", *ends, *names])
        for outcome in told:
            promised = [outcome.promised(key) for key in (FIXED, CIRCUMFERENCE)]
            for row in zip(outcome.time, *promised, outcome.growth.T, strict=True):
                figures = [*row[:-1], np.median(row[-1]), *median_interval(row[-1]), *row[-1]]
                writer.writerow([outcome.calibration, *(f"{value:.6g}" for value in figures)])
