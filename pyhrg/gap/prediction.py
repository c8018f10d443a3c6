"""The closed simulation's answer to the inputs of a log."""

from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from fmu_build.files import write_whole
from pyhrg.campaign import Test
from pyhrg.device import Device
from pyhrg.gap.observations import observed
from pyhrg.gap.simulation import Simulation
from pyhrg.records import Log
from pyhrg.units import DEG

Array = NDArray[np.float64]


def predicted(simulation: Simulation, believed: Device, closed: Device, log: Log) -> Array:
    """(n,) output angle, rad.

    Args:
        simulation: both fidelities.
        believed: for the power-on angle, which the log's angles tell by the believed Bryan factor.
        closed: the gyro that is simulated.
        log: inputs, and the angles of its first rows.

    Raises:
        LogError: an input is missing.
        GyroError: a gyro that the FMU refuses.
    """
    log.require("table_angle", "axis_up", "temperature", "gyro_angle", "wave_angle")
    test = observed(Test("prediction", "manoeuvre", "holdout", log), believed)
    return simulation.answers(closed, test)["gyro_angle"]


def write(log: Log, angle: Array, path: Path) -> None:
    """Write times and angles as CSV.

    Raises:
        OSError: the folder can't be written.
    """
    rows = (f"{t:.15g},{a:.12g}\n" for t, a in zip(log.time, angle / DEG, strict=True))
    write_whole(path, ("time_s,gyro_angle_deg\n" + "".join(rows)).encode())
