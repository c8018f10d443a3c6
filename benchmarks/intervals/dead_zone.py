"""Lock rate of random gyros, with and without anisotropy, from the map that the table turns."""

import numpy as np

from pyhrg.bench.bench import Bench
from pyhrg.bench.dead_zone import dead_zone
from pyhrg.bench.dead_zone.lock import FOURTH, fit_turning
from pyhrg.bench.estimation.harmonics import MEAN
from pyhrg.bench.estimation.sizes import estimate_amplitude
from pyhrg.device.ready_devices import TYPICAL
from pyhrg.fmu import GyroFmu
from pyhrg.theory import closed_forms as theory

MODEL = "HRGSlow"
RATE = 5 * dead_zone.MAP_RATE
"""Faster than the test's, so that a repeat is short."""


def repeat(fmu: GyroFmu, seed: int) -> dict[str, tuple[float, float, float]]:
    """Truth and interval of the lock rate and of the mean bias; zero without anisotropy."""
    result = {}
    device = TYPICAL.another(np.random.default_rng(seed))
    for name, gyro in (("", device), (", no anisotropy", device.without_anisotropy())):
        bench = Bench(fmu, gyro, seed, step=0.5)
        logs = [test.log for test in bench.run(dead_zone.plan_map_runs(bench, RATE))]
        fitted, _ = fit_turning(logs, bench.device.site)
        lock = estimate_amplitude("lock rate", fitted, FOURTH, "deg/h")
        result[f"lock rate{name}"] = (theory.lock_rate(gyro), lock.si_low, lock.si_high)
        result[f"mean bias{name}"] = (theory.mean_bias(gyro), *fitted.interval(MEAN))
    return result
