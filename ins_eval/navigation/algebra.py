"""Vectors and quaternions, compiled; plain tuples."""

import numpy as np

from ins_eval.compiled import compiled

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
def quaternion(v: Vector) -> Quaternion:
    """Of a rotation vector, rad."""
    s = dot(v, v)
    if s < SMALL_SQUARED:
        return small_quaternion(v)
    angle = np.sqrt(s)
    factor = np.sin(0.5 * angle) / angle
    return (np.cos(0.5 * angle), factor * v[0], factor * v[1], factor * v[2])


@compiled
def small_quaternion(v: Vector) -> Quaternion:
    """Of a rotation vector of less than 0.2 rad."""
    s = dot(v, v)
    scalar = 1 - s / 8 * (1 - s / 48 * (1 - s / 120 * (1 - s / 224)))
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
def normalized(q: Quaternion) -> Quaternion:
    """One Newton step: for quaternions that are off unit length by rounding."""
    s = 1.5 - 0.5 * (q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3])
    return (s * q[0], s * q[1], s * q[2], s * q[3])


@compiled
def rotate(q: Quaternion, v: Vector) -> Vector:
    u = (q[1], q[2], q[3])
    t = scaled(2.0, cross(u, v))
    return add(v, add(scaled(q[0], t), cross(u, t)))
