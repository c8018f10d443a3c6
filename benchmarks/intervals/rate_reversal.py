"""Coverage of the table rate both ways."""

from benchmarks.intervals._identified import Intervals, bench, bias_terms, hold_error, intervals
from pyhrg.bench.identification import rate_reversal
from pyhrg.fmu import GyroFmu

MODEL = "HRGSlow"


def repeat(fmu: GyroFmu, seed: int) -> Intervals:
    """One gyro, a period of the fourth harmonic each way."""
    on = bench(fmu, seed)
    device = on.device
    return intervals(
        rate_reversal.evaluate(on.campaign(rate_reversal.record(on, duration=70.0))),
        {
            "pick-off gain mismatch": device.pickoff_gain_mismatch,
            "pick-off non-orthogonality": device.pickoff_nonorthogonality,
            "scale factor error": hold_error(device),
            **bias_terms(device),
        },
    )
