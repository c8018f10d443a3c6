"""Linear error model of a navigator at rest, for the alignment filter.

Its 13 states are attitude (3) about north, east, down, rad; velocity (2) and displacement (2) north
and east, m/s and m; gyro biases (3), rad/s, and accelerometer biases (3), m/s^2, in body axes. The
height is clamped, so that an uncertain gravity is not taken for a tilt.
"""

import numpy as np

from ins_eval.common import earth
from ins_eval.common.rotation import skew
from ins_eval.common.sensor_errors import SensorErrors
from pyhrg.common.arrays import Array

STATES = 13
ATTITUDE, VELOCITY, DISPLACEMENT = slice(0, 3), slice(3, 5), slice(5, 7)
GYRO, ACCELEROMETER = slice(7, 10), slice(10, 13)

TILT_PRIOR, HEADING_PRIOR = 0.1, 1.0
"""Prior one-sigma of the attitude, rad. Chosen: wide."""
VELOCITY_PRIOR, DISPLACEMENT_PRIOR = 1.0, 10.0
"""Prior one-sigma of velocity, m/s, and displacement, m. Chosen: wide."""


def dynamics(latitude: float, height: float) -> Array:
    """Return F (13, 13), dx/dt = F x, with biases about and along north, east, down.

    Coefficients are constant (Britting 1971, chapter 8; Groves 2013, section 14.2).
    """
    gravity = earth.gravity(latitude, height)
    omega_ie = earth.rotation_rate(latitude)
    north, _, down = omega_ie
    radius_n = float(earth.meridian_radius(latitude)) + height
    radius_e = float(earth.transverse_radius(latitude)) + height
    f = np.zeros((STATES, STATES))
    f[ATTITUDE, ATTITUDE] = -skew(omega_ie)
    f[0, 4], f[1, 3], f[2, 4] = -1 / radius_e, 1 / radius_n, np.tan(latitude) / radius_e
    f[0, 5], f[2, 5] = -down / radius_n, north / radius_n
    f[3, 1], f[4, 0] = -gravity, gravity
    f[3, 4], f[4, 3] = 2 * down, -2 * down
    f[5, 3] = f[6, 4] = 1.0
    f[ATTITUDE, GYRO] = np.eye(3)
    f[VELOCITY, ACCELEROMETER] = np.eye(3)[:2]
    return f


def noise(errors: SensorErrors, interval: float, gravity: float) -> Array:
    """Return the root (13, 7) of the densities that drive attitude, velocity and displacement.

    Quantization is white noise of angle and velocity. That of the angle drives velocity through
    gravity, that of velocity drives displacement.

    interval: of the increments, s; gravity: m/s^2.
    """
    remainder = interval / 12
    force = np.hypot(
        errors.velocity_random_walk, gravity * errors.angle_quantization_step * np.sqrt(remainder)
    )
    roots = [
        *[errors.angle_random_walk] * 3,
        *[force] * 2,
        *[errors.velocity_quantization_step * np.sqrt(remainder)] * 2,
    ]
    g = np.zeros((STATES, len(roots)))
    g[: len(roots)] = np.diag(roots)
    return g


def put_biases_in_body_axes(transition: Array, mat_nb: Array) -> Array:
    """Return transitions (m, n, n) with biases in body axes, for steps at attitudes (m, 3, 3)."""
    steps = np.tile(transition, (len(mat_nb), 1, 1))
    others = np.delete(np.arange(len(transition)), np.r_[GYRO, ACCELEROMETER])
    for bias in (GYRO, ACCELEROMETER):
        steps[:, others, bias] = transition[others, bias] @ mat_nb
    return steps


def prior(errors: SensorErrors) -> Array:
    """Return the covariance (13, 13) before any measurement: stated biases, and a wide prior."""
    sigma = np.empty(STATES)
    sigma[ATTITUDE] = TILT_PRIOR, TILT_PRIOR, HEADING_PRIOR
    sigma[VELOCITY], sigma[DISPLACEMENT] = VELOCITY_PRIOR, DISPLACEMENT_PRIOR
    sigma[GYRO], sigma[ACCELEROMETER] = errors.gyro_bias, errors.accelerometer_bias
    return np.diag(sigma**2)
