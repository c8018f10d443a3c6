"""Coverage of virtual rotation both ways."""

from benchmarks.intervals._identified import (
    Intervals,
    bench,
    bias_terms,
    earth_rate,
    hold_error,
    intervals,
)
from pyhrg.bench.identification import virtual_rotation
from pyhrg.common.units import DEG
from pyhrg.fmu import GyroFmu

MODEL = "HRGSlow"


def repeat(fmu: GyroFmu, seed: int) -> Intervals:
    """One gyro, 90 deg of pattern each way."""
    on = bench(fmu, seed)
    device = on.device
    outcome = virtual_rotation.evaluate(
        on.campaign(virtual_rotation.record(on, pattern_turn=90 * DEG))
    )
    bias = bias_terms(device)
    bias["bias cos4"] -= device.pickoff_gain_mismatch * earth_rate(on)
    bias["bias sin4"] -= device.pickoff_nonorthogonality * earth_rate(on)
    return intervals(
        outcome,
        {
            "virtual rotation gain error": hold_error(device),
            "gain mismatch of pick-offs and drives": device.pickoff_gain_mismatch
            + device.drive_gain_mismatch,
            "non-orthogonality of pick-offs and drives": device.pickoff_nonorthogonality
            + device.drive_nonorthogonality,
            **bias,
        },
    )
