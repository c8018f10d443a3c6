"""The rows of study.parquet: flown errors, bench figures and predictions of all triads."""

from collections.abc import Iterator
from typing import Any

import numpy as np
import pyarrow as pa
from numpy.typing import NDArray

from ins_eval.mission_model.gyro_map import TERMS
from ins_eval.mission_model.mission_weights import MissionWeights
from ins_eval.mission_model.position_errors import PositionErrors
from ins_eval.mission_model.triad_block import TriadBlock
from ins_eval.mission_model.weights_cache import load_mission_weights
from ins_eval.study.conditions import CONDITIONS
from ins_eval.study.experiment import (
    list_methods,
    open_missions,
    select_condition,
    select_cosimulated,
    select_errors,
    select_triads,
)
from ins_eval.study.predictors.prediction_columns import (
    TrainedModel,
    predict_all,
    select_time,
    tabulate_predictions,
    tabulate_rankings,
    train,
)
from ins_eval.study.run.block import Arrays
from ins_eval.study.specification import CONDITION, MEAN, TRAIN, Study
from ins_eval.study.tables import columns
from ins_eval.study.tables.table import make_table
from pyhrg.common.units import DEG_PER_H, HOUR, MICRO_G

Array = NDArray[np.float64]

MIXED_HALVES = "neither"
"""Half of a training triad in a test class of missions, or the other way round."""


def tabulate_flights(study: Study, arrays: Arrays) -> pa.Table:
    """A row for each triad, calibration and mission, then those of the conditions.

    Args:
        study: the study.
        arrays: results of `experiment.compute_block` for all triads.
    """
    return pa.concat_tables(list(_tabulate(study, arrays)))


def _tabulate(study: Study, arrays: Arrays) -> Iterator[pa.Table]:
    with open_missions(study) as missions:
        weights = [load_mission_weights(mission) for mission in missions]
    accelerometer_bias = study.accelerometer_bias_micro_g * MICRO_G
    halves = [study.half_of(triad) for triad in range(study.triads)]
    for method in list_methods(study):
        triads = select_triads(arrays, method)
        model = train(triads.select(slice(halves.count(TRAIN))), accelerometer_bias)
        for number, mission in enumerate(study.missions):
            yield _make_rows(
                {
                    columns.TRIAD: list(range(study.triads)),
                    columns.HALF: [h if h == mission.half else MIXED_HALVES for h in halves],
                },
                {
                    columns.CALIBRATION: method,
                    columns.MISSION: mission.name,
                    columns.CLASS: mission.mission_class,
                },
                select_errors(arrays, method, number),
                select_cosimulated(arrays, method, number)[:, -1],
                _list_predictions(study, triads, weights[number], model),
                weights[number],
            )
        if method == MEAN and study.conditions:
            yield from _tabulate_conditions(study, arrays, model)


def _tabulate_conditions(study: Study, arrays: Arrays, model: TrainedModel) -> Iterator[pa.Table]:
    for place, condition in enumerate(CONDITIONS):
        numbers, triads, errors = select_condition(arrays, place)
        mission = condition.plan(study)
        weights = load_mission_weights(mission)
        yield _make_rows(
            {columns.TRIAD: numbers},
            {
                columns.HALF: CONDITION,
                columns.CALIBRATION: MEAN,
                columns.MISSION: mission.name,
                columns.CLASS: condition.title,
            },
            errors,
            np.full((len(numbers), 2), np.nan),
            _list_predictions(study, triads, weights, model),
            weights,
        )


def _make_rows(
    own: dict[str, Any],
    common: dict[str, str],
    errors: PositionErrors,
    cosimulated: Array,
    predicted: dict[str, Any],
    weights: MissionWeights,
) -> pa.Table:
    """Rows of one mission; own: values of each row, common: values of all rows."""
    count = len(cosimulated)
    return make_table(
        own
        | {name: [value] * count for name, value in common.items()}
        | _list_flown_errors(errors, weights)
        | {columns.COSIMULATED: np.hypot(cosimulated[:, 0], cosimulated[:, 1])}
        | predicted
    )


def _list_flown_errors(errors: PositionErrors, weights: MissionWeights) -> dict[str, Any]:
    """Errors at the end, and the horizontal error at the times of `columns.GROWTH`."""
    total = errors.error
    parts = {name: getattr(errors, name)[:, -1] for name in columns.PARTS}
    steps = weights.time / HOUR / columns.GROWTH_STEP_HOURS
    growth = np.isclose(np.remainder(steps, 1.0), 0.0)
    return {
        columns.HOURS: [float(weights.time[-1] / HOUR)] * len(total),
        columns.FLOWN_NORTH: total[:, -1, 0],
        columns.FLOWN_EAST: total[:, -1, 1],
        columns.FLOWN_RADIAL: errors.radial[:, -1],
        columns.GROWTH: list(errors.radial[:, growth]),
    } | {
        columns.name_part(name, axis): final[:, place]
        for name, final in parts.items()
        for place, axis in enumerate(("north", "east"))
    }


def _list_predictions(
    study: Study, triads: TriadBlock, weights: MissionWeights, model: TrainedModel
) -> dict[str, Any]:
    """Bench figures, and what predictors make of them for the end of the mission."""
    end = select_time(weights, -1)
    predicted = predict_all(end, triads, model, study.seed)
    ranked = tabulate_rankings(end, triads, model)
    return (
        _list_bench_figures(triads)
        | tabulate_predictions(predicted, study.interval_percent / 100)
        | {name: list(values) if values.ndim > 1 else values for name, values in ranked.items()}
    )


def _list_bench_figures(triads: TriadBlock) -> dict[str, Any]:
    """Rms over the three gyros of each triad."""
    harmonics = triads.fitted_map[:, 1:TERMS]
    maps = np.sqrt(triads.fitted_map[:, 0] ** 2 + np.sum(harmonics**2, axis=1) / 2)
    figures = {
        columns.FIXED_STABILITY: triads.fixed_stability,
        columns.CIRCUMFERENCE_STABILITY: triads.circumference_stability,
        columns.MAP_RMS: maps,
    }
    return {
        name: np.sqrt(np.mean(values**2, axis=1)) / DEG_PER_H for name, values in figures.items()
    }
