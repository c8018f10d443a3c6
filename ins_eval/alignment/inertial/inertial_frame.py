"""Initial attitude from gravity's turning in inertial space; the vehicle may sway.

The gyros freeze the first body axes, where the vehicle's rotation no longer counts; integrating
the specific force over spans leaves of its motion only the change of a bounded velocity. What
remains is gravity, which Earth turns about the pole (Silson 2011; Wahba 1965).
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.spatial.transform import Rotation

from ins_eval.alignment.bias_instability import integral_covariance
from ins_eval.alignment.inertial import inertial_kernel
from ins_eval.alignment.result import Alignment, AlignmentError
from ins_eval.common import earth
from ins_eval.common.increments import Increments
from ins_eval.common.sensor_errors import SensorErrors
from ins_eval.navigation.coefficients import weights

Array = NDArray[np.float64]

SPANS = 20
"""Spans that a record is cut into."""
SAMPLES = 2
"""Increments a step."""


@dataclass(frozen=True)
class Fit:
    """A rotation between two frames at rest in inertial space.

    mat_nb: (3, 3) at the end of the record; mat_ib: (3, 3) first body axes to first navigation
    axes; gravity: (k, 3) mean directions of upward gravity in the first navigation axes;
    misfit: (k, 3) of the measured directions, rad; span: s.
    """

    mat_nb: Array
    mat_ib: Array
    gravity: Array
    misfit: Array
    span: float


def inertial_frame_alignment(
    record: Increments,
    position: Array,
    errors: SensorErrors,
    sway: float | None = None,
    spans: int = SPANS,
) -> Alignment:
    """Attitude at the end of a record of a vehicle that stands or sways.

    Args:
        record: so many intervals at its beginning are left out that the spans are equal.
        position: (3,) latitude, longitude (rad), height (m).
        errors: of the sensors.
        sway: standard deviation of the vehicle's velocity at the ends of the spans, m/s; None
            takes it from the misfit, where it contains the sensors' own noise.
        spans: at least 2.

    Raises:
        AlignmentError: too few increments.
    """
    fit = inertial_frame_fit(record, position, spans)
    gravity = float(earth.gravity(position[0], position[2]))
    if sway is None:
        sway = swaying_speed(fit, gravity)
    covariance = inertial_frame_covariance(fit, float(position[0]), gravity, errors, sway)
    return Alignment("inertial frame", float(record.bounds[-1]), fit.mat_nb, covariance)


def swaying_speed(fit: Fit, gravity: float) -> float:
    """Standard deviation of the velocity at the spans' ends that the misfit shows, m/s.

    Two components a span, less the three of the fitted rotation; a difference has twice the
    variance.
    """
    freedom = 2 * (2 * len(fit.gravity) - 3)
    return float(np.sqrt(np.sum(fit.misfit**2) / freedom) * gravity * fit.span)


def inertial_frame_fit(record: Increments, position: Array, spans: int = SPANS) -> Fit:
    """Wahba's problem over the spans' velocity changes.

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
    quaternion = inertial_kernel.integrate(
        used.rotation, used.velocity, weights(SAMPLES), steps, gained
    )
    measured = gained / np.linalg.norm(gained, axis=1, keepdims=True)
    span = steps * SAMPLES * record.interval
    gravity = gravity_in_inertial_frame(float(position[0]), span, spans)
    turned, _ = Rotation.align_vectors(gravity, measured)
    last = Rotation.from_quat(quaternion, scalar_first=True)
    earth_turned = Rotation.from_rotvec(-earth_rate(float(position[0])) * span * spans)
    return Fit(
        mat_nb=(earth_turned * turned * last).as_matrix(),
        mat_ib=turned.as_matrix(),
        gravity=gravity,
        misfit=turned.apply(measured) - gravity,
        span=span,
    )


def earth_rate(latitude: float) -> Array:
    """`omega_ie_n` (3,), rad/s."""
    return earth.RATE * np.array([np.cos(latitude), 0.0, -np.sin(latitude)])


def gravity_in_inertial_frame(latitude: float, span: float, spans: int) -> Array:
    """(spans, 3) directions of the mean upward reaction in the first navigation axes."""
    middle = span * (np.arange(spans) + 0.5)
    axis = earth_rate(latitude) / earth.RATE
    up = np.array([0.0, 0.0, -1.0])
    along = (up @ axis) * axis
    across = (up - along) * np.sinc(earth.RATE * span / 2 / np.pi)
    turned = Rotation.from_rotvec(np.outer(middle, earth_rate(latitude))).apply(along + across)
    return np.asarray(turned / np.linalg.norm(turned, axis=1, keepdims=True))


def inertial_frame_covariance(
    fit: Fit, latitude: float, gravity: float, errors: SensorErrors, sway: float
) -> Array:
    """(3, 3) about north, east, down, rad^2, at the end, to first order.

    The directions' errors are theta_k x u_k + df_k/g: theta the gyros' integrated error, df the
    accelerometers'. Least squares over them turns the first axes; theta at the end adds to it.
    """
    u, span = fit.gravity, fit.span
    duration = span * len(u)
    cross = np.array([_skew(x) for x in u])
    solve = np.linalg.solve(np.einsum("kji,kjl->il", cross, cross), np.swapaxes(cross, 1, 2))
    by_theta = np.concatenate([-solve @ cross, np.eye(3)[None]])
    by_force = solve / gravity

    middle = span * (np.arange(len(u)) + 0.5)
    times = np.append(middle, duration)
    walked = np.minimum.outer(times, times)
    walked[np.diag_indices(len(u))] -= span / 6
    theta = errors.angle_random_walk**2 * walked
    theta += errors.gyro_bias**2 * np.outer(times, times)
    theta += integral_covariance(errors.gyro_bias_instability, times)

    bounded = sway**2 + errors.velocity_quantum**2 / 12
    neighbour = np.eye(len(u), k=1) + np.eye(len(u), k=-1)
    force = (errors.velocity_random_walk**2 / span) * np.eye(len(u))
    force += bounded / span**2 * (2 * np.eye(len(u)) - neighbour)
    force += errors.accelerometer_bias**2
    ends = span * np.arange(len(u) + 1.0)
    wandered = integral_covariance(errors.accelerometer_bias_instability, ends)
    force += np.diff(np.diff(wandered, axis=0), axis=1) / span**2

    first = np.einsum("kia,kl,lja->ij", by_theta, theta, by_theta)
    first += np.einsum("kia,kl,lja->ij", by_force, force, by_force)
    turn = Rotation.from_rotvec(-earth_rate(latitude) * duration).as_matrix()
    return np.asarray(turn @ first @ turn.T)


def _skew(v: Array) -> Array:
    return np.array([[0, -v[2], v[1]], [v[2], 0, -v[0]], [-v[1], v[0], 0]])
