"""All predictors, for a block of triads in one mission, as columns of the study's table."""

from collections.abc import Mapping
from dataclasses import dataclass, replace

import numpy as np

from ins_eval.mission_model.gyro_map import TERMS, evaluate_terms, undo_start
from ins_eval.mission_model.mission_weights import MissionWeights
from ins_eval.mission_model.position_errors import TriadBlock
from ins_eval.study.predictors import (
    class_constants,
    fitted_map,
    fixed_mean,
    stability_rule,
    true_parameters,
)
from ins_eval.study.predictors.bench_figures import collect_bench_figures
from ins_eval.study.predictors.class_constants import fly_training_triads
from ins_eval.study.predictors.parts import map_drift
from ins_eval.study.predictors.parts.map_drift import MapDrift
from ins_eval.study.predictors.prediction import Prediction
from ins_eval.study.predictors.rms_over_angles import compute_gyro_rms
from ins_eval.study.predictors.unpredictable import compute_unpredictable_covariance
from ins_eval.study.tables import columns
from pyhrg.common.arrays import Array
from pyhrg.common.units import DEG_PER_H

ASSUMED_STABILITY = 0.01 * DEG_PER_H
"""Stability of every gyro for the predictor that ignores the bench, rad/s: any constant."""
TURN_ONS = 7
"""Number of turn-ons of the test whose patterns start anywhere, as the paper's (4.1)."""


@dataclass(frozen=True)
class TrainedModel:
    """What predictors take from the training triads, and from data sheets.

    Attributes:
        drift: distribution of the maps' change between bench and flight.
        accelerometer_bias: standard deviation from the data sheet, m/s^2.
        mounting: standard deviation of each input axis' lean, in each of two directions, rad.
    """

    drift: MapDrift
    accelerometer_bias: float
    mounting: float


def train(training: TriadBlock, accelerometer_bias: float, mounting: float) -> TrainedModel:
    """The model from training triads, whose maps in flight are known."""
    bench = collect_bench_figures(training)
    drift = map_drift.estimate_map_drift(bench, training.in_flight, training.start_angle)
    return TrainedModel(drift, accelerometer_bias, mounting)


def compute_class_ratios(
    weights: MissionWeights, training: TriadBlock, model: TrainedModel, seed: int
) -> dict[str, Array]:
    """(r, n) errors of the training triads' flights in units of the usual rule, by the predictor
    whose stability it takes; weights at the end alone."""
    other = _compute_other_covariance(weights, training.noise, model)
    flown = fly_training_triads(weights, training, other, seed)
    stabilities = {
        columns.FIXED_CLASS: training.fixed_stability,
        columns.CIRCUMFERENCE_CLASS: training.circumference_stability,
        columns.CLASS_ERROR: np.full_like(training.fixed_stability, ASSUMED_STABILITY),
    }
    return {
        key: flown / stability_rule.compute_rule_distance(stability, weights.time)[:, -1:]
        for key, stability in stabilities.items()
    }


def select_time(weights: MissionWeights, k: int) -> MissionWeights:
    """Weights of the k-th kept time alone; -1 is the last.

    Raises:
        IndexError: there is no such time.
    """
    place = range(len(weights.time))[k]
    at, rows = [place], slice(2 * place, 2 * place + 2)
    return replace(
        weights,
        time=weights.time[at],
        maps=weights.maps[at],
        drift=weights.drift[at],
        accelerometers=weights.accelerometers[at],
        mounting=weights.mounting[at],
        noise=weights.noise[:, :, rows, rows],
        alignment=replace(weights.alignment, attitude=weights.alignment.attitude[at]),
    )


def predict_all(
    weights: MissionWeights,
    triads: TriadBlock,
    model: TrainedModel,
    ratios: Mapping[str, Array],
    seed: int,
) -> dict[str, Prediction]:
    """Predictions by key of `columns.PREDICTORS`; only the true parameters' use true maps.

    Args:
        ratios: errors over those of the usual rule in the mission's class, by predictor.
    """
    bench, drift, angle = collect_bench_figures(triads), model.drift, triads.start_angle
    other = _compute_other_covariance(weights, bench.noise, model)
    true_other = _compute_other_covariance(weights, triads.noise, model)
    fixed, circumference = bench.fixed_stability, bench.circumference_stability
    time = weights.time
    return {
        columns.FIXED_RULE: stability_rule.predict(fixed, time),
        columns.CIRCUMFERENCE_RULE: stability_rule.predict(circumference, time),
        columns.FIXED_CLASS: class_constants.predict(ratios[columns.FIXED_CLASS], fixed, time),
        columns.CIRCUMFERENCE_CLASS: class_constants.predict(
            ratios[columns.CIRCUMFERENCE_CLASS], circumference, time
        ),
        columns.CLASS_ERROR: class_constants.predict(
            ratios[columns.CLASS_ERROR], np.full_like(fixed, ASSUMED_STABILITY), time
        ),
        columns.FIXED_MEAN: fixed_mean.predict(bench, weights, other),
        columns.FITTED_MAP: fitted_map.predict(bench, weights, drift, other, angle, seed),
        columns.ANY_ANGLE: fitted_map.predict_any_angle(bench, weights, drift, other, seed),
        columns.TRUE_PARAMETERS: true_parameters.predict(weights, triads.in_flight, true_other),
    }


def _compute_other_covariance(weights: MissionWeights, noise: Array, model: TrainedModel) -> Array:
    return compute_unpredictable_covariance(
        weights, noise, model.accelerometer_bias, model.mounting
    )


def tabulate_predictions(predicted: dict[str, Prediction], inside: float) -> dict[str, Array]:
    """(r,) values of the columns of predictions, at one time.

    Args:
        inside: probability of the intervals; they are central.
    """
    table, ends = {}, ((1 - inside) / 2, (1 + inside) / 2)
    for predictor in columns.PREDICTORS:
        radius = predicted[predictor.key].radius
        table[predictor.median] = radius(0.5)[:, 0]
        table[predictor.low], table[predictor.high] = (radius(end)[:, 0] for end in ends)
    for key in (columns.FITTED_MAP, columns.TRUE_PARAMETERS):
        for place, axis in enumerate(("north", "east")):
            table[f"{key}_{axis}_m"] = predicted[key].expected[:, 0, place]
    return table


def tabulate_rankings(weights: MissionWeights, triads: TriadBlock) -> dict[str, Array]:
    """(r, 3) values of the columns that rank gyros, at one time."""
    true = undo_start(triads.in_flight, triads.start_angle)
    return {
        columns.GYROS_LINEAR: compute_gyro_rms(weights.maps, true)[:, 0],
        columns.GYROS_FITTED: compute_gyro_rms(weights.gyros, triads.fitted_map)[:, 0],
        columns.GYROS_FIXED: triads.fixed_stability / DEG_PER_H,
        columns.GYROS_TURN_ON: triads.fixed_repeatability / DEG_PER_H,
        columns.GYROS_TURN_ON_ANYWHERE: compute_turn_on_scatter(triads) / DEG_PER_H,
        columns.GYROS_CIRCUMFERENCE: triads.circumference_stability / DEG_PER_H,
    }


def compute_turn_on_scatter(triads: TriadBlock) -> Array:
    """(r, 3) bias repeatability over `TURN_ONS` turn-ons if the pattern started anywhere, rad/s.

    The fitted map is read at random angles; their scatter between turn-ons that the electronics
    start at one angle adds. Each triad's own seed decides its angles.
    """
    angles = np.stack(
        [np.random.default_rng(seed).uniform(0, np.pi, (TURN_ONS, 3)) for seed in triads.seeds]
    )
    bias = np.einsum("rnat,rta->rna", evaluate_terms(angles), triads.fitted_map[:, :TERMS])
    return np.asarray(np.hypot(bias.std(axis=1, ddof=1), triads.fixed_repeatability))
