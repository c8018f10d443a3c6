"""All predictors, for a block of triads in one mission, as columns of the study's table."""

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from ins_eval.mission_model.mission_weights import MissionWeights
from ins_eval.mission_model.triad_block import TriadBlock
from ins_eval.study.predictors import fitted_map, manoeuvre_theory, oracle, stability_rule
from ins_eval.study.predictors.bench_figures import collect_bench_figures
from ins_eval.study.predictors.parts import map_drift
from ins_eval.study.predictors.parts.map_drift import MapDrift
from ins_eval.study.predictors.parts.turned_maps import undo_start
from ins_eval.study.predictors.prediction import Prediction
from ins_eval.study.predictors.rms_over_angles import compute_gyro_rms, compute_triad_rms
from ins_eval.study.predictors.unpredictable import compute_unpredictable_covariance
from ins_eval.study.tables import columns
from pyhrg.common.units import DEG_PER_H

Array = NDArray[np.float64]


@dataclass(frozen=True)
class TrainedModel:
    """What predictors take from the training half of the triads, and from a data sheet.

    drift: distribution of the maps' change between bench and flight;
    shares: (4,) share of each harmonic in the variance of bias maps;
    accelerometer_bias: standard deviation from the data sheet, m/s^2.
    """

    drift: MapDrift
    shares: Array
    accelerometer_bias: float


def train(training: TriadBlock, accelerometer_bias: float) -> TrainedModel:
    """The model from triads of the training half, whose maps in flight are known."""
    bench = collect_bench_figures(training)
    return TrainedModel(
        drift=map_drift.estimate_map_drift(bench, training.in_flight, training.start_angle),
        shares=manoeuvre_theory.estimate_harmonic_shares(bench.maps),
        accelerometer_bias=accelerometer_bias,
    )


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
        noise=weights.noise[:, :, rows, rows],
        alignment=replace(weights.alignment, attitude=weights.alignment.attitude[at]),
    )


def predict_all(
    weights: MissionWeights, triads: TriadBlock, model: TrainedModel, seed: int
) -> dict[str, Prediction]:
    """Predictions by key of `columns.PREDICTORS`; only the oracles use true maps.

    Args:
        weights: weights of the mission.
        triads: the block.
        model: the model from other triads.
        seed: seed of the samples.
    """
    bench, drift, angle = collect_bench_figures(triads), model.drift, triads.start_angle
    other = compute_unpredictable_covariance(weights, bench.noise, model.accelerometer_bias)
    true_other = compute_unpredictable_covariance(weights, triads.noise, model.accelerometer_bias)
    true_bench = replace(bench, maps=triads.true_map)
    in_flight, stability = triads.in_flight, bench.circumference_stability
    return {
        "fixed_rule": stability_rule.predict(bench.fixed_stability, weights.time),
        "circumference_rule": stability_rule.predict(stability, weights.time),
        "manoeuvre_theory": manoeuvre_theory.predict(stability, weights, other, model.shares),
        "fitted_map": fitted_map.predict(bench, weights, drift, other, angle, seed),
        "fitted_map_any_angle": fitted_map.predict_any_angle(bench, weights, drift, other, seed),
        "bench_oracle": fitted_map.predict(true_bench, weights, drift, other, angle, seed),
        "oracle": oracle.predict(weights, in_flight, true_other),
        "oracle_any_angle": oracle.predict_any_angle(weights, in_flight, true_other, angle, seed),
    }


def tabulate_predictions(predicted: dict[str, Prediction], inside: float) -> dict[str, Array]:
    """(r,) values of the columns of predictions, at one time.

    Args:
        predicted: predictions by key.
        inside: probability of the intervals; they are central.
    """
    table, ends = {}, ((1 - inside) / 2, (1 + inside) / 2)
    for predictor in columns.PREDICTORS:
        radius = predicted[predictor.key].radius
        table[predictor.median] = radius(0.5)[:, 0]
        table[predictor.low], table[predictor.high] = (radius(end)[:, 0] for end in ends)
    for key in ("fitted_map", "oracle"):
        for place, axis in enumerate(("north", "east")):
            table[f"{key}_{axis}_m"] = predicted[key].expected[:, 0, place]
    return table


def tabulate_rankings(
    weights: MissionWeights, triads: TriadBlock, model: TrainedModel
) -> dict[str, Array]:
    """(r,) and (r, 3) values of the columns that rank triads and gyros, and of the unpredictable
    error, at one time; arguments as `predict_all`."""
    true = undo_start(triads.in_flight, triads.start_angle)
    return {
        columns.UNPREDICTABLE: _compute_unpredictable_rms(weights, triads, model),
        columns.RMS_OVER_ANGLES: compute_triad_rms(weights.maps, true)[:, 0],
        columns.GYROS_FLOWN: compute_gyro_rms(weights.maps, true)[:, 0],
        columns.GYROS_FITTED: compute_gyro_rms(weights.gyros, triads.fitted_map)[:, 0],
        columns.GYROS_FIXED: triads.fixed_stability / DEG_PER_H,
        columns.GYROS_CIRCUMFERENCE: triads.circumference_stability / DEG_PER_H,
    }


def _compute_unpredictable_rms(
    weights: MissionWeights, triads: TriadBlock, model: TrainedModel
) -> Array:
    """(r,) rms error by drift, noise and accelerometers, m, without the bench's uncertainty."""
    bench = collect_bench_figures(triads)
    other = compute_unpredictable_covariance(weights, bench.noise, model.accelerometer_bias)
    drift = fitted_map.compute_drift_covariance(bench, weights, model.drift, triads.start_angle)
    return np.asarray(np.sqrt(np.trace((drift + other)[:, 0], axis1=-2, axis2=-1)))
