"""Coverage of the amplitude sweep."""

from dataclasses import replace

import numpy as np

from benchmarks.intervals._identified import Intervals, bench, intervals
from pyhrg.bench.identification import amplitude_sweep
from pyhrg.fmu import GyroFmu

MODEL = "HRGSlow"


def repeat(fmu: GyroFmu, seed: int) -> Intervals:
    """One gyro with a Duffing stiffness and a cubic of the pick-offs.

    The cubic shows the square of the amplitude, u, greater by 9/8 b u^2: the stiffness counts over
    what is shown.
    """
    on = bench(fmu, seed)
    generator = np.random.default_rng([seed, 1])
    stiffness, cubic = generator.normal(0.0, 1e-4), generator.normal(0.0, 1e-5)
    on = replace(on, device=replace(on.device, duffing=stiffness, pickoff_cubic=cubic))
    shown = np.square(amplitude_sweep.AMPLITUDES)
    seen = stiffness * (1 - 9 / 8 * cubic * np.polyfit(shown, shown**2, 1)[0])
    return intervals(
        amplitude_sweep.evaluate(on.campaign(amplitude_sweep.record(on, dwell=40.0))),
        {"Duffing shift": seen, "pick-off cubic": cubic},
    )
