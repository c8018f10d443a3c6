"""The files of a study, from the results of all its triads: table, scores, report."""

import json
import math
from collections.abc import Iterator
from dataclasses import asdict
from pathlib import Path
from typing import Any

import pandas as pd

from ins_eval.study.agreement import score_agreement
from ins_eval.study.conditions import CONDITIONS
from ins_eval.study.flight_table import tabulate_flights
from ins_eval.study.report import page
from ins_eval.study.run.block import Arrays
from ins_eval.study.scores.score_flights import score_flights
from ins_eval.study.specification import CONDITION, TEST, TRAIN, Study
from ins_eval.study.study_data import CONDITIONS_KEY, DOCUMENT, INTERVAL_PERCENT, check_study_data
from ins_eval.study.tables import columns
from ins_eval.study.tables.score import ALL, Score
from ins_eval.study.tables.table import TABLE, write_table
from pyhrg.common.made_by import list_versions

FILES = (TABLE, page.PAGE, DOCUMENT)
SCHEMA = "hrg-study/1"


def write_conclusion(study: Study, arrays: Arrays, folder: Path) -> None:
    """Write `FILES` into a folder.

    Args:
        study: the study.
        arrays: results of `experiment.compute_block` for all triads.
        folder: an existing folder.
    """
    rows = tabulate_flights(study, arrays)
    write_table(rows, folder / TABLE)
    frame = rows.to_pandas()
    document = _make_document(study, frame, score_agreement(study, arrays))
    (folder / DOCUMENT).write_text(json.dumps(document, indent=1, allow_nan=False) + "\n")
    page.write_page(check_study_data(frame, document), folder)


def _make_document(study: Study, flights: pd.DataFrame, agreement: list[Score]) -> dict[str, Any]:
    """Content of study.json: what was studied, with which versions, and all scores. Flights whose
    triad and class are in different halves are not scored."""
    judged = flights[flights[columns.HALF].isin((TRAIN, TEST))]
    inside = study.interval_percent / 100
    scores = [
        *score_flights(judged, study.seed, inside),
        *_score_conditions(flights, study.seed, inside),
        *agreement,
    ]
    return {
        "schema": SCHEMA,
        "seed": study.seed,
        "triads": study.triads,
        "missions": len(study.missions),
        "hours": study.hours,
        "left_out": list(study.left_out),
        "calibrations": list(study.calibrations),
        INTERVAL_PERCENT: study.interval_percent,
        CONDITIONS_KEY: {c.title: c.what for c in CONDITIONS} if study.conditions else {},
        "made_by": list_versions(),
        "scores": [_replace_nan(asdict(score)) for score in scores],
    }


def _score_conditions(flights: pd.DataFrame, seed: int, inside: float) -> Iterator[Score]:
    """Scores of each condition by itself."""
    in_conditions = flights[flights[columns.HALF] == CONDITION]
    for _, rows in in_conditions.groupby(columns.CLASS, sort=False):
        yield from (s for s in score_flights(rows, seed, inside) if s.mission_class != ALL)


def _replace_nan(values: dict[str, Any]) -> dict[str, Any]:
    return {
        key: None if isinstance(value, float) and not math.isfinite(value) else value
        for key, value in values.items()
    }
