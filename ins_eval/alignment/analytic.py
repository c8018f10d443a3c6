"""Initial attitude at rest: level from gravity, heading by gyrocompassing."""

import numpy as np
from numpy.typing import NDArray

from ins_eval import earth
from ins_eval.increments import Increments
from ins_eval.rotation import mat_from_euler


class AlignmentError(Exception):
    """The record can't be aligned on."""


def static_alignment(record: Increments, latitude: float) -> NDArray[np.float64]:
    """`mat_nb` (3, 3) of a vehicle at rest (Groves 2013, section 5.6.2).

    Pitch and roll from the mean specific force; yaw from the level components of the mean rate.
    An east gyro's bias e turns the heading by e/(RATE cos latitude); a level accelerometer's bias
    b tilts by b/g. Both then cancel in the navigator until the vehicle turns.

    Raises:
        AlignmentError: the mean rate is not Earth's: the vehicle was moving.
    """
    duration = record.interval * len(record.rotation)
    force = record.velocity.sum(axis=0) / duration
    rate = record.rotation.sum(axis=0) / duration
    if abs(np.linalg.norm(rate) / earth.RATE - 1) > 0.5 or abs(np.cos(latitude)) < 0.01:
        raise AlignmentError(
            f"mean rate {np.linalg.norm(rate):.2e} rad/s "
            f"at latitude {np.rad2deg(latitude):.1f} deg; "
            f"expected about Earth's {earth.RATE:.2e} rad/s, away from the poles"
        )
    roll = np.arctan2(-force[1], -force[2])
    pitch = np.arctan2(force[0], np.hypot(force[1], force[2]))
    level = mat_from_euler(roll, pitch, np.zeros_like(roll)) @ rate
    return mat_from_euler(roll, pitch, np.arctan2(-level[1], level[0]))
