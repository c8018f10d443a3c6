"""Coverage of the calibration's intervals: maps of gyros drawn at random, against closed forms."""

from dataclasses import replace

import numpy as np

from pyhrg.bench.bench import Bench
from pyhrg.bench.bias.position.full_circumference import make_power_ons
from pyhrg.bench.bias.position.positions import Plan
from pyhrg.bench.calibration.calibration import PERIODS
from pyhrg.bench.calibration.calibration_maps import fit_maps
from pyhrg.bench.scale_factor.scale_factor import make_turn_power_ons
from pyhrg.common.units import DEG
from pyhrg.device.device import Device
from pyhrg.device.ready_devices import TYPICAL
from pyhrg.fmu import GyroFmu
from pyhrg.theory import closed_forms as theory

MODEL = "HRGSlow"
PLAN = Plan(24, 97.5 * DEG)
"""Tells all terms apart."""
RUNS = 3
RATE = 20 * DEG
"""Of the turns: a quarter of the rows that 5 deg/s takes."""


def drawn(generator: np.random.Generator) -> Device:
    """A gyro of the typical kind, with errors in every harmonic and a tilted axis."""
    return replace(
        TYPICAL.another(generator),
        demodulation_offset=generator.normal(0.0, 2e-5),
        pickoff_cubic=generator.normal(0.0, 2e-5),
        misalignment=abs(generator.normal(0.0, 5e-5)),
        misalignment_direction=generator.uniform(0.0, 2 * np.pi),
    )


def truth(device: Device) -> dict[str, float]:
    """Coefficients of both maps by finding, SI, to first order."""
    k, tau, x0 = device.bryan_factor, device.decay_time, device.demodulation_offset
    fourth = theory.static_bias_phasor(device)
    eighth = 0.75 * device.pickoff_cubic / 8
    return {
        "bias map mean": theory.mean_bias(device),
        "bias map cos2": 0.0,
        "bias map sin2": x0 / (2 * k * tau),
        "bias map cos4": fourth.real,
        "bias map sin4": fourth.imag,
        "bias map cos8": 0.0,
        "bias map sin8": 2 * eighth / (2 * k * tau),
        "scale factor map cos2": 0.0,
        "scale factor map sin2": -x0 / 2,
        "scale factor map cos4": device.pickoff_nonorthogonality / 4,
        "scale factor map sin4": -device.pickoff_gain_mismatch / 4,
        "scale factor map cos8": 0.0,
        "scale factor map sin8": -eighth,
    }


def repeat(fmu: GyroFmu, seed: int) -> dict[str, tuple[float, float, float]]:
    """Truth, low and high of each coefficient."""
    generator = np.random.default_rng(seed)
    device = drawn(generator)
    bench = Bench(fmu, device, seed, step=0.1)
    turns = make_turn_power_ons(bench, RATE, PERIODS, 1)
    tests = bench.run([*make_power_ons(bench, PLAN, RUNS, 1), *turns])
    found = fit_maps(bench.campaign(tests))
    findings = [*found.bias_map.values(), *found.scale_factor_map.values()]
    expected = truth(device)
    return {f.name: (expected[f.name], f.si_low, f.si_high) for f in findings}
