"""Coverage of the force map."""

from benchmarks.intervals._identified import (
    CONTROL_PERIOD,
    STEP,
    Intervals,
    bench,
    earth_rate,
    intervals,
)
from pyhrg.bench.identification import force_map
from pyhrg.common.units import DEG
from pyhrg.fmu import GyroFmu

MODEL = "HRGSlow"


def repeat(fmu: GyroFmu, seed: int) -> Intervals:
    """One gyro, 90 deg of pattern each way.

    The axis is that which the pick-offs' non-orthogonality d shows, d/4 off; means over a row are
    those of the ends of its steps, half a step late, over which Earth's rate turns the pattern. The
    force that turns the pattern is held over a control period and lifts the amplitude meanwhile.
    """
    on = bench(fmu, seed)
    device = on.device
    late = device.bryan_factor * earth_rate(on) * STEP / 2
    skew = device.pickoff_nonorthogonality / 4
    lifted = 2 * (device.bryan_factor * force_map.RATE) ** 2 * CONTROL_PERIOD
    outcome = force_map.evaluate(on.campaign(force_map.record(on, pattern_turn=90 * DEG)))
    return intervals(
        outcome,
        {
            "frequency split": device.frequency_split,
            "stiffness axis": device.stiffness_axis + skew + late,
            "frequency split from loop frequency": device.frequency_split,
            "decay time": 1 / (1 / device.decay_time - lifted),
        },
    )
