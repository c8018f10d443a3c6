"""R2 of the position error by maps that are known as well as the channels allow (Cramer-Rao)."""

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from benchmarks.witness.motions import CLASSES, Ride, load_ride
from ins_eval.mission_model.gyro_map import start_maps, turn_weights
from ins_eval.mission_model.mission_weights import MissionWeights
from ins_eval.mission_model.missions import plan_mission
from ins_eval.mission_model.position_errors import (
    TriadBlock,
    compute_expected_error,
    compute_linear_position_errors,
)
from ins_eval.mission_model.signals import SIGNALS, slice_coefficients
from ins_eval.mission_model.weights_cache import load_mission_weights
from ins_eval.study.gyros.drawn_triad import DrawnTriad, TriadDistribution
from ins_eval.study.gyros.drift import Flight
from ins_eval.study.gyros.witness_prior import forget_unmeasured, make_study_drift, make_study_prior
from ins_eval.study.predictors import fitted_map, true_parameters
from ins_eval.study.predictors.bench_figures import collect_bench_figures
from ins_eval.study.predictors.prediction import NormalPrediction, Prediction
from ins_eval.study.predictors.prediction_columns import TrainedModel, select_time, train
from ins_eval.study.predictors.unpredictable import compute_unpredictable_covariance
from ins_eval.study.scores.measures import compute_r2
from ins_eval.study.scores.resampling import Estimate, bootstrap
from ins_eval.study.witness.estimated_map import ESTIMATED, respond
from ins_eval.study.witness.judge import compute_size_ratio
from ins_eval.study.witness.self_test import SELF_TEST
from ins_eval.study.witness.witnessed import read_true_changes
from pyhrg.common.arrays import Array
from pyhrg.common.units import ARCSEC, MICRO_G
from pyhrg.device.device import Device
from pyhrg.fmu import GyroFmu
from pyhrg.witness.information import (
    accumulate_information,
    compute_posterior,
    factor_covariance,
)
from pyhrg.witness.mechanisms import COUNT as MECHANISMS
from pyhrg.witness.responses import Responses, measure_responses

HOURS = 2.0
ACCELEROMETER, MOUNTING = 10 * MICRO_G, 10 * ARCSEC
TESTS = {"channels in flight": 0.0, "with a self-test": SELF_TEST}
"""Durations of the self-test at power-on, s."""
SEED = 1
UNKNOWN = slice(ESTIMATED, len(SIGNALS))
"""Signals of the maps to which the response is not known: fast turning."""


@dataclass(frozen=True)
class Score:
    """Scores of r triads in m missions, with bootstrap intervals of 95 % over triads.

    r2: of the horizontal error; coverage: of 90 % intervals; corrected: median error after the
    predicted one is taken out, over the median error.
    """

    r2: Estimate
    coverage: float
    corrected: Estimate

    def __str__(self) -> str:
        return (
            f"R2 {_format(self.r2)}, coverage {self.coverage:.2f}, "
            f"corrected {_format(self.corrected)}"
        )


def _format(found: Estimate) -> str:
    return f"{found.value:.3f} ({found.low:.3f} to {found.high:.3f})"


@dataclass(frozen=True)
class Known:
    """One gyro before its flight.

    responses: its sensitivities; prior: covariance of what is not known of it; changes: (COUNT,)
    its true changes less the expected ones; benched: covariance of the bench's error.
    """

    responses: Responses
    prior: Array
    changes: Array
    benched: Array

    def draw_error(self, information: Array, generator: np.random.Generator) -> Array:
        """(COUNT,) true less estimated changes, of an estimate that attains the bound. It shrinks
        what the channels do not tell towards the prior."""
        root = factor_covariance(self.prior)
        inner = np.linalg.inv(np.eye(len(root)) + root.T @ information @ root)
        noise, error = generator.standard_normal((2, len(root)))
        missed = self.changes + factor_covariance(self.benched) @ error
        scaled = np.linalg.lstsq(root, missed, rcond=1e-12)[0]
        spread = factor_covariance(inner - inner @ inner)
        return np.asarray(root @ (inner @ scaled + spread @ noise))


def measure_triads(
    fmu: GyroFmu, distribution: TriadDistribution, drawn: list[DrawnTriad]
) -> list[list[Known]]:
    return [
        [
            learn_gyro(measure_responses(fmu, device), distribution, device, flight)
            for device, flight in zip(triad.calibrated, triad.flights, strict=True)
        ]
        for triad in drawn
    ]


def learn_gyro(
    responses: Responses, distribution: TriadDistribution, device: Device, flight: Flight
) -> Known:
    population, plan, drift = distribution.population, distribution.bench, distribution.drift
    prior = make_study_prior(responses, device, population, plan, drift)
    drifted = make_study_drift(device, drift)
    return Known(
        responses=responses,
        prior=prior.covariance,
        changes=read_true_changes(forget_unmeasured(device), flight) - drifted.mean,
        benched=prior.covariance - drifted.covariance,
    )


def compute_scores(
    training: TriadBlock, triads: TriadBlock, known: list[list[Known]]
) -> Iterator[tuple[str, dict[str, Score]]]:
    """By class: R2 and the coverage of 90 % intervals of each predictor, in linear flights."""
    model = train(training, ACCELEROMETER, MOUNTING)
    flights: dict[str, list[Array]] = {}
    for number, (mission, title) in enumerate(CLASSES.items()):
        weights = select_time(load_mission_weights(plan_mission(mission, HOURS)), -1)
        flown = compute_linear_position_errors(triads, weights, number).error[:, 0]
        predictions = predict_all(weights, load_ride(mission, HOURS), triads, known, model)
        for name, each in predictions.items():
            flights.setdefault(name, []).append(tabulate(flown, each))
        yield title, {name: score(table[-1][:, None]) for name, table in flights.items()}
    yield "all classes", {name: score(np.stack(table, 1)) for name, table in flights.items()}


def predict_all(
    weights: MissionWeights,
    ride: Ride,
    triads: TriadBlock,
    known: list[list[Known]],
    model: TrainedModel,
) -> dict[str, Prediction]:
    bench, angle = collect_bench_figures(triads), triads.start_angle

    def cover(noise: Array) -> Array:
        return compute_unpredictable_covariance(weights, noise, ACCELEROMETER, MOUNTING)

    other = cover(triads.noise)
    predictions: dict[str, Prediction] = {
        "fitted map": fitted_map.predict(
            bench, weights, model.drift, cover(bench.noise), angle, SEED
        ),
        "bench and drift alone": _predict_oracle(weights, None, triads, known, other, 0.0),
    }
    for name, test in TESTS.items():
        predictions[name] = _predict_oracle(weights, ride, triads, known, other, test)
    predictions["true parameters"] = true_parameters.predict(weights, triads.in_flight, other)
    return predictions


def _predict_oracle(
    weights: MissionWeights,
    ride: Ride | None,
    triads: TriadBlock,
    known: list[list[Known]],
    other: Array,
    test: float,
) -> NormalPrediction:
    """The true map less the error of an estimate that attains the bound, and its covariance. What
    the maps do under fast turning is not known."""
    generator = np.random.default_rng(SEED)
    errors = np.empty((len(triads), 3, MECHANISMS))
    posteriors = np.empty((len(triads), 3, MECHANISMS, MECHANISMS))
    for r, axis in np.ndindex(len(triads), 3):
        each = known[r][axis]
        information = np.zeros_like(each.prior)
        if ride is not None:
            motion = ride.follow(axis, triads.start_angle[r, axis], triads.rise[r, axis], test)
            information = accumulate_information(each.responses, motion)
        posteriors[r, axis] = compute_posterior(each.prior, information)
        errors[r, axis] = each.draw_error(information, generator)
    return predict_by_changes(weights, triads, known, errors, posteriors, other)


def predict_by_changes(
    weights: MissionWeights,
    triads: TriadBlock,
    known: list[list[Known]],
    errors: Array,
    covariances: Array,
    other: Array,
) -> NormalPrediction:
    """Position errors by mechanisms that are known but for errors (r, 3, COUNT), true less
    estimated, of covariances (r, 3, COUNT, COUNT)."""
    maps, covariance = triads.in_flight.copy(), other.copy()
    maps[:, slice_coefficients(UNKNOWN)] = 0.0
    for r, axis in np.ndindex(len(triads), 3):
        response = respond(known[r][axis].responses, triads.rise[r, axis])
        error = response @ errors[r, axis]
        start = np.array([triads.start_angle[r, axis]])
        maps[r, :, axis] -= start_maps(error[:, None], start)[:, 0]
        carried = turn_weights(weights.maps, triads.start_angle[r])[:, :, :, axis] @ response
        covariance[r] += np.einsum("kip,pq,kjq->kij", carried, covariances[r, axis], carried)
    return NormalPrediction(compute_expected_error(weights, maps), covariance)


def tabulate(flown: Array, prediction: Prediction) -> Array:
    """(r, 8) error north and east, the predicted one, the horizontal error, and the 5 %, 50 % and
    95 % quantiles of the predicted one, m."""
    quantiles = [prediction.radius(share)[:, 0] for share in (0.05, 0.5, 0.95)]
    radial = np.linalg.norm(flown, axis=-1)
    return np.column_stack([flown, prediction.expected[:, 0], radial, *quantiles])


def score(table: Array) -> Score:
    """Score of r triads in m missions, from (r, m, 8) values of `tabulate`."""
    left = np.linalg.norm(table[..., :2] - table[..., 2:4], axis=-1)
    flown, low, middle, high = np.moveaxis(table[..., 4:], -1, 0)
    return Score(
        bootstrap(compute_r2, [flown, middle], SEED),
        float(np.mean((low <= flown) & (flown <= high))),
        bootstrap(compute_size_ratio, [flown, left], SEED),
    )
