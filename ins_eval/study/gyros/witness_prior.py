"""Prior of a study's gyro before its channels are read in flight (witness.md, Eq. 3).

The population says how far mechanisms reach, the bench's records narrow that, and the drift widens
it again. The bench's records are those of `bench_plan`, with the gyro's own channels and, because
the turntable's rate is known, its output.
"""

from dataclasses import replace
from functools import cache

import numpy as np

from fmu_build.bundle import build_fmu
from ins_eval.error_model.effects import ANGULAR_GAIN
from ins_eval.mission_model.missions import WARM_UP
from ins_eval.study.gyros.bench_plan import TABLE_RATE, WARM_RISE, BenchPlan
from ins_eval.study.gyros.drift import AGEING_SHARE, LARGEST_LEAKAGE, Drift
from ins_eval.study.gyros.measured_gyro import FLICKER_FLOOR
from ins_eval.study.gyros.population import BIAS_PER_G, BIAS_PER_KELVIN, RAW, Population
from pyhrg.bench.readings.segments import SEGMENT
from pyhrg.common.arrays import Array
from pyhrg.common.units import STANDARD_GRAVITY
from pyhrg.device.device import Device
from pyhrg.fmu import GyroFmu
from pyhrg.witness.design import Motion, stack_signals
from pyhrg.witness.information import (
    accumulate_information,
    accumulate_output_information,
    compute_posterior,
)
from pyhrg.witness.mechanisms import COUNT, STEADY, read_values
from pyhrg.witness.prior import Prior, compute_turn_on_covariance, make_drift_prior
from pyhrg.witness.responses import Responses, measure_responses

DRAWS = 400
"""Number of gyros by which a population's spread is taken. Chosen: known to 4 %."""
ROW = 0.1
"""Length of a row of the bench's motions, s. Chosen."""


def make_study_prior(
    responses: Responses, device: Device, population: Population, plan: BenchPlan, drift: Drift
) -> Prior:
    """Make the prior of the changes of a gyro's mechanisms since it was calibrated and benched.

    responses: responses of the calibrated device.
    """
    drifted = make_study_drift(device, drift)
    benched = compute_bench_covariance(responses, device, population, plan)
    return Prior(drifted.mean, drifted.covariance + benched)


def compute_bench_covariance(
    responses: Responses, device: Device, population: Population, plan: BenchPlan
) -> Array:
    """(COUNT, COUNT) covariance of what the bench's records leave unknown of a calibrated gyro,
    and of the mean of its power-ons."""
    benched = compute_posterior(
        compute_population_covariance(population), measure_bench(responses, device, plan)
    )
    return benched + compute_turn_on_covariance(device) / plan.runs


def widen_prior(prior: Prior, device: Device) -> Prior:
    """Prior of a device that was measured only by the study's bench, which measures no sensitivity
    to specific force or to the rate of temperature."""
    responses = measure_responses(GyroFmu(build_fmu("HRGSlow")), device)
    benched = compute_bench_covariance(responses, device, RAW, BenchPlan())
    drifted = np.diag(make_study_drift(device, Drift()).covariance)
    unmeasured = np.diag(np.where(STEADY, 0.0, drifted))
    return Prior(prior.mean, prior.covariance + benched + unmeasured)


def forget_unmeasured(device: Device) -> Device:
    """This device with zero for every mechanism that no bench of the study measures."""
    return replace(
        device,
        bias_per_acceleration=0.0,
        pickoff_gain_per_acceleration=0.0,
        bias_per_temperature_rate=0.0,
    )


def make_study_drift(device: Device, drift: Drift) -> Prior:
    """Distribution of what changes from calibration to flight, and of the sensitivities to the rate
    of temperature and to specific force, which no bench measures."""
    warming_bias = BIAS_PER_KELVIN * WARM_UP
    return make_drift_prior(
        forget_unmeasured(device),
        drift.age,
        AGEING_SHARE,
        LARGEST_LEAKAGE,
        temperature_rate_bias=warming_bias,
        specific_force_bias=BIAS_PER_G / STANDARD_GRAVITY,
        cubic=0.0,
    )


@cache
def compute_population_covariance(population: Population) -> Array:
    """(COUNT, COUNT) covariance of the mechanisms of a population, which are uncorrelated, SI."""
    generator = np.random.default_rng(0)
    values = [read_values(population.draw(generator)) for _ in range(DRAWS)]
    return np.diag(np.where(STEADY, np.var(values, axis=0), 0.0))


def measure_bench(responses: Responses, device: Device, plan: BenchPlan) -> Array:
    """(COUNT, COUNT) Fisher information of the bench's records. The output's noise is the random
    walk and, as white noise of the same variance in a segment's mean, the flicker noise."""
    flicker = FLICKER_FLOOR * device.bias_instability
    noise = float(np.sqrt(device.angle_random_walk**2 + SEGMENT * flicker**2))
    information = np.zeros((COUNT, COUNT))
    for motion, runs in _list_motions(plan):
        information = information + runs * (
            accumulate_information(responses, motion)
            + accumulate_output_information(responses, motion, noise)
        )
    return information


def _list_motions(plan: BenchPlan) -> list[tuple[Motion, int]]:
    """Motions of the bench, and how often each is recorded."""
    motions = []
    for rise, runs in ((0.0, plan.runs), (WARM_RISE, 1)):
        positions = np.pi * np.arange(plan.positions) / plan.positions
        at_rest = np.zeros(plan.positions)
        length = SEGMENT * plan.segments
        unmoved = stack_signals(at_rest)
        motions.append((Motion(length, positions, at_rest, at_rest, at_rest + rise, unmoved), runs))
        duration = plan.periods * np.pi / 2 / (ANGULAR_GAIN * TABLE_RATE)
        time = np.arange(0.0, duration, ROW)
        turning = stack_signals(0 * time)
        for rate in (TABLE_RATE, -TABLE_RATE):
            every = np.ones_like(time)
            angle = -ANGULAR_GAIN * rate * time
            motions.append(
                (Motion(ROW, angle, rate * every, 0 * every, rise * every, turning), runs)
            )
    return motions
