"""Bias over the circumference: mean, harmonics, tilt, of gyros with random errors."""

import math
from dataclasses import replace

import numpy as np

from pyhrg import theory
from pyhrg.bench.bench import Bench
from pyhrg.bench.bias import full_circumference
from pyhrg.bench.bias.positions import Plan
from pyhrg.device import Device
from pyhrg.fmu import GyroFmu
from pyhrg.parameters import TYPICAL
from pyhrg.units import ARCSEC, DEG

MODEL = "HRGSlow"
PLAN = Plan(16, 105 * DEG)


def repeat(fmu: GyroFmu, seed: int) -> dict[str, tuple[float, float, float]]:
    """Three power-ons of 16 positions, one data point each."""
    generator = np.random.default_rng(seed)
    device = replace(
        TYPICAL.another(generator),
        misalignment=generator.uniform(0, 30) * ARCSEC,
        misalignment_direction=generator.uniform(-math.pi, math.pi),
        demodulation_offset=generator.normal(0.0, 1e-6),
    )
    bench = Bench(fmu, device, seed, step=0.1)
    power_ons = full_circumference.power_ons(bench, PLAN, runs=3, segments=1)
    outcome = full_circumference.evaluate(bench.campaign(bench.run(power_ons)))
    return {
        name: (truth, outcome.finding(name).low, outcome.finding(name).high)
        for name, truth in truths(device).items()
    }


def truths(device: Device) -> dict[str, float]:
    """Closed forms at rest with the axis up, Earth's rate times the pick-off errors included."""
    phasor, earth = theory.static_bias_phasor(device), device.site.vertical_rate
    lean = device.site.horizontal_rate * math.sin(device.misalignment)
    offset, k = device.demodulation_offset, device.bryan_factor
    return {
        "mean of the map": theory.mean_bias(device),
        "bias cos2": -offset * earth,
        "bias sin2": offset / (2 * k * device.decay_time),
        "bias cos4": phasor.real - device.pickoff_gain_mismatch * earth,
        "bias sin4": phasor.imag - device.pickoff_nonorthogonality * earth,
        "bias tilt cos": lean * math.cos(device.misalignment_direction),
        "bias tilt sin": -lean * math.sin(device.misalignment_direction),
    }
