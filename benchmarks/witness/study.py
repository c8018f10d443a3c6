"""R2 of the position error by maps that are known as well as the channels allow (Cramer-Rao)."""

from collections.abc import Iterator
from dataclasses import dataclass, replace

import numpy as np

from benchmarks.witness.motions import CLASSES, Ride, load_ride
from ins_eval.mission_model.gyro_map import start_maps, turn_weights
from ins_eval.mission_model.mission_weights import MissionWeights
from ins_eval.mission_model.missions import plan_mission
from ins_eval.mission_model.position_errors import (
    TriadBlock,
    compute_expected_error,
    compute_position_errors,
)
from ins_eval.mission_model.signals import COUNT, slice_coefficients
from ins_eval.mission_model.weights_cache import load_mission_weights
from ins_eval.study.gyros.bench_plan import BenchPlan
from ins_eval.study.gyros.drawn_triad import DrawnTriad
from ins_eval.study.gyros.drift import Drift, Flight
from ins_eval.study.gyros.population import RAW
from ins_eval.study.gyros.witness_prior import make_study_drift, make_study_prior
from ins_eval.study.predictors import fitted_map, true_parameters
from ins_eval.study.predictors.bench_figures import collect_bench_figures
from ins_eval.study.predictors.prediction import NormalPrediction, Prediction
from ins_eval.study.predictors.prediction_columns import TrainedModel, select_time, train
from ins_eval.study.predictors.unpredictable import compute_unpredictable_covariance
from ins_eval.study.scores.measures import compute_r2
from pyhrg.common.arrays import Array
from pyhrg.common.units import ARCSEC, MICRO_G
from pyhrg.device.device import Device
from pyhrg.device.fmu_parameters import FMU_FIELDS
from pyhrg.fmu import GyroFmu
from pyhrg.witness.information import (
    accumulate_information,
    compute_posterior,
    factor_covariance,
)
from pyhrg.witness.mechanisms import COUNT as MECHANISMS
from pyhrg.witness.mechanisms import SIGNALS, find, read_values
from pyhrg.witness.responses import Responses, measure_responses

HOURS = 2.0
ACCELEROMETER, MOUNTING = 10 * MICRO_G, 10 * ARCSEC
TESTS = {"channels in flight": 0.0, "with a self-test of 60 s": 60.0, "of 280 s": 280.0}
"""Durations of the self-test at power-on, s."""
SEED = 1
RESAMPLES = 999
UNKNOWN = slice(4, 7)
"""Signals of the maps, specific force and fast turning, to which the response is not known."""


@dataclass(frozen=True)
class Score:
    """R2 with its bootstrap interval of 95 % over triads, and the coverage of 90 % intervals."""

    r2: float
    low: float
    high: float
    coverage: float

    def __str__(self) -> str:
        return f"{self.r2:.3f} ({self.low:.3f} to {self.high:.3f}), coverage {self.coverage:.2f}"


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


def read_true_changes(device: Device, flight: Flight) -> Array:
    """(COUNT,) changes of the mechanisms from a calibrated gyro to its flight, SI."""
    drawn = {FMU_FIELDS[n]: v for n, v in flight.device.model.items() if n in FMU_FIELDS}
    changes = read_values(replace(flight.device, **drawn)) - read_values(device)
    changes[find("bias per rate of temperature")] = device.bias_per_temperature_rate
    return changes


def measure_triads(fmu: GyroFmu, drawn: list[DrawnTriad]) -> list[list[Known]]:
    return [
        [
            learn_gyro(measure_responses(fmu, device), device, flight)
            for device, flight in zip(triad.calibrated, triad.flights, strict=True)
        ]
        for triad in drawn
    ]


def learn_gyro(responses: Responses, device: Device, flight: Flight) -> Known:
    drift = Drift()
    prior = make_study_prior(responses, device, RAW, BenchPlan(), drift)
    drifted = make_study_drift(device, drift)
    return Known(
        responses=responses,
        prior=prior.covariance,
        changes=read_true_changes(device, flight) - drifted.mean,
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
        flown = compute_position_errors(triads, weights, number).radial[:, 0]
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
    the maps do under specific force, heating and fast turning is not known."""
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
        response = _respond(known[r][axis].responses, triads.rise[r, axis])
        error = response @ errors[r, axis]
        start = np.array([triads.start_angle[r, axis]])
        maps[r, :, axis] -= start_maps(error[:, None], start)[:, 0]
        carried = turn_weights(weights.maps, triads.start_angle[r])[:, :, :, axis] @ response
        covariance[r] += np.einsum("kip,pq,kjq->kij", carried, covariances[r, axis], carried)
    return NormalPrediction(compute_expected_error(weights, maps), covariance)


def _respond(responses: Responses, rise: float) -> Array:
    """(COUNT of signals, mechanisms) coefficients over the pattern angle per unit of each
    mechanism: of the map at power-on, of its change with warmth, and by the case's heating."""
    at_unit = responses.output[:, :2].reshape(MECHANISMS, -1).T
    response = np.zeros((COUNT, MECHANISMS))
    for place, name in enumerate(("one", "temperature", None, "heating")):
        size = 1.0 if name == "one" else rise
        rows = slice_coefficients(slice(place, place + 1))
        response[rows] = np.where(name == SIGNALS, size * at_unit, 0.0)
    return response


def tabulate(flown: Array, prediction: Prediction) -> Array:
    """(r, 4) flown error, and the 5 %, 50 % and 95 % quantiles of the predicted one, m."""
    quantiles = [prediction.radius(share)[:, 0] for share in (0.05, 0.5, 0.95)]
    return np.stack([flown, *quantiles], axis=1)


def score(table: Array) -> Score:
    """Score of r triads in m missions, from (r, m, 4) values of `tabulate`."""
    flown, low, middle, high = np.moveaxis(table, -1, 0)
    drawn = np.random.default_rng(SEED).integers(len(table), size=(RESAMPLES, len(table)))
    return Score(
        float(compute_r2(flown, middle)),
        *np.quantile(compute_r2(flown[drawn], middle[drawn]), (0.025, 0.975)).tolist(),
        float(np.mean((low <= flown) & (flown <= high))),
    )
