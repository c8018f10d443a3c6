"""Bound of the bias map after a time in each class, and what stays confounded."""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass

import numpy as np

from benchmarks.witness.motions import CLASSES, Ride, load_ride
from benchmarks.witness.uncertainty import (
    compute_map_deviation,
    compute_mean_deviation,
    rank_directions,
)
from ins_eval.mission_model.missions import STILL
from ins_eval.study.gyros.bench_plan import BenchPlan
from ins_eval.study.gyros.drift import Drift
from ins_eval.study.gyros.population import RAW
from ins_eval.study.gyros.witness_prior import make_study_drift, make_study_prior
from pyhrg.common.arrays import Array
from pyhrg.common.units import DEG_PER_H, MINUTE
from pyhrg.device.device import Device
from pyhrg.fmu import GyroFmu
from pyhrg.witness.design import Motion
from pyhrg.witness.information import (
    accumulate_information,
    compute_posterior,
)
from pyhrg.witness.mechanisms import NAMES, THERMAL
from pyhrg.witness.responses import Responses, measure_responses

ENDS = (0.0, 1 * MINUTE, 10 * MINUTE, 60 * MINUTE)
"""Times after the alignment, s, at which the bound is taken; the channels count from power-on."""
AXES = {"level": 0, "vertical": 2}
TESTS = {"none": 0.0, "60 s": 60.0, "280 s": 280.0}
"""Durations of the self-test at power-on, s."""
SEED = 5


@dataclass(frozen=True)
class SampleGyro:
    """A gyro of the study's population with what is known before its flight."""

    device: Device
    responses: Responses
    rise: float
    prior: Array

    @property
    def drift(self) -> Array:
        return make_study_drift(self.device, Drift()).covariance


def draw_sample(fmu: GyroFmu, count: int) -> list[SampleGyro]:
    generator, drift = np.random.default_rng(SEED), Drift()
    sample = []
    for _ in range(count):
        device = RAW.draw(generator)
        responses = measure_responses(fmu, device)
        prior = make_study_prior(responses, device, RAW, BenchPlan(), drift)
        rise = generator.uniform(drift.coolest, drift.warmest)
        sample.append(SampleGyro(device, responses, rise, prior.covariance))
    return sample


def tabulate_bounds(sample: list[SampleGyro]) -> Iterator[tuple[str, str, str, Array]]:
    """Class, axis, self-test, and (4, 2) rms over gyros, deg/h, of the map's standard deviation and
    of its mean's at `ENDS`."""
    for mission, title in CLASSES.items():
        ride = load_ride(mission, 1.0)
        for axis, place in AXES.items():
            for test, duration in TESTS.items():
                bounds = [_bound(each, ride, place, duration) for each in sample]
                yield title, axis, test, np.sqrt(np.mean(np.square(bounds), axis=0))


def compute_prior_figures(sample: list[SampleGyro]) -> Mapping[str, float]:
    """Rms over gyros of the map's standard deviation before the flight, deg/h."""

    def average(covariances: list[Array]) -> float:
        deviations = [
            compute_map_deviation(each.responses, covariance, each.rise)
            for each, covariance in zip(sample, covariances, strict=True)
        ]
        return float(np.sqrt(np.mean(np.square(deviations)))) / DEG_PER_H

    return {
        "drift and bench": average([each.prior for each in sample]),
        "drift alone": average([each.drift for each in sample]),
    }


def tabulate_mechanisms(sample: list[SampleGyro], mission: str) -> Iterator[tuple[str, Array]]:
    """Title and (COUNT,) rms over gyros of each mechanism's standard deviation after an hour over
    that before the flight, in a mission."""
    ride = load_ride(mission, 1.0)
    for axis, place in AXES.items():
        for test, duration in TESTS.items():
            ratios = []
            for each in sample:
                motion = ride.follow(place, each.device.power_on_angle, each.rise, duration)
                information = accumulate_information(each.responses, motion)
                posterior = compute_posterior(each.prior, information)
                ratios.append(np.diag(posterior) / np.diag(each.prior))
            yield f"{axis}, self-test {test}", np.sqrt(np.mean(ratios, axis=0))


def compute_thermal_bound(sample: list[SampleGyro]) -> float:
    """Rms over gyros of the map's standard deviation, deg/h, if thermal coefficients alone were
    unknown, as they are after the bench."""
    thermal = np.outer(THERMAL, THERMAL)
    deviations = [
        compute_map_deviation(each.responses, np.where(thermal, each.prior, 0.0), each.rise)
        for each in sample
    ]
    return float(np.sqrt(np.mean(np.square(deviations)))) / DEG_PER_H


def list_confounded(gyro: SampleGyro, motion: Motion) -> list[str]:
    """Lines on the directions among what drifts, from the best seen to the least."""
    information = accumulate_information(gyro.responses, motion)
    lines = []
    for each in rank_directions(gyro.drift, information):
        parts = [(abs(x), x, n) for x, n in zip(each.direction, NAMES, strict=True)]
        named = [f"{x:+.2f} {n}" for size, x, n in sorted(parts, reverse=True) if size > 0.25]
        if np.any(np.diag(gyro.drift)[np.abs(each.direction) > 0.25] > 0):
            lines.append(f"{each.gain:10.3g}  {', '.join(named)}")
    return lines


def _bound(gyro: SampleGyro, ride: Ride, axis: int, test: float) -> Array:
    motion = ride.follow(axis, gyro.device.power_on_angle, gyro.rise, test)
    information, done, bounds = np.zeros_like(gyro.prior), 0, []
    for end in ENDS:
        row = round((STILL + end) / motion.interval)
        information = information + accumulate_information(
            gyro.responses, motion.take(slice(done, row))
        )
        done = row
        posterior = compute_posterior(gyro.prior, information)
        bounds.append(
            [
                measure(gyro.responses, posterior, gyro.rise) / DEG_PER_H
                for measure in (compute_map_deviation, compute_mean_deviation)
            ]
        )
    return np.array(bounds)
