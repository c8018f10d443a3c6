"""Range in the force-to-rebalance mode, where the drives' authority ends it: F/(2 k)."""

from dataclasses import replace

import numpy as np

from pyhrg.bench.bench import Bench
from pyhrg.bench.dynamic import measuring_range
from pyhrg.fmu import GyroFmu
from pyhrg.parameters import TYPICAL
from pyhrg.units import DEG

MODEL = "HRG"


def repeat(fmu: GyroFmu, seed: int) -> dict[str, tuple[float, float, float]]:
    """Truth, and the rates that bracket it, of a random authority."""
    authority = np.random.default_rng(seed).uniform(0.05, 0.2)
    model = {"controller.forceToRebalance": 1.0, "drive.authority": authority}
    device = replace(
        TYPICAL.without_anisotropy(), power_on_angle=0.0, power_on_scatter=0.0, model=model
    )
    bench = Bench(fmu, device, seed)
    tests = measuring_range.record(bench, tuple(np.geomspace(4, 40, 6) * DEG), stages=1)
    found = measuring_range.evaluate(bench.campaign(tests)).finding("measuring range")
    truth = authority / (2 * device.bryan_factor)
    return {"range, force to rebalance": (truth, found.low, found.high)}
