"""What the carrier makes of the loops' signals beyond its average."""

import numpy as np

from pyhrg.common.arrays import Array
from pyhrg.device.device import Device
from pyhrg.gap.replay.observations import CHANNELS, ObservedTest
from pyhrg.theory.closed_forms import beyond_the_average


def compute_carrier_terms(
    device: Device, test: ObservedTest, wave_angle: Array
) -> dict[str, Array]:
    """(n,) row means by channel, SI, of the next order of the average (docs/methods/replay.md, Eq.
    8), for the (n,) pattern angle at the rows' ends, rad. A record may contain them or not, so the
    whitening counts them as noise of this shape."""
    rate = test.inputs.table.means
    to_middle = device.bryan_factor * rate * test.log.interval / 2
    terms = beyond_the_average(device, rate, wave_angle + to_middle)
    return {name: terms.get(name, np.zeros(len(rate))) for name in CHANNELS}
