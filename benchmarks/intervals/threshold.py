"""Responses of the threshold test: an ideal gyro's are 1, a dead zone or not."""

from dataclasses import replace

import numpy as np

from pyhrg.bench.bench import Bench
from pyhrg.bench.dynamic import threshold
from pyhrg.common.units import DEG
from pyhrg.device.ready_devices import TYPICAL
from pyhrg.fmu import GyroFmu

MODEL = "HRGSlow"


def repeat(fmu: GyroFmu, seed: int) -> dict[str, tuple[float, float, float]]:
    """Truth and interval of each response, on a gyro of random axes.

    A pattern free of anisotropy answers with 1; what the bias map adds while the pattern moves,
    and the pick-offs' mismatch, stay within 1e-4.
    """
    device = TYPICAL.another(np.random.default_rng(seed))
    bench = Bench(fmu, replace(device, name="coverage"), seed, step=0.1)
    tests = threshold.record(bench, rates=(2e-4 * DEG, 5e-5 * DEG), repeats=3, dwell=100.0)
    found = threshold.measure_responses([test.log for test in tests])
    return {
        f"response {r.rate / DEG:.0e} deg/s": (1.0, r.value - r.reach, r.value + r.reach)
        for r in found
    }
