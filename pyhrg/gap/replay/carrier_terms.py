"""What the simulated gyro, an average over its carrier period, leaves out of a test's records."""

import numpy as np
from numpy.typing import NDArray

from pyhrg.device.device import Device
from pyhrg.gap.replay.observations import CHANNELS, Observed
from pyhrg.theory.closed_forms import beyond_the_average


def left_out(
    device: Device, test: Observed, wave_angle: NDArray[np.float64]
) -> dict[str, NDArray[np.float64]]:
    """(n,) means over the rows for each of `CHANNELS`; a record may have it or not
    (`beyond_the_average`).

    Args:
        device: the gyro.
        test: observed.
        wave_angle: (n,) of the pattern at the rows' ends, rad.
    """
    rate = test.inputs.table.means
    middle = device.bryan_factor * rate * test.log.interval / 2
    beyond = beyond_the_average(device, rate, wave_angle + middle)
    return {name: beyond.get(name, np.zeros(len(rate))) for name in CHANNELS}
