"""Coarse alignment: attitude from the rotation of gravity in inertial space; the vehicle may sway.

The gyros refer the specific force to the first body axes, fixed in inertial space. It is integrated
over spans, in which a swaying vehicle contributes only the change of a bounded velocity. The
remaining part is gravity, which Earth's rotation turns about the pole (Silson 2011; Wahba 1965).
docs/methods/alignment.md, Eqs. 5 and 6.
"""

from dataclasses import dataclass

import numpy as np
from scipy.spatial.transform import Rotation

from ins_eval.alignment.bias_instability import integral_covariance
from ins_eval.alignment.inertial import inertial_kernel
from ins_eval.alignment.result import Alignment, AlignmentError
from ins_eval.common import earth
from ins_eval.common.arrays import Array
from ins_eval.common.rotation import skew
from ins_eval.common.sensor_errors import SensorErrors
from ins_eval.navigation.coefficients import derive_coefficients
from pyhrg.records.imu.increments import Increments

SPANS = 20
"""Number of spans of a record. Chosen."""
SAMPLES = 2
"""Increments a navigation step. Chosen."""


@dataclass(frozen=True)
class InertialFrameFit:
    """The rotation between two frames that are fixed in inertial space.

    mat_nb: (3, 3) attitude at the end of the record; mat_ib: (3, 3) from the first body axes to the
    first navigation axes; gravity: (k, 3) mean directions of the upward reaction to gravity in the
    first navigation axes; misfit: (k, 3) of the measured directions, rad; span: duration, s.
    """

    mat_nb: Array
    mat_ib: Array
    gravity: Array
    misfit: Array
    span: float


def align_in_inertial_frame(
    record: Increments,
    position: Array,
    errors: SensorErrors,
    sway: float | None = None,
    spans: int = SPANS,
) -> Alignment:
    """Find the attitude at the end of a record of a vehicle that stands or sways.

    Args:
        record: intervals at its beginning may be left out, so that the spans are equal.
        position: (3,) latitude, longitude, rad, and height, m.
        errors: of the sensors.
        sway: standard deviation of the vehicle's velocity at the ends of the spans, m/s; None
            estimates it from the misfit, which includes the sensors' noise.
        spans: number of spans, at least 2.

    Raises:
        AlignmentError: too few increments.
    """
    fit = fit_inertial_frame(record, position, spans)
    gravity = float(earth.gravity(position[0], position[2]))
    if sway is None:
        sway = estimate_sway_velocity(fit, gravity)
    covariance = inertial_frame_covariance(fit, float(position[0]), gravity, errors, sway)
    return Alignment("inertial frame", float(record.bounds[-1]), fit.mat_nb, covariance)


def estimate_sway_velocity(fit: InertialFrameFit, gravity: float) -> float:
    """Estimate the standard deviation of the velocity at the spans' ends from the misfit, m/s.

    The degrees of freedom are two a span less the three of the fitted rotation; a difference of two
    velocities has twice the variance.
    """
    freedom = 2 * (2 * len(fit.gravity) - 3)
    return float(np.sqrt(np.sum(fit.misfit**2) / freedom) * gravity * fit.span)


def fit_inertial_frame(record: Increments, position: Array, spans: int = SPANS) -> InertialFrameFit:
    """Solve Wahba's problem for the velocity changes of the spans.

    Raises:
        AlignmentError: too few increments.
    """
    steps = len(record) // (SAMPLES * spans)
    if spans < 2 or steps < 1:
        raise AlignmentError(
            f"{len(record)} increments in {spans} spans: expected at least 2 spans "
            f"of {SAMPLES} increments"
        )
    used = record.between(len(record) - steps * SAMPLES * spans, len(record))
    gained = np.empty((spans, 3))
    quaternion = inertial_kernel.integrate_in_inertial_frame(
        used.rotation, used.velocity, derive_coefficients(SAMPLES), steps, gained
    )
    measured = gained / np.linalg.norm(gained, axis=1, keepdims=True)
    span = steps * SAMPLES * record.interval
    gravity = gravity_in_inertial_frame(float(position[0]), span, spans)
    turned, _ = Rotation.align_vectors(gravity, measured)
    last = Rotation.from_quat(quaternion, scalar_first=True)
    earth_turned = Rotation.from_rotvec(-earth.rotation_rate(float(position[0])) * span * spans)
    return InertialFrameFit(
        mat_nb=(earth_turned * turned * last).as_matrix(),
        mat_ib=turned.as_matrix(),
        gravity=gravity,
        misfit=turned.apply(measured) - gravity,
        span=span,
    )


def gravity_in_inertial_frame(latitude: float, span: float, spans: int) -> Array:
    """Return the directions (spans, 3) of the mean upward reaction in the first navigation axes."""
    middle = span * (np.arange(spans) + 0.5)
    axis = earth.rotation_rate(latitude) / earth.RATE
    up = np.array([0.0, 0.0, -1.0])
    along = (up @ axis) * axis
    across = (up - along) * np.sinc(earth.RATE * span / 2 / np.pi)
    turned = Rotation.from_rotvec(np.outer(middle, earth.rotation_rate(latitude))).apply(
        along + across
    )
    return np.asarray(turned / np.linalg.norm(turned, axis=1, keepdims=True))


def inertial_frame_covariance(
    fit: InertialFrameFit, latitude: float, gravity: float, errors: SensorErrors, sway: float
) -> Array:
    """Return the covariance (3, 3) about north, east, down, rad^2, at the end, to first order.

    The error of direction u_k is theta_k x u_k + df_k/g, with theta the integrated gyro error and
    df the accelerometer error. Their least-squares rotation is the error of the first axes; theta
    at the end adds to it.
    """
    u, span = fit.gravity, fit.span
    duration = span * len(u)
    cross = skew(u)
    solve = np.linalg.solve(np.einsum("kji,kjl->il", cross, cross), np.swapaxes(cross, 1, 2))
    by_theta = np.concatenate([-solve @ cross, np.eye(3)[None]])
    by_force = solve / gravity

    middle = span * (np.arange(len(u)) + 0.5)
    times = np.append(middle, duration)
    walk = np.minimum.outer(times, times)
    walk[np.diag_indices(len(u))] -= span / 6
    theta = errors.angle_random_walk**2 * walk
    theta += errors.gyro_bias**2 * np.outer(times, times)
    theta += integral_covariance(errors.gyro_bias_instability, times)

    bounded = sway**2 + errors.velocity_quantization_step**2 / 12
    neighbour = np.eye(len(u), k=1) + np.eye(len(u), k=-1)
    force = (errors.velocity_random_walk**2 / span) * np.eye(len(u))
    force += bounded / span**2 * (2 * np.eye(len(u)) - neighbour)
    force += errors.accelerometer_bias**2
    ends = span * np.arange(len(u) + 1.0)
    integral = integral_covariance(errors.accelerometer_bias_instability, ends)
    force += np.diff(np.diff(integral, axis=0), axis=1) / span**2

    first = np.einsum("kia,kl,lja->ij", by_theta, theta, by_theta)
    first += np.einsum("kia,kl,lja->ij", by_force, force, by_force)
    turn = Rotation.from_rotvec(-earth.rotation_rate(latitude) * duration).as_matrix()
    return np.asarray(turn @ first @ turn.T)
