"""The files of a study, from the results of all its triads: table, scores, report."""

import json
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any

import numpy as np
import pandas as pd

from ins_eval.mission_model.weights_cache import load_mission_weights
from ins_eval.study import lead
from ins_eval.study.agreement import score_agreement
from ins_eval.study.conditions import CONDITIONS
from ins_eval.study.experiment import (
    FLOWN,
    LEAD,
    list_methods,
    open_missions,
    select_triads,
    select_witnesses,
)
from ins_eval.study.flight_table import Training, tabulate_flights, train_methods
from ins_eval.study.gyros.makers_calibration import Method
from ins_eval.study.phase import diagram
from ins_eval.study.phase.diagram import (
    compute_map_over_noise,
    compute_phase_diagram,
    compute_turning,
    write_rows,
)
from ins_eval.study.phase.turning import DURATION
from ins_eval.study.predictors.class_constants import compute_constant
from ins_eval.study.predictors.prediction_columns import select_time
from ins_eval.study.report import page
from ins_eval.study.run.block import Arrays
from ins_eval.study.scores.resampling import bootstrap
from ins_eval.study.scores.score_flights import score_flights
from ins_eval.study.specification import CONDITION, MEAN, TEST, TRAIN, Study
from ins_eval.study.study_data import (
    CONDITIONS_KEY,
    DOCUMENT,
    INTERVAL_PERCENT,
    LEAD_KEY,
    PHASE_KEY,
    WITNESS_KEY,
    check_study_data,
)
from ins_eval.study.tables import columns, score
from ins_eval.study.tables.score import ALL, Score
from ins_eval.study.tables.table import TABLE, write_table
from ins_eval.study.witness.judge import WitnessScore, score_witnesses
from ins_eval.study.witness.tabulate import KEYS, tabulate_witnesses
from pyhrg.common.made_by import list_versions
from pyhrg.common.units import ARCSEC, DEG, DEG_PER_H, HOUR, MICRO_G

PHASE_TABLE = "phase_diagram.csv"
WITNESS_TABLE = "witness.csv"
FILES = (TABLE, PHASE_TABLE, WITNESS_TABLE, page.PAGE, DOCUMENT)
SCHEMA = "hrg-study/2"


def write_conclusion(study: Study, arrays: Arrays, folder: Path) -> None:
    """Write `FILES` into a folder.

    Args:
        arrays: results of `experiment.compute_block` for all triads.
        folder: an existing folder.
    """
    trained = train_methods(study, arrays)
    rows = tabulate_flights(study, arrays, trained)
    write_table(rows, folder / TABLE)
    frame = rows.to_pandas()
    scores = [
        *score_flights(
            frame[frame[columns.ROLE] == TEST], study.seed, study.interval_percent / 100
        ),
        *_score_conditions(frame, study.seed, study.interval_percent / 100),
        *_score_constants(study, trained),
        *score_agreement(study, arrays),
    ]
    phase = _describe_phase_diagram(study, arrays, trained)
    write_rows(phase.get("rows", []), folder / PHASE_TABLE)
    witnessed = _tabulate_witnesses(study, arrays)
    witnessed.to_csv(folder / WITNESS_TABLE, index=False)
    told = score_witnesses(witnessed, study.seed) if len(witnessed) else []
    document = _make_document(study, scores, _describe_lead(study, arrays), phase, told)
    (folder / DOCUMENT).write_text(json.dumps(document, indent=1, allow_nan=False) + "\n")
    page.write_page(check_study_data(frame, document), folder)


def _make_document(
    study: Study,
    scores: list[Score],
    lead_case: dict[str, Any],
    phase: dict[str, Any],
    told: list[WitnessScore],
) -> dict[str, Any]:
    """Content of study.json: what was studied, with which versions, and all scores."""
    return {
        "schema": SCHEMA,
        "seed": study.seed,
        "triads": study.triads,
        "training": study.training,
        "missions": len(study.missions),
        "hours": study.hours,
        "left_out": list(study.left_out),
        "calibrations": list(study.calibrations),
        INTERVAL_PERCENT: study.interval_percent,
        CONDITIONS_KEY: {c.title: c.what for c in CONDITIONS} if study.conditions else {},
        LEAD_KEY: lead_case,
        PHASE_KEY: phase,
        WITNESS_KEY: [each.describe() for each in told],
        "made_by": list_versions(),
        "scores": [each.describe() for each in scores],
    }


def _describe_lead(study: Study, arrays: Arrays) -> dict[str, Any]:
    """The lead case: bench figures, and the horizontal errors of all its flights over time."""
    if not study.lead:
        return {}
    radial = np.linalg.norm(arrays[f"{LEAD}/{FLOWN}"], axis=-1)
    fixed, circumference = (arrays[f"{LEAD}/bench"][0] / DEG_PER_H).tolist()
    return {
        "device": lead.DEVICE,
        "mission": lead.MISSION,
        "fixed_stability_deg_h": fixed,
        "circumference_stability_deg_h": circumference,
        "time_s": (lead.plan_lead().interval * np.arange(1.0, radial.shape[1] + 1)).tolist(),
        "flown_m": radial.tolist(),
        "start_angles_deg": (arrays[f"{LEAD}/angle"] / DEG).tolist(),
    }


def _tabulate_witnesses(study: Study, arrays: Arrays) -> pd.DataFrame:
    """Flights whose gyros' channels were read, of all calibrations and missions."""
    if not study.witnessed:
        return pd.DataFrame(columns=KEYS)
    sensors = study.accelerometer_bias_micro_g * MICRO_G, study.mounting_arcsec * ARCSEC
    inside, parts = study.interval_percent / 100, []
    with open_missions(study) as missions:
        weights = [select_time(load_mission_weights(mission), -1) for mission in missions]
    for method in list_methods(study):
        triads = select_triads(arrays, method)
        for number, mission in enumerate(study.missions):
            found = select_witnesses(arrays, method, number)
            flights = tabulate_witnesses(
                found, triads, weights[number], sensors, inside, study.seed
            )
            named = (method, mission.mission_class, mission.name)
            parts.append(flights.assign(**dict(zip(KEYS, named, strict=False))))
    joined = pd.concat(parts, ignore_index=True)
    return joined[[*KEYS, *joined.columns.drop(list(KEYS))]]


def _describe_phase_diagram(
    study: Study, arrays: Arrays, trained: Mapping[Method, Training]
) -> dict[str, Any]:
    """The phase diagram of the training triads, and where the judged ones fly in it: turning and
    median map over noise by class."""
    if MEAN not in trained:
        return {}
    triads = select_triads(arrays, MEAN)
    training, judged = (
        triads.select(rows) for rows in (slice(study.training), slice(study.training, None))
    )
    ratio = float(np.median(compute_map_over_noise(judged)))
    with open_missions(study) as missions:
        places = {
            planned.mission_class: [compute_turning(mission), ratio]
            for planned, mission in zip(study.missions, missions, strict=True)
        }
    return {
        "factor": diagram.FACTOR,
        "hours": DURATION / HOUR,
        "start_angles": diagram.ANGLES,
        "rows": compute_phase_diagram(training, trained[MEAN].model.drift, study.seed),
        "missions": places,
    }


def _score_conditions(flights: pd.DataFrame, seed: int, inside: float) -> Iterator[Score]:
    in_conditions = flights[flights[columns.ROLE] == CONDITION]
    for _, rows in in_conditions.groupby(columns.CLASS, sort=False):
        yield from (s for s in score_flights(rows, seed, inside) if s.mission_class != ALL)


def _score_constants(study: Study, trained: Mapping[Method, Training]) -> Iterator[Score]:
    """The constant of each class for both bench tests, with its interval over training triads."""
    for method, training in trained.items():
        for mission_class, by_predictor in training.ratios.items():
            for key, ratios in by_predictor.items():
                constant = bootstrap(compute_constant, [ratios], study.seed)
                yield constant.score(
                    score=score.CLASS_CONSTANT,
                    predictor=key,
                    calibration=method,
                    mission_class=mission_class,
                    role=TRAIN,
                    n=len(ratios),
                    seed=study.seed,
                )
