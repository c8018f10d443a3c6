"""Coverage of the intervals of method B: one power-on each way, twelve periods of the pattern."""

import math

import numpy as np

from benchmarks.intervals._scale_factor import Intervals, compared, gyro
from pyhrg.bench.bench import Bench
from pyhrg.bench.readings.turns import PERIOD
from pyhrg.bench.scale_factor import scale_factor_rate
from pyhrg.bench.scale_factor.scale_factor import INTERVAL
from pyhrg.bench.scale_factor.scale_factor_rate import RATE
from pyhrg.device.ready_devices import Device
from pyhrg.fmu import GyroFmu

MODEL = "HRGSlow"


def repeat(fmu: GyroFmu, seed: int) -> Intervals:
    """Truth and interval by finding."""
    device = gyro(np.random.default_rng(seed))
    bench = Bench(fmu, device, seed, step=0.1)
    outcome = scale_factor_rate.evaluate(bench.campaign(scale_factor_rate.record(bench, runs=1)))
    found = outcome.finding("scale factor stability in run")
    stability = (period_deviation(device), found.si_low, found.si_high)
    return {**compared(outcome, device, RATE), found.name: stability}


def period_deviation(device: Device) -> float:
    """What the noise makes of the scale factor of a period; bounds lie between two rows."""
    period = PERIOD / (device.bryan_factor * RATE)
    share = (np.arange(13) * period / INTERVAL) % 1
    kept = float(np.mean(share**2 + (1 - share) ** 2))
    variance = device.angle_random_walk**2 * period + 2 * kept * device.angle_white_noise**2
    return math.sqrt(variance) / (RATE * period)
