"""An output angle that counts from elsewhere than the pattern angle at power-on."""

import numpy as np

from pyhrg.common.arrays import Array
from pyhrg.common.site import Site
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
ROUNDING = 1e-12
"""Offset that is rounding, rad: far above that of a double, far below the noise of any reading."""


def mend_origin(log: Log, nominal: Device) -> tuple[Log, list[str]]:
    """A log of complete inputs whose output angle begins with what table and Earth have turned
    until its first reading, and a sentence where it began elsewhere. The pattern angle at power-on
    follows from the output angle, so that it would be wrong by the same offset."""
    angles, turns = _list_first(log, nominal.site)
    offset = float(np.median(angles - turns)) if len(angles) else 0.0
    if abs(offset) <= MAX_OFFSET + MAX_TURN_SHARE * float(np.max(np.abs(turns), initial=0.0)):
        return log, []
    note = (
        f"{log.source}: gyro_angle_deg begins {offset / DEG:.6g} deg beside what table and Earth "
        "had turned: this offset is taken out"
    )
    return replace_columns(log, {"gyro_angle": log.gyro_angle - offset}), [note]


def is_origin_set(log: Log, site: Site) -> bool:
    """Whether the origin of the output angle was set: to the first reading, or to what table and
    Earth had turned by then, as an import and `mend_origin` do. A reading has noise beside it."""
    angles, turns = _list_first(log, site)
    return bool((angles[:1] == 0).any() or (np.abs(angles - turns) < ROUNDING).any())


def _list_first(log: Log, site: Site) -> tuple[Array, Array]:
    """(m,) first readings of the output angle, and (m,) what table and Earth had turned, rad."""
    earth = np.cumsum(site.compute_earth_rate(log.axis_up)) * log.interval
    first = np.flatnonzero(np.isfinite(log.gyro_angle))[:READINGS]
    return log.gyro_angle[first], (log.table_angle + earth)[first]
