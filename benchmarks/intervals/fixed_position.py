"""Bias at a fixed position: the map where the power-on angle happens to be."""

from dataclasses import replace

import numpy as np

from benchmarks.intervals._environment import FAST, Intervals, against, mean_deviation, rate_noise
from pyhrg.bench.bench import Bench
from pyhrg.bench.bias.position import fixed_position
from pyhrg.bench.readings.segments import SEGMENT
from pyhrg.common.units import DEG
from pyhrg.device.device import Device
from pyhrg.device.ready_devices import TYPICAL
from pyhrg.fmu import GyroFmu
from pyhrg.theory import closed_forms as theory

MODEL = "HRGSlow"
RUNS, SEGMENTS = 5, 12


def repeat(fmu: GyroFmu, seed: int) -> Intervals:
    """Five power-ons of twenty minutes, at angles that repeat to 0 to 1 deg."""
    generator = np.random.default_rng(seed)
    scatter = generator.uniform(0, 1) * DEG
    device = replace(TYPICAL.another(generator), power_on_scatter=scatter, model=FAST)
    bench = Bench(fmu, device, seed, step=1.0)
    tests = bench.run(fixed_position.make_power_ons(bench, RUNS, SEGMENTS))
    return against(fixed_position.evaluate(bench.campaign(tests)), truths(device))


def truths(device: Device) -> dict[str, float]:
    """Means over power-on angles; a run's neighbours share the reading between them, which its
    mean square has 1 + 1/n times and its mean once."""
    bias, deviation = bias_at_power_on(device)
    white = 2 * (device.angle_white_noise / SEGMENT) ** 2 / SEGMENTS
    noise = float(np.sqrt(rate_noise(device, SEGMENT) ** 2 + white))
    of_mean = rate_noise(device, SEGMENTS * SEGMENT)
    return {
        "bias": bias,
        "bias stability": mean_deviation(noise, 0.0, SEGMENTS - 1),
        "bias repeatability": float(np.hypot(deviation, of_mean)),
    }


def bias_at_power_on(device: Device) -> tuple[float, float]:
    """Mean and standard deviation of the map over normal power-on angles."""
    away = np.exp(-8 * device.power_on_scatter**2 * np.array([1, 4]))
    phasor, turn = theory.static_bias_phasor(device), np.exp(-4j * device.power_on_angle)
    here = phasor * turn
    mean, size = away[0] * here.real, abs(phasor)
    square = (size**2 + away[1] * (here**2).real) / 2
    return theory.mean_bias(device) + mean, float(np.sqrt(max(square - mean**2, 0.0)))
