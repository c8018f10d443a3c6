"""Gyros with random imperfections for the coverage of the identification tests."""

import math
from collections.abc import Mapping

import numpy as np

from pyhrg.bench.bench import Bench
from pyhrg.bench.outcome import Outcome
from pyhrg.common.units import ARCSEC, DEG_PER_SQRT_H
from pyhrg.device.ready_devices import Device
from pyhrg.fmu import GyroFmu
from pyhrg.theory import closed_forms as theory

STEP = 0.1
CONTROL_PERIOD = 1e-3
Intervals = dict[str, tuple[float, float, float]]
"""Name -> truth, low, high."""


def gyro(seed: int) -> Device:
    """Imperfections of a trimmed gyro, each drawn by itself, with noise."""
    generator = np.random.default_rng(seed)
    g, d, gd, nd, p = generator.normal(0.0, 4e-5, 5)
    return Device(
        decay_time=generator.uniform(300.0, 700.0),
        damping_anisotropy=generator.uniform(0.5e-6, 3e-6),
        damping_axis=generator.uniform(0.0, math.pi / 2),
        frequency_split=2 * math.pi * generator.uniform(0.2e-3, 0.6e-3),
        stiffness_axis=generator.uniform(0.0, math.pi / 2),
        pickoff_gain_mismatch=g,
        pickoff_nonorthogonality=d,
        drive_gain_mismatch=gd,
        drive_nonorthogonality=nd,
        phase_error=p,
        angle_random_walk=generator.uniform(1e-4, 4e-4) * DEG_PER_SQRT_H,
        angle_white_noise=generator.uniform(0.02, 0.1) * ARCSEC,
        power_on_angle=generator.uniform(0.0, math.pi / 2),
    )


def bench(fmu: GyroFmu, seed: int) -> Bench:
    """That gyro on the bench."""
    return Bench(fmu, gyro(seed), seed=seed, step=STEP)


def earth_rate(on: Bench) -> float:
    """On the input axis that points up, rad/s."""
    return on.device.site.vertical_rate


def hold_error(device: Device) -> float:
    """Scale-factor error of forces that are held."""
    return theory.hold_scale_factor_error(CONTROL_PERIOD, 0.0, device.decay_time)


def bias_terms(device: Device) -> dict[str, float]:
    """Mean, cosine and sine of the bias map at inertial rest."""
    fourth = theory.static_bias_phasor(device)
    return {
        "bias mean": theory.mean_bias(device),
        "bias cos4": fourth.real,
        "bias sin4": fourth.imag,
    }


def intervals(outcome: Outcome, truths: Mapping[str, float]) -> Intervals:
    """Of the findings whose truth is known."""
    found = {finding.name: finding for finding in outcome.findings}
    return {
        name: (truth, found[name].si_low, found[name].si_high) for name, truth in truths.items()
    }
