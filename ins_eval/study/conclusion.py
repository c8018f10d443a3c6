"""What a study says, from all of its triads: predictions, the table, scores, the report."""

import json
import math
from collections.abc import Iterator
from dataclasses import asdict
from pathlib import Path
from typing import Any

import numpy as np
import pandas as pd
import pyarrow as pa
from numpy.typing import NDArray

from ins_eval.mission_model.flown import Flown
from ins_eval.mission_model.gyro_map import TERMS
from ins_eval.mission_model.mission_weights import MissionWeights
from ins_eval.mission_model.triads import Triads
from ins_eval.mission_model.weights_cache import kept_weights
from ins_eval.study import agreement
from ins_eval.study.conditions import CONDITIONS
from ins_eval.study.experiment import (
    cosimulated_of,
    flown_of,
    in_condition,
    methods,
    missions,
    triads_of,
)
from ins_eval.study.gyros.maker import Method
from ins_eval.study.predictors.block import (
    Learnt,
    judged_at,
    learnt,
    predicted_columns,
    predictions,
    ranking_columns,
)
from ins_eval.study.report import page
from ins_eval.study.report.result import CONDITIONS as CONDITIONS_KEY
from ins_eval.study.report.result import DOCUMENT, INTERVAL_PERCENT, result
from ins_eval.study.run.block import Arrays
from ins_eval.study.scores.judged import scores
from ins_eval.study.specification import CONDITION, MEAN, TEST, TRAIN, PlannedMission, Study
from ins_eval.study.tables import columns, table
from ins_eval.study.tables.score import ALL, Score
from pyhrg.common.made_by import made_by
from pyhrg.common.units import DEG_PER_H, HOUR, MICRO_G

Array = NDArray[np.float64]

FILES = (table.TABLE, page.PAGE, DOCUMENT)
NEITHER = "neither"
"""Half of a known triad in an unseen class of missions, or the other way round."""
SCHEMA = "hrg-study/1"


def conclude(study: Study, arrays: Arrays, folder: Path) -> None:
    """Write `FILES`."""
    rows = pa.concat_tables(list(_tables(study, arrays)))
    table.write(rows, folder / table.TABLE)
    frame = rows.to_pandas()
    document = _document(study, frame, agreement.scores(study, arrays))
    (folder / DOCUMENT).write_text(json.dumps(document, indent=1, allow_nan=False) + "\n")
    page.write(result(frame, document), folder)


def _tables(study: Study, arrays: Arrays) -> Iterator[pa.Table]:
    with missions(study) as flying:
        weights = [kept_weights(mission) for mission in flying]
    for method in methods(study):
        triads = triads_of(arrays, method)
        known = learnt(_training(study, triads), study.accelerometer_bias_micro_g * MICRO_G)
        for number, mission in enumerate(study.missions):
            error = flown_of(arrays, method, number)
            yield table.table(
                _identified(study, mission, method)
                | _flown(error, weights[number])
                | _cosimulated(cosimulated_of(arrays, method, number))
                | _benched(triads)
                | _predicted(weights[number], triads, known, study)
            )
        if method == MEAN and study.conditions:
            yield from _conditions(study, arrays, known)


def _conditions(study: Study, arrays: Arrays, known: Learnt) -> Iterator[pa.Table]:
    for place, condition in enumerate(CONDITIONS):
        numbers, triads, error = in_condition(arrays, place)
        mission = condition.flying(study)
        weights = kept_weights(mission)
        identified: dict[str, Any] = {
            columns.CALIBRATION: [MEAN] * len(numbers),
            columns.MISSION: [mission.name] * len(numbers),
            columns.CLASS: [condition.title] * len(numbers),
            columns.HALF: [CONDITION] * len(numbers),
        }
        yield table.table(
            identified
            | {columns.TRIAD: numbers}
            | _flown(error, weights)
            | {columns.COSIMULATED: np.full(len(numbers), np.nan)}
            | _benched(triads)
            | _predicted(weights, triads, known, study)
        )


def _training(study: Study, triads: Triads) -> Triads:
    count = sum(study.half_of(triad) == TRAIN for triad in range(len(triads)))
    return Triads(**{name: values[:count] for name, values in vars(triads).items()})


def _identified(study: Study, mission: PlannedMission, method: Method) -> dict[str, Any]:
    count = study.triads
    return {
        columns.TRIAD: list(range(count)),
        columns.CALIBRATION: [method] * count,
        columns.MISSION: [mission.name] * count,
        columns.CLASS: [mission.mission_class] * count,
        columns.HALF: [_half(study.half_of(triad), mission.half) for triad in range(count)],
    }


def _half(triad: str, mission: str) -> str:
    return triad if triad == mission else NEITHER


def _flown(error: Flown, weights: MissionWeights) -> dict[str, Any]:
    """At the end, and as it grew."""
    total = error.error
    parts = {name: getattr(error, name)[:, -1] for name in columns.PARTS}
    every = np.isclose(np.remainder(weights.time / HOUR / columns.GROWTH_STEP_HOURS, 1.0), 0.0)
    return {
        columns.HOURS: [float(weights.time[-1] / HOUR)] * len(total),
        columns.FLOWN_NORTH: total[:, -1, 0],
        columns.FLOWN_EAST: total[:, -1, 1],
        columns.FLOWN_RADIAL: error.radial[:, -1],
        columns.GROWTH: list(error.radial[:, every]),
    } | {
        columns.part(name, axis): ends[:, place]
        for name, ends in parts.items()
        for place, axis in enumerate(("north", "east"))
    }


def _cosimulated(errors: Array) -> dict[str, Any]:
    return {columns.COSIMULATED: np.hypot(errors[:, -1, 0], errors[:, -1, 1])}


def _benched(triads: Triads) -> dict[str, Any]:
    """Rms of the three gyros."""
    waves = triads.known[:, 1:TERMS]
    maps = np.sqrt(triads.known[:, 0] ** 2 + np.sum(waves**2, axis=1) / 2)
    figures = {
        columns.FIXED_STABILITY: triads.fixed_stability,
        columns.CIRCUMFERENCE_STABILITY: triads.circumference_stability,
        columns.MAP_RMS: maps,
    }
    return {
        name: np.sqrt(np.mean(values**2, axis=1)) / DEG_PER_H for name, values in figures.items()
    }


def _predicted(
    weights: MissionWeights, triads: Triads, known: Learnt, study: Study
) -> dict[str, Any]:
    """Of the error at the end."""
    end = judged_at(weights, -1)
    found = predictions(end, triads, known, study.seed)
    predicted = predicted_columns(found, study.interval_percent / 100)
    ranked = ranking_columns(end, triads, known)
    lists = {name: list(v) if v.ndim > 1 else v for name, v in ranked.items()}
    return predicted | lists


def _document(study: Study, frame: pd.DataFrame, others: list[Score]) -> dict[str, Any]:
    """study.json: what was studied, by what, and the scores of those on either side alone."""
    judged = frame[frame[columns.HALF].isin((TRAIN, TEST))]
    apart = frame[frame[columns.HALF] == CONDITION]
    inside = study.interval_percent / 100
    own = scores(judged, study.seed, inside)
    found = [*own, *_apart(apart, study.seed, inside), *others]
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
        "made_by": made_by(),
        "scores": [_without_nan(asdict(s)) for s in found],
    }


def _apart(flights: pd.DataFrame, seed: int, inside: float) -> Iterator[Score]:
    """Each condition by itself."""
    for _, rows in flights.groupby(columns.CLASS, sort=False):
        yield from (s for s in scores(rows, seed, inside) if s.mission_class != ALL)


def _without_nan(values: dict[str, Any]) -> dict[str, Any]:
    return {
        key: None if isinstance(value, float) and not math.isfinite(value) else value
        for key, value in values.items()
    }
