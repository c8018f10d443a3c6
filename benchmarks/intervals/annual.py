"""Drift and deviation over a year of a gyro that loses its decay time."""

from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from benchmarks.intervals._environment import FAST, Intervals, against, pair_noise, rate_noise
from pyhrg.bench.bench import Bench
from pyhrg.bench.bias.thermal import annual
from pyhrg.bench.bias.thermal.annual import AGEING, MONTH, MONTHS, Months, age_device
from pyhrg.bench.bias.thermal_programme import POSITIONS
from pyhrg.bench.readings.segments import SEGMENT
from pyhrg.common.units import YEAR
from pyhrg.device.device import Device
from pyhrg.device.ready_devices import TYPICAL
from pyhrg.fmu import GyroFmu
from pyhrg.records import Log
from pyhrg.theory import closed_forms as theory

MODEL = "HRGSlow"


def repeat(fmu: GyroFmu, seed: int) -> Intervals:
    """Twelve power-ons."""
    generator = np.random.default_rng(seed)
    model = {**FAST, AGEING: generator.uniform(0.0, 0.2) / YEAR}
    device = replace(TYPICAL.another(generator), model=model)
    bench = Bench(fmu, device, seed, step=1.0)
    tests = annual.record(bench)
    outcome = annual.evaluate(bench.campaign(tests))
    return against(outcome, {**truths(device), **scale_stability(device, tests[0].log)})


def truths(device: Device) -> dict[str, float]:
    """Of the closed forms of each month's gyro; Earth's rate times scale factor is in the bias."""
    gyros, scale = months(device), scale_errors(device)
    bias = np.array([theory.mean_bias(g) for g in gyros]) + device.site.vertical_rate * scale
    noise = rate_noise(device, SEGMENT) / np.sqrt(POSITIONS * annual.SEGMENTS)
    return {
        "bias annual stability": float(np.sqrt(noise**2 + np.var(bias, ddof=1))),
        "bias drift": Months(bias, noise, 0).drift.value("drift"),
        "scale factor drift": Months(scale, 0.0, 0).drift.value("drift"),
    }


def scale_stability(device: Device, log: Log) -> dict[str, float]:
    """Of the months' closed forms, and of the noise of a month's pairs of spins."""
    noise = pair_noise(device, log) / np.sqrt(annual.PAIRS)
    spread = np.var(scale_errors(device), ddof=1)
    return {"scale factor annual stability": float(np.sqrt(noise**2 + spread))}


def months(device: Device) -> list[Device]:
    """The gyro of each month."""
    return [age_device(device, month * MONTH) for month in range(MONTHS)]


def scale_errors(device: Device) -> NDArray[np.float64]:
    """(n,) scale-factor error of each month's gyro."""
    return np.array(
        [
            theory.hold_scale_factor_error(g.control_period, 0.0, g.decay_time)
            for g in months(device)
        ]
    )
