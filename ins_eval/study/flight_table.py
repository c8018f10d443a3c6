"""The rows of study.parquet: flown errors, bench figures and predictions of all triads."""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
import pandas as pd
import pyarrow as pa

from ins_eval.mission_model.gyro_map import TERMS
from ins_eval.mission_model.mission_weights import MissionWeights
from ins_eval.mission_model.position_errors import PositionErrors, TriadBlock
from ins_eval.mission_model.weights_cache import load_mission_weights
from ins_eval.study.conditions import CONDITIONS
from ins_eval.study.experiment import (
    list_methods,
    open_missions,
    select_condition,
    select_cosimulated,
    select_errors,
    select_triads,
    select_witnesses,
)
from ins_eval.study.gyros.makers_calibration import Method
from ins_eval.study.predictors.prediction_columns import (
    TrainedModel,
    compute_class_ratios,
    predict_all,
    select_time,
    tabulate_predictions,
    tabulate_rankings,
    train,
)
from ins_eval.study.run.block import Arrays
from ins_eval.study.specification import CONDITION, MEAN, Study
from ins_eval.study.tables import columns
from ins_eval.study.tables.columns import make_table
from ins_eval.study.witness.tabulate import KEYS, tabulate_witnesses
from pyhrg.common.arrays import Array
from pyhrg.common.units import DEG_PER_H, HOUR

Ratios = Mapping[str, Array]
"""(r, n) errors of the training triads' flights in units of the usual rule, by predictor."""


@dataclass(frozen=True)
class Training:
    """What the training triads of a calibration teach.

    Attributes:
        model: model of the drift of maps.
        ratios: ratios of error and rule, for each mission class.
    """

    model: TrainedModel
    ratios: Mapping[str, Ratios]


def train_methods(study: Study, arrays: Arrays) -> dict[Method, Training]:
    """What is learned from the training triads, for each calibration."""
    weights = _load_weights(study)
    trained = {}
    for method in list_methods(study):
        training = select_triads(arrays, method).select(slice(study.training))
        model = train(training, study.accelerometer_bias, study.mounting)
        flown: dict[str, list[dict[str, Array]]] = {
            planned.mission_class: [] for planned in study.missions
        }
        for planned, each in zip(study.missions, weights, strict=True):
            ratios = compute_class_ratios(select_time(each, -1), training, model, study.seed)
            flown[planned.mission_class].append(ratios)
        trained[method] = Training(model, {name: _join(each) for name, each in flown.items()})
    return trained


def _load_weights(study: Study) -> list[MissionWeights]:
    with open_missions(study) as missions:
        return [load_mission_weights(mission) for mission in missions]


def _join(missions: Sequence[Ratios]) -> Ratios:
    return {key: np.concatenate([each[key] for each in missions], axis=1) for key in missions[0]}


def tabulate_flights(study: Study, arrays: Arrays, trained: Mapping[Method, Training]) -> pa.Table:
    """A row for each triad, calibration and mission, then those of the conditions.

    Args:
        arrays: results of `experiment.compute_block` for all triads.
    """
    return pa.concat_tables(list(_tabulate(study, arrays, trained)))


def tabulate_witnessed(study: Study, arrays: Arrays) -> pd.DataFrame:
    """Flights whose gyros' channels were read, of all calibrations and missions."""
    if not study.witnessed:
        return pd.DataFrame(columns=KEYS)
    sensors = study.accelerometer_bias, study.mounting
    inside, parts = study.interval_percent / 100, []
    weights = [select_time(each, -1) for each in _load_weights(study)]
    for method in list_methods(study):
        triads = select_triads(arrays, method)
        for number, mission in enumerate(study.missions):
            estimates = select_witnesses(arrays, method, number)
            flights = tabulate_witnesses(
                estimates, triads, weights[number], sensors, inside, study.seed
            )
            named = (method, mission.mission_class, mission.name)
            parts.append(flights.assign(**dict(zip(KEYS, named, strict=False))))
    joined = pd.concat(parts, ignore_index=True)
    return joined[[*KEYS, *joined.columns.drop(list(KEYS))]]


def _tabulate(
    study: Study, arrays: Arrays, trained: Mapping[Method, Training]
) -> Iterator[pa.Table]:
    weights = _load_weights(study)
    roles = [study.role_of(triad) for triad in range(study.triads)]
    for method, training in trained.items():
        triads = select_triads(arrays, method)
        for number, mission in enumerate(study.missions):
            ratios = training.ratios[mission.mission_class]
            yield _make_rows(
                {columns.TRIAD: list(range(study.triads)), columns.ROLE: roles},
                {
                    columns.CALIBRATION: method,
                    columns.MISSION: mission.name,
                    columns.CLASS: mission.mission_class,
                },
                select_errors(arrays, method, number),
                select_cosimulated(arrays, method, number),
                _list_predictions(study, triads, weights[number], training.model, ratios),
                weights[number],
            )
        if method == MEAN and study.conditions:
            yield from _tabulate_conditions(study, arrays, training)


def _tabulate_conditions(study: Study, arrays: Arrays, training: Training) -> Iterator[pa.Table]:
    for place, condition in enumerate(CONDITIONS):
        numbers, triads, errors = select_condition(arrays, place)
        mission = condition.plan(study)
        weights = load_mission_weights(mission)
        learned = select_triads(arrays, MEAN).select(slice(study.training))
        ratios = compute_class_ratios(select_time(weights, -1), learned, training.model, study.seed)
        yield _make_rows(
            {columns.TRIAD: numbers},
            {
                columns.ROLE: CONDITION,
                columns.CALIBRATION: MEAN,
                columns.MISSION: mission.name,
                columns.CLASS: condition.title,
            },
            errors,
            np.full((*errors.radial.shape, 2), np.nan),
            _list_predictions(study, triads, weights, training.model, ratios),
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
        | _list_flown_errors(errors, cosimulated, weights)
        | predicted
    )


def _list_flown_errors(
    errors: PositionErrors, cosimulated: Array, weights: MissionWeights
) -> dict[str, Any]:
    """Errors at the end, and the horizontal error at the times of `columns.GROWTH`. `FLOWN_BY` says
    what they are of: the co-simulation where there is one, else the linear model."""
    done = np.asarray(np.isfinite(cosimulated).all(axis=(1, 2)))
    total = np.where(done[:, None, None], cosimulated, errors.error)
    radial = np.linalg.norm(total, axis=-1)
    parts = {name: getattr(errors, name)[:, -1] for name in columns.PARTS}
    steps = weights.time / HOUR / columns.GROWTH_STEP_HOURS
    growth = np.isclose(np.remainder(steps, 1.0), 0.0)
    return {
        columns.HOURS: [float(weights.time[-1] / HOUR)] * len(total),
        columns.FLOWN_BY: [columns.COSIMULATED if each else columns.LINEAR for each in done],
        columns.FLOWN_NORTH: total[:, -1, 0],
        columns.FLOWN_EAST: total[:, -1, 1],
        columns.FLOWN_RADIAL: radial[:, -1],
        columns.LINEAR_RADIAL: errors.radial[:, -1],
        columns.GROWTH: list(radial[:, growth]),
    } | {
        columns.name_part(name, axis): final[:, place]
        for name, final in parts.items()
        for place, axis in enumerate(("north", "east"))
    }


def _list_predictions(
    study: Study,
    triads: TriadBlock,
    weights: MissionWeights,
    model: TrainedModel,
    ratios: Ratios,
) -> dict[str, Any]:
    """Bench figures, and what predictors make of them for the end of the mission."""
    end = select_time(weights, -1)
    predicted = predict_all(end, triads, model, ratios, study.seed)
    ranked = tabulate_rankings(end, triads)
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
