"""The strapdown equations, compiled; plain numbers in tuples and arrays.

One step takes a few increments. Rate and specific force are polynomials within it (`coefficients`);
Earth's and transport rate, Coriolis and gravity are those of the step's mean velocity at its
middle. The mean velocity comes from the step's own increments, not from the step before.
"""

import numpy as np

from ins_eval import earth
from ins_eval.compiled import compiled

FREE, CLAMPED, DAMPED = 0, 1, 2
"""What holds the height."""

LIMIT = np.deg2rad(89.5)
"""Largest latitude: beyond it, east and north turn too fast."""


@compiled
def add(a, b):
    return (a[0] + b[0], a[1] + b[1], a[2] + b[2])


@compiled
def scaled(s, a):
    return (s * a[0], s * a[1], s * a[2])


@compiled
def cross(a, b):
    return (
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    )


@compiled
def row(table, i):
    return (table[i, 0], table[i, 1], table[i, 2])


@compiled
def quaternion(v):
    """Quaternion of a rotation vector; the next terms are below 1e-14 up to 0.5 rad."""
    s = v[0] * v[0] + v[1] * v[1] + v[2] * v[2]
    scalar = 1 - s / 8 * (1 - s / 48 * (1 - s / 120 * (1 - s / 224)))
    factor = 0.5 - s / 48 * (1 - s / 80 * (1 - s / 168 * (1 - s / 288)))
    return (scalar, factor * v[0], factor * v[1], factor * v[2])


@compiled
def multiply(p, q):
    return (
        p[0] * q[0] - p[1] * q[1] - p[2] * q[2] - p[3] * q[3],
        p[0] * q[1] + p[1] * q[0] + p[2] * q[3] - p[3] * q[2],
        p[0] * q[2] - p[1] * q[3] + p[2] * q[0] + p[3] * q[1],
        p[0] * q[3] + p[1] * q[2] - p[2] * q[1] + p[3] * q[0],
    )


@compiled
def rotate(q, v):
    u = (q[1], q[2], q[3])
    t = scaled(2.0, cross(u, v))
    return add(v, add(scaled(q[0], t), cross(u, t)))


@compiled
def summed(rotation, velocity, first, turning, scrolling, mean):
    """One step's increments in the body axes of its start.

    Returns:
        Rotation vector; velocity change; mean of the velocity change over the step. With constant
        rate and force they are exact up to the fifth order in the angle (Savage 1998, Eqs. 23 and
        Part II 19; Rodrigues).
    """
    r = (0.0, 0.0, 0.0)
    v = (0.0, 0.0, 0.0)
    noncommuting = (0.0, 0.0, 0.0)
    rotating = (0.0, 0.0, 0.0)
    moving = (0.0, 0.0, 0.0)
    n = len(mean)
    for j in range(n):
        aj, bj = row(rotation, first + j), row(velocity, first + j)
        r, v = add(r, aj), add(v, bj)
        moving = add(moving, scaled(mean[j], bj))
        for i in range(n):
            ai = row(rotation, first + i)
            across = cross(ai, bj)
            rotating = add(rotating, scaled(turning[i, j], across))
            moving = add(moving, scaled(scrolling[i, j], across))
            if i < j:
                noncommuting = add(noncommuting, scaled(turning[i, j], cross(ai, aj)))
    once = cross(r, v)
    twice = cross(r, once)
    s = r[0] * r[0] + r[1] * r[1] + r[2] * r[2]
    change = add(v, add(scaled(0.5 - s / 24 * (1 - s / 30), once), rotating))
    change = add(change, scaled(1 / 6 - s / 120 * (1 - s / 42), twice))
    moving = add(moving, add(scaled(1 / 6 - s / 120, once), scaled(1 / 24 - s / 720, twice)))
    return add(r, noncommuting), change, moving


@compiled
def transport_rate(average, radius_n, radius_e, tangent):
    """Turning of the navigation axes by motion over Earth, rad/s (Groves 2013, Eq. 5.44)."""
    rate_e = average[1] / radius_e
    return (rate_e, -average[0] / radius_n, -rate_e * tangent)


@compiled
def coriolis_change(omega_ie, omega_en, average, step):
    """Velocity change by Coriolis and transport (Groves 2013, Eq. 5.54)."""
    return scaled(-step, cross(add(scaled(2.0, omega_ie), omega_en), average))


@compiled
def navigate(
    place, speed, attitude, interval, rotation, velocity, weights, mode, reference, gains, keep, out
):
    """Steps through all increments.

    Args:
        place: latitude, longitude, height; speed: (3,); attitude: quaternion body to navigation.
        interval: of the increments, s; rotation, velocity: (n, 3) increments.
        weights: `coefficients.Weights`.
        mode: FREE, CLAMPED or DAMPED; reference: height at the start and after each step, m.
        gains: three, of the damped vertical channel, 1/s, 1/s2, 1/s3.
        keep: steps between rows of `out`, which takes latitude, longitude, height, velocity (3),
            quaternion (4).

    Returns:
        Number of steps made; fewer than all where the latitude leaves its limit or the state is
        no longer finite.
    """
    turning, scrolling, mean = weights
    n = len(mean)
    step = n * interval
    q = (attitude[0], attitude[1], attitude[2], attitude[3])
    vel = (speed[0], speed[1], speed[2])
    latitude, longitude, height = place
    lag = 0.0
    steps = len(rotation) // n
    for k in range(steps):
        turned, change, moving = summed(rotation, velocity, k * n, turning, scrolling, mean)
        change, moving = rotate(q, change), rotate(q, moving)

        # Where the middle of the step is.
        down = vel[2] + moving[2] + 0.5 * step * earth.gravity(latitude, height)
        if mode == CLAMPED:
            down = (reference[k] - reference[k + 1]) / step
        average = (vel[0] + moving[0], vel[1] + moving[1], down)
        middle_height = height - 0.5 * step * down
        radius_n = earth.meridian_radius(latitude) + middle_height
        middle = latitude + 0.5 * step * average[0] / radius_n
        sin, cos = np.sin(middle), np.cos(middle)
        radius_n = earth.meridian_radius(middle) + middle_height
        radius_e = earth.transverse_radius(middle) + middle_height

        # Rates of the navigation axes, from the step's mean velocity.
        omega_ie = (earth.RATE * cos, 0.0, -earth.RATE * sin)
        omega_en = transport_rate(average, radius_n, radius_e, sin / cos)
        coriolis = coriolis_change(omega_ie, omega_en, average, step)
        average = add(average, scaled(0.5, coriolis))
        if mode == CLAMPED:
            average = (average[0], average[1], down)
        omega_en = transport_rate(average, radius_n, radius_e, sin / cos)
        coriolis = coriolis_change(omega_ie, omega_en, average, step)
        turn = scaled(step, add(omega_ie, omega_en))

        # Velocity; specific force lags behind the turning axes.
        behind = cross(turn, change)
        change = add(change, add(coriolis, cross(turn, add(moving, scaled(-1.0, change)))))
        moving = add(moving, add(scaled(-1 / 6, behind), scaled(0.5, coriolis)))
        average = add(vel, moving)
        vel = add(vel, change)

        # Height.
        if mode == CLAMPED:
            height = reference[k + 1]
            vel = (vel[0], vel[1], down)
        else:
            gained = step * earth.gravity(middle, middle_height)
            down = vel[2] - change[2] + moving[2] + 0.5 * gained
            ahead = height - step * down
            if mode == DAMPED:
                excess = middle_height - 0.5 * (reference[k] + reference[k + 1])
                lag += step * excess
                ahead -= step * gains[0] * excess
                gained += step * (gains[1] * excess + gains[2] * lag)
            vel = (vel[0], vel[1], vel[2] + gained)
            height = ahead

        # Position.
        latitude += step * average[0] / radius_n
        longitude += step * average[1] / (radius_e * cos)

        # Attitude.
        q = multiply(quaternion(scaled(-1.0, turn)), multiply(q, quaternion(turned)))
        norm = 1.5 - 0.5 * (q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3])
        q = (q[0] * norm, q[1] * norm, q[2] * norm, q[3] * norm)

        if not (abs(latitude) < LIMIT and abs(height) < 1e8 and abs(q[0]) < 2):
            return k
        if (k + 1) % keep == 0:
            kept = (k + 1) // keep - 1
            out[kept, 0], out[kept, 1], out[kept, 2] = latitude, longitude, height
            out[kept, 3], out[kept, 4], out[kept, 5] = vel
            out[kept, 6], out[kept, 7], out[kept, 8], out[kept, 9] = q
    return steps
