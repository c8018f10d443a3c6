"""Gyros, benches and runs that tests share."""

from dataclasses import replace

import numpy as np
from numpy.typing import ArrayLike

from pyhrg.bench.bench import Bench
from pyhrg.bench.bias.position import full_circumference
from pyhrg.bench.outcome import Outcome
from pyhrg.bench.procedure import Procedure
from pyhrg.bench.readings.segments import Points
from pyhrg.device.device import Device
from pyhrg.device.ready_devices import TYPICAL
from pyhrg.fmu import GyroFmu

QUIET = replace(TYPICAL.without_noise(), power_on_scatter=0.0)

QUICK_PLAN = full_circumference.SHORTEST
"""Eight positions."""


def make_points(rate: ArrayLike, dwell: ArrayLike = 0) -> Points:
    """Data points of which rates and numbers of their positions alone matter."""
    values = np.asarray(rate, dtype=float)
    zero, dwells = np.zeros_like(values), np.zeros(len(values), dtype=int) + dwell
    return Points(values, zero, zero, zero, zero, zero, dwells, dwells, dwells)


def slow_bench(fmu: GyroFmu, device: Device, seed: int = 1) -> Bench:
    """A bench of hours: quasi-steady loops, 0.1 s steps."""
    return Bench(fmu, device, seed, step=0.1, workers=2)


def record_and_evaluate(procedure: Procedure, bench: Bench) -> Outcome:
    """Outcome of a procedure with its default plan."""
    return procedure.evaluate(bench.campaign(procedure.record(bench)))
