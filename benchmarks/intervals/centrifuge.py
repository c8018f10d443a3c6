"""Bias on the centrifuge: four levels along each axis at four pattern angles."""

import numpy as np

from benchmarks.intervals._environment import Intervals, against
from benchmarks.intervals._force import feeling, linear, squares
from pyhrg.bench.bench import Bench, PowerOn
from pyhrg.bench.bias.environment import centrifuge
from pyhrg.device.device import Device
from pyhrg.fmu import GyroFmu

MODEL = "HRGSlow"
LEVELS = (-20.0, -10.0, 10.0, 20.0)


def repeat(fmu: GyroFmu, seed: int) -> Intervals:
    """One power-on, one data point a level."""
    device = feeling(np.random.default_rng(seed), gain=1e-7, square=1e-9)
    bench = Bench(fmu, device, seed, step=1.0)
    course = centrifuge.make_programme(bench, LEVELS)
    tests = bench.run([PowerOn("centrifuge", centrifuge.KIND, course)])
    return against(centrifuge.evaluate(bench.campaign(tests)), truths(device))


def truths(device: Device) -> dict[str, float]:
    """The input axis is level: Earth's rate is not on it."""
    expected = linear(device)
    for axis, value in zip("xyz", squares(device), strict=True):
        expected[f"g squared {axis * 2}"] = 0.0
        expected[f"g squared {axis * 2} sin4"] = value
    return expected
