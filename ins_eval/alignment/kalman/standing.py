"""Linear error model of a navigator that stands: what alignment's filter propagates.

States: attitude (3) about north, east, down, rad; velocity (2) and displacement (2) north, east,
m/s and m; gyro biases (3), rad/s, and accelerometer biases (3), m/s^2, body axes. Height is held,
so that an uncertain gravity is not taken for a tilt.
"""

import numpy as np
from filterpy.common import van_loan_discretization
from numpy.typing import NDArray

from ins_eval.common import earth
from ins_eval.common.sensor_errors import SensorErrors

Array = NDArray[np.float64]

STATES = 13
ATTITUDE, VELOCITY, DISPLACEMENT = slice(0, 3), slice(3, 5), slice(5, 7)
GYRO, ACCELEROMETER = slice(7, 10), slice(10, 13)

TILT_PRIOR, HEADING_PRIOR = 0.1, 1.0
"""Known before, rad: next to nothing."""
VELOCITY_PRIOR, DISPLACEMENT_PRIOR = 1.0, 10.0
"""Likewise, m/s and m."""


def dynamics(latitude: float, height: float) -> Array:
    """(13, 13) time derivative of the states by the states (Groves 2013, section 14.2.4), with
    biases about and along north, east, down.

    Attitude as in `TrackError`, so its signs are those of a computed frame that
    leads the true one.
    """
    north = earth.meridian_radius(latitude) + height
    east = earth.transverse_radius(latitude) + height
    gravity = earth.gravity(latitude, height)
    level, up = earth.RATE * np.cos(latitude), earth.RATE * np.sin(latitude)
    f = np.zeros((STATES, STATES))
    f[ATTITUDE, ATTITUDE] = [[0, -up, 0], [up, 0, level], [0, -level, 0]]
    f[ATTITUDE, VELOCITY] = [[0, -1 / east], [1 / north, 0], [0, np.tan(latitude) / east]]
    f[ATTITUDE, DISPLACEMENT] = [[up / north, 0], [0, 0], [level / north, 0]]
    f[ATTITUDE, GYRO] = np.eye(3)
    f[VELOCITY, ATTITUDE] = [[0, -gravity, 0], [gravity, 0, 0]]
    f[VELOCITY, VELOCITY] = [[0, -2 * up], [2 * up, 0]]
    f[VELOCITY, ACCELEROMETER] = np.eye(3)[:2]
    f[DISPLACEMENT, VELOCITY] = np.eye(2)
    return f


def noise(errors: SensorErrors, interval: float, gravity: float) -> Array:
    """(13, 7) root of the densities that drive attitude, velocity and displacement.

    The counts' remainders are white in angle and in velocity: they drive velocity through gravity
    and displacement.

    Args:
        errors: of the sensors.
        interval: of the increments, s.
        gravity: m/s^2.
    """
    remainder = interval / 12
    force = np.hypot(
        errors.velocity_random_walk, gravity * errors.angle_quantum * np.sqrt(remainder)
    )
    roots = [
        *[errors.angle_random_walk] * 3,
        *[force] * 2,
        *[errors.velocity_quantum * np.sqrt(remainder)] * 2,
    ]
    g = np.zeros((STATES, len(roots)))
    g[: len(roots)] = np.diag(roots)
    return g


def discretised(f: Array, g: Array, step: float) -> tuple[Array, Array]:
    """Transition (n, n) and covariance (n, n) of a step, s, exactly (Van Loan 1978)."""
    transition, covariance = van_loan_discretization(f, g, step)
    return np.asarray(transition), np.asarray(covariance)


def in_body_axes(transition: Array, mat_nb: Array) -> Array:
    """Transitions (m, n, n) with biases in body axes, of steps at attitudes (m, 3, 3)."""
    steps = np.tile(transition, (len(mat_nb), 1, 1))
    others = np.delete(np.arange(len(transition)), np.r_[GYRO, ACCELEROMETER])
    for bias in (GYRO, ACCELEROMETER):
        steps[:, others, bias] = transition[others, bias] @ mat_nb
    return steps


def prior(errors: SensorErrors) -> Array:
    """(13, 13) covariance before any measurement: the sensors' stated biases, little else."""
    sigma = np.empty(STATES)
    sigma[ATTITUDE] = TILT_PRIOR, TILT_PRIOR, HEADING_PRIOR
    sigma[VELOCITY], sigma[DISPLACEMENT] = VELOCITY_PRIOR, DISPLACEMENT_PRIOR
    sigma[GYRO], sigma[ACCELEROMETER] = errors.gyro_bias, errors.accelerometer_bias
    return np.diag(sigma**2)
