"""The states of the linear error model, and the dynamics matrix of the linearized navigation
equations.

Nine of the ten states are the errors of `TrackError`: computed less true, position in metres at the
true place, attitude as the rotation vector that turns the true axes into the computed ones. The
tenth is the integral of the baro-damped height loop. Sensor errors are inputs (`effects`).
"""

import numpy as np

from ins_eval.common import earth
from ins_eval.common.rotation import skew
from ins_eval.error_model.motion import Motion, step_mean
from ins_eval.navigation.height import BaroDamped, Clamped, Height
from pyhrg.common.arrays import Array, Mask

NAMES = (
    "position north",
    "position east",
    "position down",
    "velocity north",
    "velocity east",
    "velocity down",
    "attitude north",
    "attitude east",
    "attitude down",
    "height integral",
)
POSITION, VELOCITY, ATTITUDE = slice(0, 3), slice(3, 6), slice(6, 9)
HEIGHT_INTEGRAL = 9
COUNT = len(NAMES)


NORTH, EAST, DOWN = 0, 1, 2


def dynamics(motion: Motion, height: Height) -> Array:
    """Return F (n, 10, 10) of each step, dx/dt = F x + G u, at the step's mean velocity and force.

    docs/methods/error_model.md, Eqs. 2 to 5: the phi-angle error equations with Earth's and
    transport rate, their errors, Coriolis, gravity by latitude and height, and the radii of WGS-84
    by latitude (Groves 2013, section 14.2.4, with the attitude error's sign reversed).

    A clamped height has no velocity error, and its position error is that of the reference,
    constant. A damped height follows `height.BaroDamped` with a reference without error.
    """
    middle = slice(2, None, 4)
    latitude, altitude = motion.latitude[middle], motion.height[middle]
    velocity = step_mean(motion.velocity)
    force_n = step_mean(np.einsum("nij,nj->ni", motion.mat_nb, motion.force))
    return _matrix(latitude, altitude, velocity, force_n, height)


def sensor_inputs(motion: Motion, height: Height) -> Array:
    """Return G (m, 10, 6) at the nodes: rate of change of the states per error of each gyro, rad/s,
    and of each accelerometer, m/s^2, in body axes."""
    g = np.zeros((len(motion.mat_nb), COUNT, 6))
    g[:, ATTITUDE, :3] = motion.mat_nb
    g[:, VELOCITY, 3:] = motion.mat_nb
    g[:, ~free_states(height)] = 0.0
    return g


def free_states(height: Height) -> Mask:
    """Return (10,) True for each state but the vertical velocity of a clamped height, which is
    always without error."""
    free = np.ones(COUNT, dtype=bool)
    free[VELOCITY.start + DOWN] = not isinstance(height, Clamped)
    return free


def _matrix(
    latitude: Array, altitude: Array, velocity: Array, force_n: Array, height: Height
) -> Array:
    omega_ie = earth.rotation_rate(latitude)
    omega_en, by_position, by_velocity = _transport(latitude, altitude, velocity)
    radius_n = earth.meridian_radius(latitude) + altitude
    earth_by_position = np.zeros((len(latitude), 3, 3))
    earth_by_position[:, NORTH, NORTH] = -earth.RATE * np.sin(latitude) / radius_n
    earth_by_position[:, DOWN, NORTH] = -earth.RATE * np.cos(latitude) / radius_n

    f = np.zeros((len(latitude), COUNT, COUNT))
    f[:, POSITION, POSITION] = _position_by_position(latitude, altitude, velocity)
    f[:, POSITION, VELOCITY] = np.eye(3)
    cross = skew(velocity)
    f[:, VELOCITY, POSITION] = cross @ (2 * earth_by_position + by_position)
    f[:, VELOCITY, POSITION] += _gravity_by_position(latitude, altitude)
    f[:, VELOCITY, VELOCITY] = cross @ by_velocity - skew(2 * omega_ie + omega_en)
    f[:, VELOCITY, ATTITUDE] = -skew(force_n)
    f[:, ATTITUDE, POSITION] = -earth_by_position - by_position
    f[:, ATTITUDE, VELOCITY] = -by_velocity
    f[:, ATTITUDE, ATTITUDE] = -skew(omega_ie + omega_en)
    return _apply_height_aiding(f, height)


def _transport(latitude: Array, altitude: Array, velocity: Array) -> tuple[Array, Array, Array]:
    """Return `omega_en` (n, 3), rad/s, and its derivatives (n, 3, 3) by position, m, and
    velocity."""
    meridian, transverse = earth.meridian_radius(latitude), earth.transverse_radius(latitude)
    radius_n, radius_e = meridian + altitude, transverse + altitude
    sin, cos = np.sin(latitude), np.cos(latitude)
    tan = sin / cos
    bulge = earth.ECCENTRICITY_SQUARED * sin * cos / (1 - earth.ECCENTRICITY_SQUARED * sin**2)
    rate_e, rate_n = velocity[:, EAST] / radius_e, velocity[:, NORTH] / radius_n
    omega_en = _stack(rate_e, -rate_n, -rate_e * tan)

    by_velocity = np.zeros((len(latitude), 3, 3))
    by_velocity[:, NORTH, EAST] = 1 / radius_e
    by_velocity[:, EAST, NORTH] = -1 / radius_n
    by_velocity[:, DOWN, EAST] = -tan / radius_e

    by_position = np.zeros((len(latitude), 3, 3))
    slope_e = -rate_e * transverse * bulge / radius_e / radius_n
    by_position[:, NORTH, NORTH] = slope_e
    by_position[:, EAST, NORTH] = rate_n * 3 * meridian * bulge / radius_n**2
    by_position[:, DOWN, NORTH] = -slope_e * tan - rate_e / cos**2 / radius_n
    by_position[:, :, DOWN] = _stack(
        rate_e / radius_e, -rate_n / radius_n, -rate_e * tan / radius_e
    )
    return omega_en, by_position, by_velocity


def _position_by_position(latitude: Array, altitude: Array, velocity: Array) -> Array:
    """Return (n, 3, 3) the rate of position errors by position errors, both in metres at the true
    place, which moves over a curved Earth."""
    radius_n = earth.meridian_radius(latitude) + altitude
    radius_e = earth.transverse_radius(latitude) + altitude
    tan = np.tan(latitude)
    north, east, down = velocity.T
    f = np.zeros((len(latitude), 3, 3))
    f[:, NORTH, NORTH] = -down / radius_n
    f[:, NORTH, DOWN] = north / radius_n
    f[:, EAST, NORTH] = east * tan / radius_e
    f[:, EAST, EAST] = -(north * tan + down) / radius_e
    f[:, EAST, DOWN] = east / radius_e
    return f


def _gravity_by_position(latitude: Array, altitude: Array) -> Array:
    """Return (n, 3, 3) gravity by position: down by central differences that are exact to 1e-9."""
    radius_n = earth.meridian_radius(latitude) + altitude
    angle, rise = 1e-3, 1e3
    to_north = earth.gravity(latitude + angle, altitude) - earth.gravity(latitude - angle, altitude)
    to_up = earth.gravity(latitude, altitude + rise) - earth.gravity(latitude, altitude - rise)
    f = np.zeros((len(latitude), 3, 3))
    f[:, DOWN, NORTH] = to_north / (2 * angle) / radius_n
    f[:, DOWN, DOWN] = -to_up / (2 * rise)
    f[:, NORTH, NORTH] = -2 * earth.PLUMB_LINE * altitude * np.cos(2 * latitude) / radius_n
    f[:, NORTH, DOWN] = earth.PLUMB_LINE * np.sin(2 * latitude)
    return f


def _apply_height_aiding(f: Array, height: Height) -> Array:
    position, velocity = POSITION.start + DOWN, VELOCITY.start + DOWN
    if isinstance(height, Clamped):
        f[:, [position, velocity]] = 0.0
        f[:, :, velocity] = 0.0
    if isinstance(height, BaroDamped):
        to_height, to_velocity, to_velocity_by_integral = height.gains
        f[:, position, position] -= to_height
        f[:, velocity, position] -= to_velocity
        f[:, velocity, HEIGHT_INTEGRAL] = to_velocity_by_integral
        f[:, HEIGHT_INTEGRAL, position] = -1.0
    return f


def _stack(north: Array, east: Array | float, down: Array) -> Array:
    return np.stack(np.broadcast_arrays(north, east, down), axis=-1)
