"""All predictors, for a block of triads in one mission, as columns of the study's table."""

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from ins_eval.mission_model.mission_weights import MissionWeights
from ins_eval.mission_model.triads import Triads
from ins_eval.study.predictors import fitted_map, manoeuvre_theory, oracle, stability_rule
from ins_eval.study.predictors.knowledge import bench_knowledge
from ins_eval.study.predictors.parts import map_drift
from ins_eval.study.predictors.parts.map_drift import MapDrift
from ins_eval.study.predictors.parts.turned_maps import unstarted
from ins_eval.study.predictors.prediction import Prediction
from ins_eval.study.predictors.rms_over_angles import rms_over_angles, triad_rms_over_angles
from ins_eval.study.predictors.unpredictable import unpredictable
from ins_eval.study.tables import columns
from pyhrg.common.units import DEG_PER_H

Array = NDArray[np.float64]


@dataclass(frozen=True)
class Learnt:
    """From the training half: how maps drift, and the share (4,) of each harmonic in the variance
    of bias maps; and what a data sheet says of accelerometers' biases, 1 sigma, m/s^2."""

    drift: MapDrift
    shares: Array
    accelerometer_bias: float


def learnt(training: Triads, accelerometer_bias: float) -> Learnt:
    """From the triads of the training half, whose maps were read in flight."""
    bench = bench_knowledge(training)
    return Learnt(
        drift=map_drift.learnt(bench, training.in_flight, training.start_angle),
        shares=manoeuvre_theory.harmonic_shares(bench.maps),
        accelerometer_bias=accelerometer_bias,
    )


def judged_at(weights: MissionWeights, k: int) -> MissionWeights:
    """Weights of the k-th of the kept times alone; -1 is the last.

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
        standing=replace(weights.standing, attitude=weights.standing.attitude[at]),
    )


def predictions(
    weights: MissionWeights, triads: Triads, learned: Learnt, seed: int
) -> dict[str, Prediction]:
    """By key of `columns.PREDICTORS`; only oracles look at what is true.

    Args:
        weights: of the mission.
        triads: the block.
        learned: from other triads.
        seed: of what is drawn.
    """
    bench, drift, angle = bench_knowledge(triads), learned.drift, triads.start_angle
    rest = unpredictable(weights, bench.noise, learned.accelerometer_bias)
    true = unpredictable(weights, triads.noise, learned.accelerometer_bias)
    best = replace(bench, maps=triads.true)
    new = bench.circumference_stability
    return {
        "fixed_rule": stability_rule.predict(bench.fixed_stability, weights.time),
        "circumference_rule": stability_rule.predict(new, weights.time),
        "manoeuvre_theory": manoeuvre_theory.predict(new, weights, rest, learned.shares),
        "fitted_map": fitted_map.predict(bench, weights, drift, rest, angle, seed),
        "fitted_map_any_angle": fitted_map.predict_any_angle(bench, weights, drift, rest, seed),
        "bench_oracle": fitted_map.predict(best, weights, drift, rest, angle, seed),
        "oracle": oracle.predict(weights, triads.in_flight, true),
        "oracle_any_angle": oracle.predict_any_angle(weights, triads.in_flight, true, angle, seed),
    }


def predicted_columns(predicted: dict[str, Prediction], inside: float) -> dict[str, Array]:
    """(r,) columns of `columns`, of predictions at one time.

    Args:
        predicted: by key.
        inside: probability of the intervals, as much outside on either side.
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


def ranking_columns(weights: MissionWeights, triads: Triads, learned: Learnt) -> dict[str, Array]:
    """(r,) and (r, 3) columns of `columns` that rank triads and gyros, and say what can't be known,
    at one time; arguments as `predictions`."""
    true = unstarted(triads.in_flight, triads.start_angle)
    return {
        columns.UNPREDICTABLE: _unpredictable_rms(weights, triads, learned),
        columns.RMS_OVER_ANGLES: triad_rms_over_angles(weights.maps, true)[:, 0],
        columns.GYROS_FLOWN: rms_over_angles(weights.maps, true)[:, 0],
        columns.GYROS_FITTED: rms_over_angles(weights.gyros, triads.known)[:, 0],
        columns.GYROS_FIXED: triads.fixed_stability / DEG_PER_H,
        columns.GYROS_CIRCUMFERENCE: triads.circumference_stability / DEG_PER_H,
    }


def _unpredictable_rms(weights: MissionWeights, triads: Triads, learned: Learnt) -> Array:
    """(r,) m: of drift, noise and accelerometers, not of the bench's own uncertainty."""
    bench = bench_knowledge(triads)
    rest = unpredictable(weights, bench.noise, learned.accelerometer_bias)
    drift = fitted_map.drift_covariance(bench, weights, learned.drift, triads.start_angle)
    return np.asarray(np.sqrt(np.trace((drift + rest)[:, 0], axis1=-2, axis2=-1)))
