"""Coverage of the intervals of method A: one power-on each way, two periods of the pattern."""

import numpy as np

from benchmarks.intervals._scale_factor import Intervals, compared, gyro
from pyhrg.bench.bench import Bench
from pyhrg.bench.scale_factor import scale_factor_angle
from pyhrg.bench.scale_factor.scale_factor_angle import RATE
from pyhrg.fmu import GyroFmu

MODEL = "HRGSlow"


def repeat(fmu: GyroFmu, seed: int) -> Intervals:
    """Truth and interval by finding."""
    device = gyro(np.random.default_rng(seed))
    bench = Bench(fmu, device, seed, step=0.1)
    tests = scale_factor_angle.record(bench, runs=1)
    return compared(scale_factor_angle.evaluate(bench.campaign(tests)), device, RATE)
