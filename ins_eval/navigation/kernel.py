"""The strapdown equations in navigation axes, compiled; plain numbers in tuples and arrays.

One step takes a few increments. Rate and specific force are polynomials within it (`body_step`);
Earth's and transport rate, Coriolis and gravity are those of the step's mean velocity at its
middle. The mean velocity comes from the step's own increments, not from the step before.
"""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from ins_eval.common import earth
from ins_eval.common.compiled import compiled
from ins_eval.navigation.algebra import (
    Quaternion,
    Vector,
    accumulated,
    accumulated4,
    add,
    cross,
    multiply,
    off_length,
    quaternion_beyond_unity,
    rotate,
    scaled,
    small_quaternion_beyond_unity,
    subtract,
    sum4,
)
from ins_eval.navigation.body_step import body_step
from ins_eval.navigation.coefficients import Weights
from ins_eval.navigation.height import VerticalChannel

Array = NDArray[np.float64]

LIMIT = np.deg2rad(89.5)
"""Largest latitude: beyond it, east and north turn too fast."""
HIGHEST = 1e8
"""Largest height, m: beyond it, the navigator has long diverged."""

STATE_SIZE = 10
"""Columns of a kept state: latitude, longitude, height, velocity (3), quaternion (4)."""


class Place(NamedTuple):
    """Where the middle of a step is: its latitude's sine and cosine, its height, its radii of
    curvature in and across the meridian (height included), its gravity."""

    sin: float
    cos: float
    height: float
    radius_n: float
    radius_e: float
    gravity: float


@compiled
def place_midway(latitude: float, height: float, average: Vector, step: float) -> Place:
    """From where the step starts and its mean velocity."""
    radius_n = earth.meridian_radius(latitude) + height
    latitude = latitude + 0.5 * step * average[0] / radius_n
    height = height - 0.5 * step * average[2]
    return Place(
        np.sin(latitude),
        np.cos(latitude),
        height,
        earth.meridian_radius(latitude) + height,
        earth.transverse_radius(latitude) + height,
        earth.gravity(latitude, height),
    )


@compiled
def transport_rate(average: Vector, place: Place) -> Vector:
    """Turning of the navigation axes by motion over Earth, rad/s (Groves 2013, Eq. 5.44)."""
    rate_e = average[1] / place.radius_e
    return (rate_e, -average[0] / place.radius_n, -rate_e * place.sin / place.cos)


@compiled
def axes_turn(
    average: Vector, change: Vector, place: Place, step: float, clamped: bool
) -> tuple[Vector, Vector]:
    """What turning axes do over a step.

    Args:
        average: mean velocity, for axes that do not turn; corrected in here.
        change: velocity change by specific force.
        clamped: whether the mean velocity down is given, and right as it is.

    Returns:
        Rotation vector of the navigation axes against inertial ones; velocity change by Coriolis
        and transport (Groves 2013, Eq. 5.54).
    """
    omega_ie = (earth.RATE * place.cos, 0.0, -earth.RATE * place.sin)
    turn, coriolis, mean = (0.0, 0.0, 0.0), (0.0, 0.0, 0.0), average
    for _ in range(2):
        omega_en = transport_rate(mean, place)
        turn = scaled(step, add(omega_ie, omega_en))
        coriolis = scaled(-step, cross(add(scaled(2.0, omega_ie), omega_en), mean))
        bend = add(scaled(0.5, coriolis), scaled(-1 / 6, cross(turn, change)))
        sink = average[2] if clamped else average[2] + bend[2]
        mean = (average[0] + bend[0], average[1] + bend[1], sink)
    return turn, coriolis


@compiled
def seen_from_turning_axes(change: Vector, moving: Vector, turn: Vector) -> tuple[Vector, Vector]:
    """Specific force's velocity change, and its mean over the step, both given in the axes of the
    step's start, in axes that turn meanwhile (Savage 1998, Part II Eq. 10; second order here)."""
    behind = cross(turn, change)
    late = cross(turn, subtract(change, moving))
    seen = add(subtract(change, late), scaled(1 / 6, cross(turn, behind)))
    return seen, subtract(moving, scaled(1 / 6, behind))


@compiled
def mean_down(
    channel: VerticalChannel, k: int, step: float, unpulled: float, gravity: float
) -> float:
    """Mean velocity down over step k; but for gravity, `unpulled`."""
    if channel.clamped:
        return (channel.height[k] - channel.height[k + 1]) / step
    return unpulled + 0.5 * step * gravity


@compiled
def vertical_step(
    channel: VerticalChannel,
    k: int,
    step: float,
    now: Vector,
    pushed: Vector,
    gravity: float,
) -> Vector:
    """Height, velocity down and the integral of the height's excess after step k.

    Args:
        now: the same three before it; pushed: velocity change down but for gravity, its mean over
            the step, and the predicted height at the middle of it.
    """
    if channel.clamped:
        return (channel.height[k + 1], -channel.climb[k + 1], 0.0)
    height, down, lag = now
    change, moving, middle_height = pushed
    of_height, of_velocity, of_integral = channel.gains
    before = height - channel.height[k]
    excess = middle_height - 0.5 * (channel.height[k] + channel.height[k + 1])
    excess -= 0.5 * step * of_height * before
    drawn = of_velocity * excess + of_integral * (lag + 0.5 * step * excess)
    gained = step * (gravity + drawn)
    sink = down + moving + 0.5 * gained + of_height * excess
    return (height - step * sink, down + change + gained, lag + step * excess)


@compiled
def attitude_change(q: Quaternion, turned: Vector, turn: Vector) -> Quaternion:
    """Of the quaternion, by the body's rotation vector and the navigation axes'."""
    by_body = sum4(multiply(q, quaternion_beyond_unity(turned)), off_length(q))
    by_axes = multiply(small_quaternion_beyond_unity(scaled(-1.0, turn)), sum4(q, by_body))
    return sum4(by_body, by_axes)


@compiled
def navigate(
    position: Vector,
    vel: Vector,
    q: Quaternion,
    interval: float,
    rotation: Array,
    velocity: Array,
    weights: Weights,
    channel: VerticalChannel,
    keep: int,
    out: Array,
) -> tuple[int, float, float]:
    """Steps through all increments.

    Args:
        position: latitude, longitude, height; vel: velocity; q: attitude, body to navigation.
        interval: of the increments, s; rotation, velocity: (n, 3) increments.
        keep: steps between rows of `out` (m, STATE_SIZE).

    Returns:
        Number of steps made, fewer than all where the latitude or the height leaves its limit or
        the state is no longer finite; latitude and height there.
    """
    samples = len(weights.mean)
    step = samples * interval
    latitude, longitude, height = position
    lag, lost_latitude, lost_longitude = 0.0, 0.0, 0.0
    lost_q = (0.0, 0.0, 0.0, 0.0)
    steps = len(rotation) // samples
    for k in range(steps):
        turned, change, moving = body_step(rotation, velocity, k * samples, weights)
        change, moving = rotate(q, change), rotate(q, moving)

        gravity = earth.gravity(latitude, height)
        down = mean_down(channel, k, step, vel[2] + moving[2], gravity)
        average = (vel[0] + moving[0], vel[1] + moving[1], down)
        place = place_midway(latitude, height, average, step)
        turn, coriolis = axes_turn(average, change, place, step, channel.clamped)
        change, moving = seen_from_turning_axes(change, moving, turn)
        change, moving = add(change, coriolis), add(moving, scaled(0.5, coriolis))

        north = step * (vel[0] + moving[0]) / place.radius_n
        east = step * (vel[1] + moving[1]) / (place.radius_e * place.cos)
        latitude, lost_latitude = accumulated(latitude, lost_latitude, north)
        longitude, lost_longitude = accumulated(longitude, lost_longitude, east)
        pushed = (change[2], moving[2], place.height)
        now = (height, vel[2], lag)
        height, down, lag = vertical_step(channel, k, step, now, pushed, place.gravity)
        vel = (vel[0] + change[0], vel[1] + change[1], down)
        q, lost_q = accumulated4(q, lost_q, attitude_change(q, turned, turn))

        if not (abs(latitude) < LIMIT and abs(height) < HIGHEST and abs(q[0]) < 2):
            return k, latitude, height
        if (k + 1) % keep == 0:
            keep_state(out, (k + 1) // keep - 1, (latitude, longitude, height), vel, q)
    return steps, latitude, height


@compiled
def keep_state(out: Array, i: int, position: Vector, velocity: Vector, q: Quaternion) -> None:
    out[i, 0], out[i, 1], out[i, 2] = position
    out[i, 3], out[i, 4], out[i, 5] = velocity
    out[i, 6], out[i, 7], out[i, 8], out[i, 9] = q
