"""Strapdown navigation from increments; reads no file and draws no random number.

Two-sample coning and sculling (Savage 1998); Coriolis, transport and gravity at the middle of the
step; WGS-84.
The height is clamped to a reference, as a barometer would hold it.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ins_eval import earth
from ins_eval.increments import Increments

Array = NDArray[np.float64]

jit = earth.jit


@dataclass(frozen=True)
class State:
    """Where the navigator believes to be: rad, m; m/s over ground, north, east, down; attitude."""

    latitude: float
    longitude: float
    velocity: Array
    mat_nb: Array


def navigate(start: State, increments: Increments, height: Array, keep_every: int) -> Array:
    """Dead reckoning with the height clamped.

    Args:
        start: initial state.
        increments: of the IMU, an even number of intervals.
        height: (n/2 + 1,) reference height at the start and after each pair of intervals, m.
        keep_every: number of intervals (even) between rows of the result.

    Returns:
        (m, 5) latitude, longitude (rad), velocity north and east (m/s), and heading (rad), after
        every `keep_every` intervals.

    Raises:
        ValueError: an odd number of intervals, or heights that do not match.
    """
    count = len(increments.rotation)
    if count % 2 or keep_every % 2:
        raise ValueError(f"{count} intervals, every {keep_every} kept: both must be even")
    if len(height) != count // 2 + 1:
        raise ValueError(f"{len(height)} heights given, {count // 2 + 1} expected")
    result = np.empty((count // keep_every, 5))
    _navigate(
        start.latitude,
        start.longitude,
        start.velocity.copy(),
        _quaternion(start.mat_nb),
        increments.interval,
        increments.rotation,
        increments.velocity,
        height,
        keep_every // 2,
        result,
    )
    return result


@jit
def _cross(a, b):
    return (
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    )


@jit
def _from_rotation_vector(v):
    """Quaternion of a rotation vector; the next terms are below 1e-16 up to 0.05 rad."""
    s = v[0] * v[0] + v[1] * v[1] + v[2] * v[2]
    scalar = 1 - s / 8 + s * s / 384 - s * s * s / 46080
    factor = 0.5 - s / 48 + s * s / 3840 - s * s * s / 645120
    return (scalar, factor * v[0], factor * v[1], factor * v[2])


@jit
def _multiply(p, q):
    return (
        p[0] * q[0] - p[1] * q[1] - p[2] * q[2] - p[3] * q[3],
        p[0] * q[1] + p[1] * q[0] + p[2] * q[3] - p[3] * q[2],
        p[0] * q[2] - p[1] * q[3] + p[2] * q[0] + p[3] * q[1],
        p[0] * q[3] + p[1] * q[2] - p[2] * q[1] + p[3] * q[0],
    )


@jit
def _rotate(q, v):
    u = (q[1], q[2], q[3])
    t = _cross(u, v)
    t = (2 * t[0], 2 * t[1], 2 * t[2])
    w = _cross(u, t)
    return (v[0] + q[0] * t[0] + w[0], v[1] + q[0] * t[1] + w[1], v[2] + q[0] * t[2] + w[2])


@jit
def _coning(r1, r2):
    """Rotation vector of two intervals: r1 + r2 + 2/3 r1 x r2."""
    c = _cross(r1, r2)
    return (
        r1[0] + r2[0] + 2 / 3 * c[0],
        r1[1] + r2[1] + 2 / 3 * c[1],
        r1[2] + r2[2] + 2 / 3 * c[2],
    )


@jit
def _sculling(r1, r2, v1, v2):
    """Velocity change of two intervals in the body axes of their start."""
    r = (r1[0] + r2[0], r1[1] + r2[1], r1[2] + r2[2])
    v = (v1[0] + v2[0], v1[1] + v2[1], v1[2] + v2[2])
    turning = _cross(r, v)
    again = _cross(r, turning)
    a = _cross(r1, v2)
    b = _cross(v1, r2)
    return (
        v[0] + 0.5 * turning[0] + again[0] / 6 + 2 / 3 * (a[0] + b[0]),
        v[1] + 0.5 * turning[1] + again[1] / 6 + 2 / 3 * (a[1] + b[1]),
        v[2] + 0.5 * turning[2] + again[2] / 6 + 2 / 3 * (a[2] + b[2]),
    )


@jit
def _navigation_rates(latitude, height, north, east):
    """Earth rate and transport rate in navigation axes, rad/s."""
    sin, cos = np.sin(latitude), np.cos(latitude)
    rate_e = east / (earth.transverse_radius(latitude) + height)
    rate_n = north / (earth.meridian_radius(latitude) + height)
    omega_ie = (earth.RATE * cos, 0.0, -earth.RATE * sin)
    omega_en = (rate_e, -rate_n, -rate_e * sin / cos)
    return omega_ie, omega_en


@jit
def _navigate(
    latitude, longitude, velocity, quaternion, interval, rotation, force, height, keep, result
):
    step = 2 * interval
    q = (quaternion[0], quaternion[1], quaternion[2], quaternion[3])
    north, east = velocity[0], velocity[1]
    change_n, change_e = 0.0, 0.0
    for k in range(len(rotation) // 2):
        r1 = (rotation[2 * k, 0], rotation[2 * k, 1], rotation[2 * k, 2])
        r2 = (rotation[2 * k + 1, 0], rotation[2 * k + 1, 1], rotation[2 * k + 1, 2])
        v1 = (force[2 * k, 0], force[2 * k, 1], force[2 * k, 2])
        v2 = (force[2 * k + 1, 0], force[2 * k + 1, 1], force[2 * k + 1, 2])

        # State at the middle of the step, extrapolated with the last step's change.
        middle_h = 0.5 * (height[k] + height[k + 1])
        middle_n, middle_e = north + 0.5 * change_n, east + 0.5 * change_e
        down = -(height[k + 1] - height[k]) / step
        radius_n = earth.meridian_radius(latitude) + middle_h
        middle_latitude = latitude + 0.25 * step * (north + middle_n) / radius_n
        omega_ie, omega_en = _navigation_rates(middle_latitude, middle_h, middle_n, middle_e)
        turn = (
            step * (omega_ie[0] + omega_en[0]),
            step * (omega_ie[1] + omega_en[1]),
            step * (omega_ie[2] + omega_en[2]),
        )
        twice = (
            2 * omega_ie[0] + omega_en[0],
            2 * omega_ie[1] + omega_en[1],
            2 * omega_ie[2] + omega_en[2],
        )
        coriolis = _cross(twice, (middle_n, middle_e, down))

        # Velocity; half the turn of the navigation axes lies within the step.
        specific = _rotate(q, _sculling(r1, r2, v1, v2))
        lag = _cross(turn, specific)
        change_n = specific[0] - 0.5 * lag[0] - step * coriolis[0]
        change_e = specific[1] - 0.5 * lag[1] - step * coriolis[1]

        # Position, with the mean velocity of the step.
        mean_n, mean_e = north + 0.5 * change_n, east + 0.5 * change_e
        middle_latitude = latitude + 0.5 * step * mean_n / radius_n
        radius_n = earth.meridian_radius(middle_latitude) + middle_h
        radius_e = earth.transverse_radius(middle_latitude) + middle_h
        latitude += step * mean_n / radius_n
        longitude += step * mean_e / (radius_e * np.cos(middle_latitude))
        north += change_n
        east += change_e

        # Attitude: navigation axes turn by `turn`, body axes by the coning-corrected rotation.
        q = _multiply(q, _from_rotation_vector(_coning(r1, r2)))
        q = _multiply(_from_rotation_vector((-turn[0], -turn[1], -turn[2])), q)
        norm = 1.5 - 0.5 * (q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3])
        q = (q[0] * norm, q[1] * norm, q[2] * norm, q[3] * norm)

        if (k + 1) % keep == 0:
            row = (k + 1) // keep - 1
            result[row, 0] = latitude
            result[row, 1] = longitude
            result[row, 2] = north
            result[row, 3] = east
            result[row, 4] = np.arctan2(
                2 * (q[0] * q[3] + q[1] * q[2]), 1 - 2 * (q[2] * q[2] + q[3] * q[3])
            )


def _quaternion(mat_nb: Array) -> Array:
    """Quaternion (scalar first) of a rotation matrix, by its largest component."""
    m = mat_nb
    squares = np.array(
        [
            1 + m[0, 0] + m[1, 1] + m[2, 2],
            1 + m[0, 0] - m[1, 1] - m[2, 2],
            1 - m[0, 0] + m[1, 1] - m[2, 2],
            1 - m[0, 0] - m[1, 1] + m[2, 2],
        ]
    )
    table = np.array(
        [
            [squares[0], m[2, 1] - m[1, 2], m[0, 2] - m[2, 0], m[1, 0] - m[0, 1]],
            [m[2, 1] - m[1, 2], squares[1], m[0, 1] + m[1, 0], m[0, 2] + m[2, 0]],
            [m[0, 2] - m[2, 0], m[0, 1] + m[1, 0], squares[2], m[1, 2] + m[2, 1]],
            [m[1, 0] - m[0, 1], m[0, 2] + m[2, 0], m[1, 2] + m[2, 1], squares[3]],
        ]
    )
    largest = int(np.argmax(squares))
    q = table[largest]
    return np.asarray(q / np.linalg.norm(q))
