"""Vectors and quaternions, compiled; plain tuples."""

import numpy as np

from ins_eval.common.compiled import compiled

Vector = tuple[float, float, float]
Quaternion = tuple[float, float, float, float]
"""Scalar first."""

SMALL_SQUARED = 0.04
"""Up to this angle, rad, squared, a power series is both quicker and closer than sine and cosine;
every series here has rounding errors alone below it."""


@compiled
def add(a: Vector, b: Vector) -> Vector:
    return (a[0] + b[0], a[1] + b[1], a[2] + b[2])


@compiled
def subtract(a: Vector, b: Vector) -> Vector:
    return (a[0] - b[0], a[1] - b[1], a[2] - b[2])


@compiled
def scaled(s: float, a: Vector) -> Vector:
    return (s * a[0], s * a[1], s * a[2])


@compiled
def dot(a: Vector, b: Vector) -> float:
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


@compiled
def cross(a: Vector, b: Vector) -> Vector:
    return (
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    )


@compiled
def quaternion_beyond_unity(v: Vector) -> Quaternion:
    """A rotation vector's quaternion less (1, 0, 0, 0), without loss of digits."""
    s = dot(v, v)
    if s < SMALL_SQUARED:
        return small_quaternion_beyond_unity(v)
    angle = np.sqrt(s)
    factor = np.sin(0.5 * angle) / angle
    return (-2 * np.sin(0.25 * angle) ** 2, factor * v[0], factor * v[1], factor * v[2])


@compiled
def small_quaternion_beyond_unity(v: Vector) -> Quaternion:
    """The same of less than 0.2 rad."""
    s = dot(v, v)
    scalar = -s / 8 * (1 - s / 48 * (1 - s / 120 * (1 - s / 224)))
    factor = 0.5 - s / 48 * (1 - s / 80 * (1 - s / 168 * (1 - s / 288)))
    return (scalar, factor * v[0], factor * v[1], factor * v[2])


@compiled
def multiply(p: Quaternion, q: Quaternion) -> Quaternion:
    return (
        p[0] * q[0] - p[1] * q[1] - p[2] * q[2] - p[3] * q[3],
        p[0] * q[1] + p[1] * q[0] + p[2] * q[3] - p[3] * q[2],
        p[0] * q[2] - p[1] * q[3] + p[2] * q[0] + p[3] * q[1],
        p[0] * q[3] + p[1] * q[2] - p[2] * q[1] + p[3] * q[0],
    )


@compiled
def sum4(p: Quaternion, q: Quaternion) -> Quaternion:
    return (p[0] + q[0], p[1] + q[1], p[2] + q[2], p[3] + q[3])


@compiled
def off_length(q: Quaternion) -> Quaternion:
    """What a quaternion lacks of unit length, to first order."""
    s = 0.5 - 0.5 * (q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3])
    return (s * q[0], s * q[1], s * q[2], s * q[3])


@compiled
def accumulated(total: float, lost: float, change: float) -> tuple[float, float]:
    """Sum, and what rounding added to it (Kahan 1965): equal small changes round alike, and
    millions of them would drift."""
    change -= lost
    together = total + change
    return together, (together - total) - change


@compiled
def accumulated4(
    total: Quaternion, lost: Quaternion, change: Quaternion
) -> tuple[Quaternion, Quaternion]:
    a, lost_a = accumulated(total[0], lost[0], change[0])
    b, lost_b = accumulated(total[1], lost[1], change[1])
    c, lost_c = accumulated(total[2], lost[2], change[2])
    d, lost_d = accumulated(total[3], lost[3], change[3])
    return (a, b, c, d), (lost_a, lost_b, lost_c, lost_d)


@compiled
def rotate(q: Quaternion, v: Vector) -> Vector:
    u = (q[1], q[2], q[3])
    t = scaled(2.0, cross(u, v))
    return add(v, add(scaled(q[0], t), cross(u, t)))
