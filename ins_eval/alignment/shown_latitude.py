"""The latitude that a standing vehicle's record shows, against the stated one.

Gravity tells the vertical, and the gyros Earth's rate about it: RATE sin(latitude), upward
(Groves 2013, section 5.6.2).
"""

import numpy as np

from ins_eval.alignment.analytic import mean_error_variances
from ins_eval.alignment.result import AlignmentError
from ins_eval.common import earth
from ins_eval.common.increments import Increments
from ins_eval.common.sensor_errors import SensorErrors

NEAR_EARTHS = 0.2
"""Of Earth's rate. A mean rate further off is the vehicle's: it turned, and shows no latitude."""
TOLERANCE = 0.06
"""Of Earth's rate about the vertical: tilt that creeps, scale factor, a place read off a map;
3.4 deg of latitude at the equator, 4.9 deg at 45 deg."""
SIGMAS = 5.0
PARTS = 20
"""Of a record, whose mean rates' scatter is the vehicle's turning and the gyros' noise."""


def check_latitude(record: Increments, latitude: float, errors: SensorErrors) -> None:
    """Refuse a record whose gyros contradict the stated latitude, rad.

    The bound on the rate about the vertical is `TOLERANCE` and 5 sigma of the gyros' stated
    errors and of the mean of `PARTS` parts as they scatter. A vehicle that swings in heading, so
    that they scatter widely, hides a wrong latitude; on the equator nothing shows reversed gyros.

    Raises:
        AlignmentError: says what was found, what was expected, and a likely reason.
    """
    force = record.velocity.sum(axis=0)
    up = force / np.linalg.norm(force)
    mean = record.rotation.sum(axis=0) / record.duration
    if abs(np.linalg.norm(mean) / earth.RATE - 1) > NEAR_EARTHS:
        return
    parts = [part.mean() for part in np.array_split(record.rotation @ up, PARTS)]
    scatter = np.var(parts, ddof=1) / PARTS / record.interval**2
    stated, _ = mean_error_variances(errors, record.duration)
    bound = TOLERANCE * earth.RATE + SIGMAS * np.sqrt(stated + scatter)
    found, expected = float(mean @ up), earth.RATE * np.sin(latitude)
    if abs(found - expected) > bound:
        shown = np.rad2deg(np.arcsin(np.clip(found / earth.RATE, -1, 1)))
        raise AlignmentError(
            f"gyros show latitude {shown:.2f} deg: expected the stated "
            f"{np.rad2deg(latitude):.2f} deg; rate about the vertical {found:.3g} rad/s: "
            f"expected {expected:.3g} rad/s within {bound:.2g} rad/s{_guess(found, expected)}"
        )


def _guess(found: float, expected: float) -> str:
    reversed_sign = found * expected < 0
    return ": latitude's sign, or gyros reversed?" if reversed_sign else ": latitude, or gyros?"
