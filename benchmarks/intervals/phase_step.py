"""Coverage of steps of the demodulation phase."""

from benchmarks.intervals._identified import Intervals, bench, intervals
from pyhrg.bench.identification import phase_step
from pyhrg.fmu import GyroFmu

MODEL = "HRGSlow"


def repeat(fmu: GyroFmu, seed: int) -> Intervals:
    """One gyro, two angles."""
    on = bench(fmu, seed)
    outcome = phase_step.evaluate(on.campaign(phase_step.record(on)))
    seen = outcome.finding("frequency split in the quadrature force, times sin 4th").si_value
    return intervals(
        outcome,
        {
            "response to phase over that of the quadrature force": 1.0,
            "frequency split in the bias, times sin 4th": seen,
        },
    )
