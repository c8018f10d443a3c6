"""Files of a study, from the results of all its triads: table, scores, report.

Among the scores is how far the linear model is from samples that are co-simulated without noise.
"""

import json
from collections.abc import Iterator, Mapping
from dataclasses import asdict
from pathlib import Path
from typing import Any

import numpy as np
import pandas as pd

from ins_eval.study import lead, phase_diagram
from ins_eval.study.conditions import CONDITIONS
from ins_eval.study.experiment import (
    FLOWN,
    LEAD,
    NOISELESS,
    STEADY_LOOPS,
    list_methods,
    open_missions,
    select_cosimulated,
    select_errors,
    select_triads,
)
from ins_eval.study.flight_table import (
    Training,
    tabulate_flights,
    tabulate_witnessed,
    train_methods,
)
from ins_eval.study.gyros.makers_calibration import Method
from ins_eval.study.phase_diagram import (
    DURATION,
    compute_map_over_noise,
    compute_phase_diagram,
    compute_turning,
    write_rows,
)
from ins_eval.study.predictors.class_constants import compute_constant
from ins_eval.study.report import page
from ins_eval.study.run.block import Arrays
from ins_eval.study.scores.judge import judge_bounds
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
from ins_eval.study.tables.columns import CLASS_ERROR, TABLE, write_table
from ins_eval.study.tables.score import ALL, RANGE, Score
from ins_eval.study.witness.judge import WitnessScore, score_witnesses
from pyhrg.common.arrays import Array
from pyhrg.common.made_by import list_versions
from pyhrg.common.units import DEG, DEG_PER_H, HOUR

MAX_LINEAR_MODEL_ERROR = 0.01
"""Largest accepted rms of the linear model's position error less the co-simulated one, over the rms
co-simulated one. Chosen."""
SMALLEST_SAMPLE = 10
"""Smallest number of triads with an interval; fewer have a range and no verdict. Chosen."""


def score_agreement(study: Study, arrays: Arrays) -> list[Score]:
    """How far the linear model's final position error is from that co-simulated without noise: one
    score for each sample, calibration and mission class; none without a sample."""
    samples = (
        (study.agreement, NOISELESS, score.AGREEMENT),
        (study.steady_agreement, STEADY_LOOPS, score.STEADY_AGREEMENT),
    )
    return [
        agreement
        for size, flights, key in samples
        if size
        for agreement in _score_groups(study, arrays, flights, key)
    ]


def compute_relative_difference(linear: Array, nonlinear: Array) -> Array:
    """(...,) ratio of the rms difference to the rms nonlinear error; errors are (..., r, m, 2)."""
    difference = np.sum((linear - nonlinear) ** 2, axis=(-3, -2, -1))
    return np.asarray(np.sqrt(difference / np.sum(nonlinear**2, axis=(-3, -2, -1))))


def _score_groups(study: Study, arrays: Arrays, flights: str, key: str) -> Iterator[Score]:
    classes = dict.fromkeys(mission.mission_class for mission in study.missions)
    for method in list_methods(study):
        for name in (ALL, *classes):
            missions = [
                number
                for number, mission in enumerate(study.missions)
                if name in (ALL, mission.mission_class)
            ]
            errors = zip(*_select_final_errors(arrays, method, missions, flights), strict=True)
            samples = [np.stack(each, axis=1) for each in errors]
            yield _score_difference(
                samples,
                study.seed,
                score=key,
                predictor="",
                calibration=method,
                mission_class=name,
                role=ALL,
                n=len(samples[0]),
            )


def _score_difference(samples: list[Array], seed: int, **group: Any) -> Score:
    """The score of a group of triads; samples: (r, m, 2) linear and nonlinear errors; group: fields
    of `Score` that name it."""
    if len(samples[0]) < SMALLEST_SAMPLE:
        single = compute_relative_difference(*(each[:, None] for each in samples))
        value = float(compute_relative_difference(*samples))
        low, high = float(single.min()), float(single.max())
        return Score(value=value, low=low, high=high, confidence=RANGE, **group)
    estimate = bootstrap(compute_relative_difference, samples, seed)
    return estimate.score(
        seed=seed,
        asked=f"<= {MAX_LINEAR_MODEL_ERROR:g}",
        verdict=judge_bounds(estimate, high=MAX_LINEAR_MODEL_ERROR),
        **group,
    )


def _select_final_errors(
    arrays: Arrays, method: Method, missions: list[int], flights: str
) -> Iterator[tuple[Array, Array]]:
    """(r, 2) linear and nonlinear error of a sample at the end, for each mission."""
    for number in missions:
        nonlinear = select_cosimulated(arrays, method, number, flights)[:, -1]
        done = np.isfinite(nonlinear).all(axis=-1)
        error = select_errors(arrays, method, number)
        yield (error.error - error.noise)[done, -1], nonlinear[done]


PHASE_TABLE = "phase_diagram.csv"
WITNESS_TABLE = "witness.csv"
SCHEMA = "hrg-study/3"


def list_files(study: Study) -> tuple[str, ...]:
    """Names of the files of a study, in the order in which they appear."""
    witness = (WITNESS_TABLE,) if study.witnessed else ()
    return (TABLE, PHASE_TABLE, *witness, page.PAGE, DOCUMENT)


def write_conclusion(study: Study, arrays: Arrays, folder: Path) -> None:
    """Write the files of a study into a folder.

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
    witnessed = tabulate_witnessed(study, arrays)
    if study.witnessed:
        witnessed.to_csv(folder / WITNESS_TABLE, index=False)
    witness_scores = score_witnesses(witnessed, study.seed)
    document = _make_document(study, scores, _describe_lead(study, arrays), phase, witness_scores)
    (folder / DOCUMENT).write_text(json.dumps(document, indent=1, allow_nan=False) + "\n")
    page.write_page(check_study_data(frame, document), folder)


def _make_document(
    study: Study,
    scores: list[Score],
    lead_case: dict[str, Any],
    phase: dict[str, Any],
    witness_scores: list[WitnessScore],
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
        WITNESS_KEY: [asdict(each) for each in witness_scores],
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
        "factor": phase_diagram.FACTOR,
        "hours": DURATION / HOUR,
        "start_angles": phase_diagram.ANGLES,
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
                if key == CLASS_ERROR:
                    continue
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
