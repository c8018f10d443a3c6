"""The closed simulation's answer to the inputs of a log."""

from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from pyhrg.common.files import write_whole
from pyhrg.common.units import DEG
from pyhrg.device.device import Device
from pyhrg.gap.replay.observations import observed
from pyhrg.gap.replay.replay import tells_start
from pyhrg.gap.replay.simulation import Simulation
from pyhrg.gap.soundness.doubt import Believed
from pyhrg.gap.soundness.glitches import with_inputs_mended
from pyhrg.gap.soundness.inputs import whole
from pyhrg.records import Log, LogError
from pyhrg.records.campaign import Test

Array = NDArray[np.float64]


def with_whole_inputs(log: Log, believed: Device) -> tuple[Log, list[str]]:
    """A log whose inputs can be replayed, and a sentence on each thing that was filled in, cut or
    taken for granted: as a diagnosis does.

    Raises:
        LogError: inputs that can't be told, or no row with both angles.
    """
    log, mended = with_inputs_mended(log)
    log, filled = whole(log, Believed(believed, believed.site))
    if not tells_start(log):
        raise LogError(
            f"{log.source}: no row with gyro_angle_deg and wave_angle_deg; expected one, which "
            "tells the start angle"
        )
    return log, [*mended, *filled]


def predicted(simulation: Simulation, believed: Device, closed: Device, log: Log) -> Array:
    """(n,) output angle, rad.

    Args:
        simulation: both fidelities.
        believed: for the power-on angle, which the log's angles tell by the believed Bryan factor.
        closed: the gyro that is simulated.
        log: whole inputs, and angles.

    Raises:
        GyroError: a gyro that the FMU refuses.
    """
    test = observed(Test("prediction", "manoeuvre", "holdout", log), believed)
    return simulation.answers(closed, test)["gyro_angle"]


def write(log: Log, angle: Array, path: Path) -> None:
    """Write times and angles as CSV.

    Raises:
        OSError: the folder can't be written.
    """
    rows = (f"{t:.15g},{a:.12g}\n" for t, a in zip(log.time, angle / DEG, strict=True))
    write_whole(path, ("time_s,gyro_angle_deg\n" + "".join(rows)).encode())
