"""Alignment of a standing vehicle's record: coarse, then fine."""

import numpy as np
from numpy.typing import NDArray

from ins_eval.alignment.corruption import check_explained, check_samples
from ins_eval.alignment.inertial.inertial_frame import Fit, inertial_frame_fit, swaying_speed
from ins_eval.alignment.kalman.fine import fine_alignment
from ins_eval.alignment.result import Alignment, AlignmentError
from ins_eval.alignment.shown_latitude import check_latitude
from ins_eval.common import earth
from ins_eval.common.increments import Increments
from ins_eval.common.sensor_errors import SensorErrors

Array = NDArray[np.float64]

SHORTEST = 30.0
"""Record that gyrocompassing is tried on, s."""
HIGHEST_LATITUDE = np.deg2rad(89.0)
FORCE_TOLERANCE = 0.02
"""Of the mean specific force against gravity."""
FASTEST_SWAY = 1.0
"""Standard deviation of the velocity of a vehicle that counts as standing, m/s."""


def align(
    record: Increments,
    position: Array,
    errors: SensorErrors,
    sway: float | None = None,
    steady: bool = True,
) -> Alignment:
    """Attitude at the end of a record of a vehicle that stands, people moving in it, or sways.

    Gravity's turning in the inertial frame gives the coarse attitude, a Kalman filter the fine one.
    A vehicle that moves steadily on a straight line feels the same forces as one that stands: it
    can't be told, and its heading comes out wrong by its speed over that of Earth's surface.
    Nor can a wrong latitude of a vehicle that swings in heading: see `shown_latitude`.

    Args:
        record: all of it is used.
        position: (3,) latitude, longitude (rad), height (m).
        errors: of the sensors; the covariance rests on them.
        sway: standard deviation of the vehicle's level displacement on each axis, m; None takes
            it from the record.
        steady: see `fine.fine_alignment`; False for a vehicle whose tilt may creep by less than
            its accelerometers show.

    Raises:
        AlignmentError: a record that can't be aligned on.
    """
    _check(record, position)
    check_samples(record)
    check_latitude(record, float(position[0]), errors)
    fit = inertial_frame_fit(record, position)
    _check_standing(fit, float(earth.gravity(position[0], position[2])))
    found = fine_alignment(record, position, errors, fit.mat_ib, sway, steady)
    check_explained(found)
    return found


def _check(record: Increments, position: Array) -> None:
    bad = ~np.isfinite(np.hstack([record.rotation, record.velocity])).all(axis=1)
    if bad.any():
        row = int(np.argmax(bad))
        values = [*record.rotation[row], *record.velocity[row]]
        raise AlignmentError(f"increment {row}: {values}: expected finite numbers")
    if record.duration < SHORTEST:
        raise AlignmentError(
            f"record of {record.duration:g} s: expected at least {SHORTEST:g} s; "
            "heading comes from Earth's rotation and takes minutes"
        )
    if not (np.isfinite(position).all() and abs(position[0]) <= HIGHEST_LATITUDE):
        raise AlignmentError(
            f"latitude {np.rad2deg(position[0]):.4g} deg, height {position[2]:g} m: expected "
            f"finite numbers, latitude within {np.rad2deg(HIGHEST_LATITUDE):g} deg of the "
            "equator: at a pole there is no north to find"
        )
    force = np.linalg.norm(record.velocity.sum(axis=0)) / record.duration
    gravity = earth.gravity(position[0], position[2])
    if abs(force / gravity - 1) > FORCE_TOLERANCE:
        hint = ": is the velocity in g s?" if abs(force - 1) < FORCE_TOLERANCE else ""
        raise AlignmentError(
            f"mean specific force {force:.4g} m/s^2: expected gravity, {gravity:.4g} m/s^2, "
            f"within {100 * FORCE_TOLERANCE:g} %{hint}"
        )


def _check_standing(fit: Fit, gravity: float) -> None:
    speed = swaying_speed(fit, gravity)
    if speed > FASTEST_SWAY:
        raise AlignmentError(
            f"velocity changes by {speed:.3g} m/s (one sigma) between spans of {fit.span:g} s: "
            f"expected at most {FASTEST_SWAY:g} m/s of a standing vehicle with rotation in rad"
        )
