"""Strapdown navigation equations in navigation axes, compiled.

One step takes 2 to 4 increments (`body_step`). Earth's rate, transport rate, Coriolis acceleration
and gravity are evaluated at the step's middle with its mean velocity, which follows from the step's
own increments. The equations are in docs/methods/navigation.md.
"""

from typing import NamedTuple

import numpy as np

from ins_eval.common import earth
from ins_eval.navigation.algebra import (
    Quaternion,
    Vector,
    add,
    add_compensated,
    add_quaternion_compensated,
    add_quaternions,
    cross,
    multiply,
    normalization_correction,
    quaternion_minus_identity,
    rotate,
    scale,
    small_quaternion_minus_identity,
    subtract,
)
from ins_eval.navigation.body_step import integrate_body_step
from ins_eval.navigation.coefficients import StepCoefficients
from ins_eval.navigation.height import VerticalChannel
from pyhrg.common.arrays import Array
from pyhrg.common.caches.compiled import compile_loop

MAX_LATITUDE = np.deg2rad(89.5)
"""Largest latitude, rad. Chosen: nearer to a pole the navigation axes turn too fast."""
MAX_HEIGHT = 1e8
"""Largest height, m. Chosen: beyond it the navigation has diverged."""

Deflection = tuple[float, float]
"""Deflection of the vertical, north and east, rad."""

STATE_SIZE = 10
"""Columns of a stored state: latitude, longitude, height, velocity (3), quaternion (4)."""


class Midpoint(NamedTuple):
    """The middle of a step: sine and cosine of latitude; height, m; radii of curvature of meridian
    and prime vertical plus height, m; gravity down, north and east, m/s^2."""

    sin: float
    cos: float
    height: float
    radius_n: float
    radius_e: float
    gravity: float
    gravity_north: float
    gravity_east: float


@compile_loop
def locate_midpoint(
    latitude: float, height: float, average: Vector, step: float, deflection: Deflection
) -> Midpoint:
    """Return the step's middle from its start and its mean velocity."""
    radius_n = earth.meridian_radius(latitude) + height
    latitude = latitude + 0.5 * step * average[0] / radius_n
    height = height - 0.5 * step * average[2]
    north, east = earth.horizontal_gravity(latitude, height, deflection)
    return Midpoint(
        np.sin(latitude),
        np.cos(latitude),
        height,
        earth.meridian_radius(latitude) + height,
        earth.transverse_radius(latitude) + height,
        earth.gravity(latitude, height),
        north,
        east,
    )


@compile_loop
def transport_rate(average: Vector, place: Midpoint) -> Vector:
    """Return the transport rate `omega_en_n`, rad/s (Groves 2013, Eq. 5.44)."""
    rate_e = average[1] / place.radius_e
    return (rate_e, -average[0] / place.radius_n, -rate_e * place.sin / place.cos)


@compile_loop
def turn_navigation_axes(
    average: Vector, change: Vector, place: Midpoint, step: float, clamped: bool
) -> tuple[Vector, Vector]:
    """Return the rotation of the navigation axes over a step, rad, and the Coriolis velocity
    change, m/s.

    Two passes of docs/methods/navigation.md, Eqs. 10 and 11 (Groves 2013, Eq. 5.54). `average` is
    the mean velocity in axes that do not turn, `change` that by specific force, m/s; `clamped` says
    that the height reference gives the mean vertical velocity.
    """
    omega_ie = (earth.RATE * place.cos, 0.0, -earth.RATE * place.sin)
    turn, coriolis, mean = (0.0, 0.0, 0.0), (0.0, 0.0, 0.0), average
    for _ in range(2):
        omega_en = transport_rate(mean, place)
        turn = scale(step, add(omega_ie, omega_en))
        coriolis = scale(-step, cross(add(scale(2.0, omega_ie), omega_en), mean))
        bend = add(scale(0.5, coriolis), scale(-1 / 6, cross(turn, change)))
        sink = average[2] if clamped else average[2] + bend[2]
        mean = (average[0] + bend[0], average[1] + bend[1], sink)
    return turn, coriolis


@compile_loop
def transform_to_turning_axes(
    change: Vector, mean_change: Vector, turn: Vector
) -> tuple[Vector, Vector]:
    """Transform velocity change and its mean from the axes at the step's start to turning axes
    (docs/methods/navigation.md, Eq. 12; Savage 1998, Part II Eq. 10, to second order)."""
    crossed = cross(turn, change)
    lag = cross(turn, subtract(change, mean_change))
    transformed = add(subtract(change, lag), scale(1 / 6, cross(turn, crossed)))
    return transformed, subtract(mean_change, scale(1 / 6, crossed))


@compile_loop
def mean_down_velocity(
    channel: VerticalChannel, k: int, step: float, without_gravity: float, gravity: float
) -> float:
    """Return the mean velocity down over step k, m/s; `without_gravity` is what it would be in free
    space."""
    if channel.clamped:
        return (channel.height[k] - channel.height[k + 1]) / step
    return without_gravity + 0.5 * step * gravity


@compile_loop
def advance_vertical_channel(
    channel: VerticalChannel,
    k: int,
    step: float,
    state: Vector,
    predicted: Vector,
    gravity: float,
) -> Vector:
    """Return height, m, velocity down, m/s, and the height integral, m s, after step k, from those
    of `state`.

    docs/methods/navigation.md, Eqs. 13 and 14. `predicted`: velocity change down without gravity
    and its mean over the step, m/s, and the predicted height at its middle, m.
    """
    if channel.clamped:
        return (channel.height[k + 1], -channel.climb[k + 1], 0.0)
    height, down, integral = state
    change, mean_change, middle_height = predicted
    of_height, of_velocity, of_integral = channel.gains
    before = height - channel.height[k]
    excess = middle_height - 0.5 * (channel.height[k] + channel.height[k + 1])
    excess -= 0.5 * step * of_height * before
    feedback = of_velocity * excess + of_integral * (integral + 0.5 * step * excess)
    gained = step * (gravity + feedback)
    sink = down + mean_change + 0.5 * gained + of_height * excess
    return (height - step * sink, down + change + gained, integral + step * excess)


@compile_loop
def attitude_change(q: Quaternion, turned: Vector, turn: Vector) -> Quaternion:
    """Return the quaternion's change by the rotation vectors of body and navigation axes, rad
    (docs/methods/navigation.md, Eq. 16)."""
    by_body = add_quaternions(
        multiply(q, quaternion_minus_identity(turned)), normalization_correction(q)
    )
    by_axes = multiply(
        small_quaternion_minus_identity(scale(-1.0, turn)), add_quaternions(q, by_body)
    )
    return add_quaternions(by_body, by_axes)


@compile_loop
def resolve_step(
    k: int,
    step: float,
    latitude: float,
    height: float,
    vel: Vector,
    q: Quaternion,
    body: tuple[Vector, Vector, Vector],
    channel: VerticalChannel,
    deflection: Deflection,
) -> tuple[Midpoint, Vector, Vector, Vector]:
    """Resolve the result of `integrate_body_step` in navigation axes: middle of the step, rotation
    vector of the axes, rad, velocity change without gravity down, m/s, and its mean over the step,
    m/s."""
    change, mean_change = rotate(q, body[1]), rotate(q, body[2])
    gravity = earth.gravity(latitude, height)
    down = mean_down_velocity(channel, k, step, vel[2] + mean_change[2], gravity)
    north, east = earth.horizontal_gravity(latitude, height, deflection)
    average = (
        vel[0] + mean_change[0] + 0.5 * step * north,
        vel[1] + mean_change[1] + 0.5 * step * east,
        down,
    )
    place = locate_midpoint(latitude, height, average, step, deflection)
    turn, coriolis = turn_navigation_axes(average, change, place, step, channel.clamped)
    change, mean_change = transform_to_turning_axes(change, mean_change, turn)
    pulled = add(coriolis, scale(step, (place.gravity_north, place.gravity_east, 0.0)))
    return place, turn, add(change, pulled), add(mean_change, scale(0.5, pulled))


@compile_loop
def run_steps(
    position: Vector,
    vel: Vector,
    q: Quaternion,
    interval: float,
    rotation: Array,
    velocity: Array,
    coefficients: StepCoefficients,
    channel: VerticalChannel,
    deflection: Deflection,
    keep: int,
    out: Array,
) -> tuple[int, float, float]:
    """Navigate through increments (n, 3), rad and m/s, and store every `keep`-th step's state in
    `out` (m, STATE_SIZE).

    Returns the number of steps made, latitude and height: it stops early where a limit is exceeded
    or the state is not finite.
    """
    samples = len(coefficients.mean)
    step = samples * interval
    latitude, longitude, height = position
    integral, latitude_error, longitude_error = 0.0, 0.0, 0.0
    q_error = (0.0, 0.0, 0.0, 0.0)
    steps = len(rotation) // samples
    for k in range(steps):
        body = integrate_body_step(rotation, velocity, k * samples, coefficients)
        place, turn, change, mean_change = resolve_step(
            k, step, latitude, height, vel, q, body, channel, deflection
        )

        north = step * (vel[0] + mean_change[0]) / place.radius_n
        east = step * (vel[1] + mean_change[1]) / (place.radius_e * place.cos)
        latitude, latitude_error = add_compensated(latitude, latitude_error, north)
        longitude, longitude_error = add_compensated(longitude, longitude_error, east)
        predicted = (change[2], mean_change[2], place.height)
        state = (height, vel[2], integral)
        height, down, integral = advance_vertical_channel(
            channel, k, step, state, predicted, place.gravity
        )
        vel = (vel[0] + change[0], vel[1] + change[1], down)
        q, q_error = add_quaternion_compensated(q, q_error, attitude_change(q, body[0], turn))

        if not (abs(latitude) < MAX_LATITUDE and abs(height) < MAX_HEIGHT and abs(q[0]) < 2):
            return k, latitude, height
        if (k + 1) % keep == 0:
            store_state(out, (k + 1) // keep - 1, (latitude, longitude, height), vel, q)
    return steps, latitude, height


@compile_loop
def store_state(out: Array, i: int, position: Vector, velocity: Vector, q: Quaternion) -> None:
    out[i, 0], out[i, 1], out[i, 2] = position
    out[i, 3], out[i, 4], out[i, 5] = velocity
    out[i, 6], out[i, 7], out[i, 8], out[i, 9] = q
