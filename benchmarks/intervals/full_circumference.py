"""Bias over the circumference: deviations, mean, harmonics, tilt, of gyros with random errors."""

import math
from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from benchmarks.intervals._environment import (
    FAST,
    Intervals,
    against,
    mean_deviation,
    quiet,
    rate_noise,
)
from pyhrg.bench.bench import Bench
from pyhrg.bench.bias.position import full_circumference
from pyhrg.bench.bias.position.full_circumference import read_runs
from pyhrg.bench.bias.position.positions import Plan, estimate_within, group_by_position
from pyhrg.bench.readings.segments import SEGMENT, Points
from pyhrg.common.units import ARCSEC, DEG
from pyhrg.device.device import Device
from pyhrg.device.ready_devices import TYPICAL
from pyhrg.fmu import GyroFmu
from pyhrg.theory import closed_forms as theory

MODEL = "HRGSlow"
PLAN = Plan(16, 168.75 * DEG)
RUNS, SEGMENTS = 3, 2


def repeat(fmu: GyroFmu, seed: int) -> Intervals:
    """Three power-ons of 16 positions, two data points each."""
    generator = np.random.default_rng(seed)
    device = replace(
        TYPICAL.another(generator),
        misalignment=generator.uniform(0, 30) * ARCSEC,
        misalignment_direction=generator.uniform(-math.pi, math.pi),
        model=FAST,
        demodulation_offset=generator.normal(0.0, 1e-6),
    )
    bench = Bench(fmu, device, seed, step=1.0)
    power_ons = full_circumference.make_power_ons(bench, PLAN, RUNS, SEGMENTS)
    outcome = full_circumference.evaluate(bench.campaign(bench.run(power_ons)))
    without = replace(bench, device=quiet(device))
    runs = read_runs(without.campaign(without.run(power_ons)))
    return against(outcome, {**truths(device), **deviations(device, runs)})


def truths(device: Device) -> dict[str, float]:
    """Closed forms at rest with the axis up, Earth's rate times the pick-off errors included."""
    phasor, earth = theory.static_bias_phasor(device), device.site.vertical_rate
    lean = device.site.horizontal_rate * math.sin(device.misalignment)
    offset, k = device.demodulation_offset, device.bryan_factor
    cosine = phasor.real - device.pickoff_gain_mismatch * earth
    sine = phasor.imag - device.pickoff_nonorthogonality * earth
    return {
        "mean of the map": theory.mean_bias(device),
        "fourth harmonic": math.hypot(cosine, sine),
        "bias cos2": -offset * earth,
        "bias sin2": offset / (2 * k * device.decay_time),
        "bias cos4": cosine,
        "bias sin4": sine,
        "bias tilt cos": lean * math.cos(device.misalignment_direction),
        "bias tilt sin": -lean * math.sin(device.misalignment_direction),
    }


def deviations(device: Device, runs: Sequence[Points]) -> dict[str, float]:
    """Of the same runs without noise, and of the noise; neighbours share a reading."""
    noise = rate_noise(device, SEGMENT)
    white = 2 * (device.angle_white_noise / SEGMENT) ** 2 / SEGMENTS
    of_mean = rate_noise(device, SEGMENTS * SEGMENT) / math.sqrt(PLAN.positions)
    stability = [mean_deviation(noise, np.std(r.rate, ddof=1), len(r) - 1) for r in runs]
    means = [np.mean(run.rate) for run in runs]
    within = estimate_within("", runs).si_value
    between = [np.var([np.mean(group) for group in group_by_position(run)], ddof=1) for run in runs]
    return {
        "bias": float(np.mean(means)),
        "bias stability": float(np.mean(stability)),
        "bias repeatability": math.hypot(of_mean, np.std(means, ddof=1)),
        "within positions": math.hypot(math.hypot(noise, white**0.5), within),
        "between positions": float(np.sqrt(np.mean(between))),
    }
