"""Alignment of a standing vehicle: checks of the record, then coarse and fine alignment."""

import numpy as np

from ins_eval.alignment.inertial_frame import (
    InertialFrameFit,
    estimate_sway_velocity,
    fit_inertial_frame,
)
from ins_eval.alignment.kalman.fine import align_by_kalman_filter
from ins_eval.alignment.record_checks import check_explained, check_latitude, check_samples
from ins_eval.alignment.result import Alignment
from ins_eval.common import earth
from ins_eval.common.sensor_errors import SensorErrors
from pyhrg.common.arrays import Array
from pyhrg.common.errors import HrgError
from pyhrg.records.imu.log import Increments

MIN_DURATION = 30.0
"""Shortest record that is aligned on, s. Chosen: gyrocompassing takes minutes."""
MAX_LATITUDE = np.deg2rad(89.0)
"""Largest latitude, rad. Chosen: at a pole there is no north."""
FORCE_TOLERANCE = 0.02
"""Largest relative difference of the mean specific force from gravity. Chosen."""
MAX_SWAY_VELOCITY = 1.0
"""Largest standard deviation of the velocity of a standing vehicle, m/s. Chosen."""


def align(
    record: Increments,
    position: Array,
    errors: SensorErrors,
    steady: bool = True,
) -> Alignment:
    """Find the attitude at the end of a record of a vehicle that stands or sways.

    People may move in the vehicle. The rotation of gravity in the inertial frame gives the coarse
    attitude, a Kalman filter the fine one (docs/methods/alignment.md).

    Two cases are not detected. A vehicle in steady straight motion feels the same forces as one at
    rest; its heading is wrong by its speed over that of Earth's surface. A wrong latitude is hidden
    by a vehicle that swings in heading (`shown_latitude`).

    Args:
        record: all of it is used.
        position: (3,) latitude, longitude, rad, and height, m.
        errors: stated errors of the sensors, from the IMU's file; the covariance rests on them.
        steady: whether to use that tilts stay constant where the record shows it; False for a
            vehicle whose tilt may creep by less than its accelerometers show.

    Raises:
        HrgError: a record that can't be aligned on; the message says why.
    """
    _check_record(record, position)
    check_samples(record)
    check_latitude(record, float(position[0]), errors)
    fit = fit_inertial_frame(record, position)
    _check_standing(fit, float(earth.gravity(position[0], position[2])))
    alignment = align_by_kalman_filter(record, position, errors, fit.mat_ib, steady=steady)
    check_explained(alignment)
    return alignment


def _check_record(record: Increments, position: Array) -> None:
    bad = ~np.isfinite(np.hstack([record.rotation, record.velocity])).all(axis=1)
    if bad.any():
        row = int(np.argmax(bad))
        values = [*record.rotation[row], *record.velocity[row]]
        raise HrgError(f"increment {row}: {values}: expected finite numbers")
    if record.duration < MIN_DURATION:
        raise HrgError(
            f"record of {record.duration:g} s: expected at least {MIN_DURATION:g} s; "
            "heading comes from Earth's rotation and takes minutes"
        )
    if not (np.isfinite(position).all() and abs(position[0]) <= MAX_LATITUDE):
        raise HrgError(
            f"latitude {np.rad2deg(position[0]):.4g} deg, height {position[2]:g} m: expected "
            f"finite numbers, latitude within {np.rad2deg(MAX_LATITUDE):g} deg of the "
            "equator: at a pole there is no north to find"
        )
    force = np.linalg.norm(record.velocity.sum(axis=0)) / record.duration
    gravity = earth.gravity(position[0], position[2])
    if abs(force / gravity - 1) > FORCE_TOLERANCE:
        hint = (
            ": is the velocity in g s instead of m/s?" if abs(force - 1) < FORCE_TOLERANCE else ""
        )
        raise HrgError(
            f"mean specific force {force:.4g} m/s^2: expected gravity, {gravity:.4g} m/s^2, "
            f"within {100 * FORCE_TOLERANCE:g} %{hint}"
        )


def _check_standing(fit: InertialFrameFit, gravity: float) -> None:
    speed = estimate_sway_velocity(fit, gravity)
    if speed > MAX_SWAY_VELOCITY:
        raise HrgError(
            f"velocity changes by {speed:.3g} m/s (one sigma) between spans of {fit.span:g} s: "
            f"expected at most {MAX_SWAY_VELOCITY:g} m/s of a standing vehicle with rotation in rad"
        )
