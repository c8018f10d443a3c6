"""Check of the stated latitude against the one that a standing vehicle's gyros measure.

Gravity gives the vertical, and the gyros give Earth's rate about it: RATE sin(latitude), upward
(Groves 2013, section 5.6.2).
"""

import numpy as np

from ins_eval.alignment.analytic import mean_rate_variance
from ins_eval.common import earth
from ins_eval.common.sensor_errors import SensorErrors
from pyhrg.common.errors import HrgError
from pyhrg.records.imu.increments import Increments

MAX_RATE_DEVIATION = 0.2
"""Largest relative difference of the mean rate from Earth's. Chosen: beyond it the vehicle turned,
and no latitude can be read."""
RATE_TOLERANCE = 0.06
"""Tolerance of the rate about the vertical, relative to Earth's rate. Chosen: it covers creeping
tilt, scale-factor errors and a place read off a map; 3.4 deg of latitude at the equator, 4.9 deg at
45."""
BOUND_SIGMA = 5.0
"""Sigmas of the measured rate that are added to the tolerance. Chosen."""
PARTS = 20
"""Parts of the record whose mean rates' scatter is that of vehicle and gyros. Chosen."""


def check_latitude(record: Increments, latitude: float, errors: SensorErrors) -> None:
    """Check that the gyros do not contradict the stated latitude, rad.

    The bound of the rate about the vertical is `RATE_TOLERANCE` plus 5 sigma, both of the gyros'
    stated errors and of the scatter between `PARTS` parts of the record. A vehicle that swings in
    heading has a large scatter and so hides a wrong latitude. On the equator reversed gyros are not
    detected.
    """
    force = record.velocity.sum(axis=0)
    up = force / np.linalg.norm(force)
    mean = record.rotation.sum(axis=0) / record.duration
    if abs(np.linalg.norm(mean) / earth.RATE - 1) > MAX_RATE_DEVIATION:
        return
    parts = [part.mean() for part in np.array_split(record.rotation @ up, PARTS)]
    scatter = np.var(parts, ddof=1) / PARTS / record.interval**2
    stated = mean_rate_variance(errors, record.duration)
    bound = RATE_TOLERANCE * earth.RATE + BOUND_SIGMA * np.sqrt(stated + scatter)
    measured, expected = float(mean @ up), earth.RATE * np.sin(latitude)
    if abs(measured - expected) > bound:
        shown = np.rad2deg(np.arcsin(np.clip(measured / earth.RATE, -1, 1)))
        reason = ": latitude, or gyros?"
        if measured * expected < 0:
            reason = ": latitude's sign, or gyros reversed?"
        raise HrgError(
            f"gyros show latitude {shown:.2f} deg: expected the stated "
            f"{np.rad2deg(latitude):.2f} deg; rate about the vertical {measured:.3g} rad/s: "
            f"expected {expected:.3g} rad/s within {bound:.2g} rad/s"
            f"{reason}"
        )
