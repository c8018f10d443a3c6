"""Drift and deviation over a year of a gyro that loses its decay time."""

from dataclasses import replace

import numpy as np

from benchmarks.intervals._environment import FAST, Intervals, against, rate_noise
from pyhrg import theory
from pyhrg.bench.bench import Bench
from pyhrg.bench.bias import annual
from pyhrg.bench.bias.annual import AGEING, MONTH, MONTHS, Months, aged
from pyhrg.bench.bias.thermal_programme import POSITIONS
from pyhrg.bench.readings.segments import SEGMENT
from pyhrg.device import Device
from pyhrg.fmu import GyroFmu
from pyhrg.parameters import TYPICAL
from pyhrg.units import YEAR

MODEL = "HRGSlow"


def repeat(fmu: GyroFmu, seed: int) -> Intervals:
    """Twelve power-ons."""
    generator = np.random.default_rng(seed)
    model = {**FAST, AGEING: generator.uniform(0.0, 0.2) / YEAR}
    device = replace(TYPICAL.another(generator), model=model)
    bench = Bench(fmu, device, seed, step=1.0)
    outcome = annual.evaluate(bench.campaign(annual.record(bench)))
    return against(outcome, truths(device))


def truths(device: Device) -> dict[str, float]:
    """Of the closed forms of each month's gyro; Earth's rate times scale factor is in the bias."""
    gyros = [aged(device, month * MONTH) for month in range(MONTHS)]
    scale = np.array(
        [theory.hold_scale_factor_error(g.control_period, 0.0, g.decay_time) for g in gyros]
    )
    bias = np.array([theory.mean_bias(g) for g in gyros]) + device.site.vertical_rate * scale
    noise = rate_noise(device, SEGMENT) / np.sqrt(POSITIONS * annual.SEGMENTS)
    return {
        "bias annual stability": float(np.sqrt(noise**2 + np.var(bias, ddof=1))),
        "bias drift": Months(bias, noise).drift.value("drift"),
        "scale factor drift": Months(scale, 0.0).drift.value("drift"),
    }
