"""Coverage of the amplitude sweep."""

from dataclasses import replace

import numpy as np

from benchmarks.intervals._identified import Intervals, bench, intervals
from pyhrg.bench.identification import amplitude_sweep
from pyhrg.fmu import GyroFmu

MODEL = "HRGSlow"


def repeat(fmu: GyroFmu, seed: int) -> Intervals:
    """One gyro with a Duffing stiffness and a cubic of the pick-offs."""
    on = bench(fmu, seed)
    generator = np.random.default_rng([seed, 1])
    stiffness, cubic = generator.normal(0.0, 1e-4), generator.normal(0.0, 1e-5)
    on = replace(on, device=replace(on.device, duffing=stiffness, pickoff_cubic=cubic))
    return intervals(
        amplitude_sweep.evaluate(on.campaign(amplitude_sweep.record(on, dwell=40.0))),
        {"Duffing shift": stiffness, "pick-off cubic": cubic},
    )
