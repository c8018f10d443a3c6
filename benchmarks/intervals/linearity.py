"""Coverage of the intervals of the linearity test: three power-ons, all rates.

The damping anisotropy reaches values at which the lowest rates show it (the pattern lingers where
it is slow), so that the nonlinearity is anything from none to plain. What the same gyro shows
without noise is the truth; of the repeatability, what noise does to the slope.
"""

import math
from dataclasses import replace

import numpy as np

from benchmarks.intervals._scale_factor import Intervals, gyro, noiseless
from pyhrg.bench.bench import Bench
from pyhrg.bench.readings.turns import PERIOD
from pyhrg.bench.scale_factor import linearity
from pyhrg.bench.scale_factor.linearity import Line
from pyhrg.common.units import DEG
from pyhrg.device.ready_devices import Device
from pyhrg.fmu import GyroFmu

MODEL = "HRGSlow"
RUNS = 3
RATES = tuple(rate * DEG for rate in (2, 5, 10, 20, 30, 40, 50, 60, 80, 100, 120))
"""Not as slow as the test's, so that a repeat is short."""


def repeat(fmu: GyroFmu, seed: int) -> Intervals:
    """Truth and interval by finding."""
    generator = np.random.default_rng(seed)
    anisotropy = 10 ** generator.uniform(-6.0, -3.3)
    device = replace(gyro(generator), damping_anisotropy=anisotropy)
    bench = Bench(fmu, device, seed, step=0.1)
    outcome = linearity.evaluate(bench.campaign(linearity.record(bench, RUNS, RATES)))
    quiet = replace(bench, device=noiseless(device))
    campaign = quiet.campaign(linearity.record(quiet, 1, RATES))
    truth = linearity.evaluate(campaign)
    names = [f.name for f in truth.findings]
    values = {name: truth.finding(name).si_value for name in names}
    values["scale factor repeatability"] = slope_deviation(
        linearity.read_lines(campaign)[0], device
    )
    return {
        name: (values[name], outcome.finding(name).si_low, outcome.finding(name).si_high)
        for name in names
    }


def slope_deviation(line: Line, device: Device) -> float:
    """Standard deviation of K from noise on the means at each rate."""
    period = PERIOD / (device.bryan_factor * np.abs(line.input))
    time = period * np.ceil(linearity.SHORTEST_AVERAGE / period * (1 - 1e-3))
    variance = device.angle_random_walk**2 / time + 2 * device.angle_white_noise**2 / time**2
    lever = line.input - line.input.mean()
    return math.sqrt(float(np.sum(lever**2 * variance))) / float(np.sum(lever**2))
