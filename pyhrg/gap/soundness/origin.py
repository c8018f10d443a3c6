"""An output angle that counts from elsewhere than the pattern angle at power-on."""

import numpy as np

from pyhrg.common.units import DEG
from pyhrg.device.device import Device
from pyhrg.gap.soundness.exclusion import replace_columns
from pyhrg.records import Log

MAX_OFFSET = 2 * DEG
"""Largest angle by which the first readings may differ from what table and Earth have turned, rad.
Chosen: twice what pick-offs read whose axes are off by ten times the typical size."""
MAX_TURN_SHARE = 0.01
"""Share of what the table has turned that the first reading may differ by as well. Chosen: an error
of the angular gain of 1 %."""
READINGS = 9
"""Number of first readings whose median offset counts: one of them may be wrong. Chosen."""


def mend_origin(log: Log, nominal: Device) -> tuple[Log, list[str]]:
    """A log of complete inputs whose output angle begins with what table and Earth have turned
    until its first reading, and a sentence where it began elsewhere. The pattern angle at power-on
    follows from the output angle, so that it would be wrong by the same offset."""
    earth = np.cumsum(nominal.site.compute_earth_rate(log.axis_up)) * log.interval
    turns = log.table_angle + earth
    first = np.flatnonzero(np.isfinite(log.gyro_angle))[:READINGS]
    offset = float(np.median((log.gyro_angle - turns)[first])) if len(first) else 0.0
    if abs(offset) <= MAX_OFFSET + MAX_TURN_SHARE * float(
        np.max(np.abs(turns[first]), initial=0.0)
    ):
        return log, []
    note = (
        f"{log.source}: gyro_angle_deg begins {offset / DEG:.6g} deg beside what table and Earth "
        "had turned: this offset is taken out"
    )
    return replace_columns(log, {"gyro_angle": log.gyro_angle - offset}), [note]
