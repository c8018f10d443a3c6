"""Algebra of vectors and quaternions, compiled; both are plain tuples."""

import numpy as np

from pyhrg.common.caches.compiled import compile_loop

Vector = tuple[float, float, float]
Quaternion = tuple[float, float, float, float]
"""Scalar first."""

SMALL_ANGLE_SQUARED = 0.04
"""Square of the angle, rad^2, below which power series replace sine and cosine: they are faster and
more accurate there. Derived: the first term left out is below rounding for every series here."""


@compile_loop
def add(a: Vector, b: Vector) -> Vector:
    return (a[0] + b[0], a[1] + b[1], a[2] + b[2])


@compile_loop
def subtract(a: Vector, b: Vector) -> Vector:
    return (a[0] - b[0], a[1] - b[1], a[2] - b[2])


@compile_loop
def scale(s: float, a: Vector) -> Vector:
    return (s * a[0], s * a[1], s * a[2])


@compile_loop
def dot(a: Vector, b: Vector) -> float:
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


@compile_loop
def cross(a: Vector, b: Vector) -> Vector:
    return (
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    )


@compile_loop
def quaternion_minus_identity(v: Vector) -> Quaternion:
    """Return the quaternion of a rotation vector, rad, minus (1, 0, 0, 0), without cancellation."""
    s = dot(v, v)
    if s < SMALL_ANGLE_SQUARED:
        return small_quaternion_minus_identity(v)
    angle = np.sqrt(s)
    factor = np.sin(0.5 * angle) / angle
    return (-2 * np.sin(0.25 * angle) ** 2, factor * v[0], factor * v[1], factor * v[2])


@compile_loop
def small_quaternion_minus_identity(v: Vector) -> Quaternion:
    """Return the same for an angle below 0.2 rad, by power series."""
    s = dot(v, v)
    scalar = -s / 8 * (1 - s / 48 * (1 - s / 120 * (1 - s / 224)))
    factor = 0.5 - s / 48 * (1 - s / 80 * (1 - s / 168 * (1 - s / 288)))
    return (scalar, factor * v[0], factor * v[1], factor * v[2])


@compile_loop
def multiply(p: Quaternion, q: Quaternion) -> Quaternion:
    return (
        p[0] * q[0] - p[1] * q[1] - p[2] * q[2] - p[3] * q[3],
        p[0] * q[1] + p[1] * q[0] + p[2] * q[3] - p[3] * q[2],
        p[0] * q[2] - p[1] * q[3] + p[2] * q[0] + p[3] * q[1],
        p[0] * q[3] + p[1] * q[2] - p[2] * q[1] + p[3] * q[0],
    )


@compile_loop
def add_quaternions(p: Quaternion, q: Quaternion) -> Quaternion:
    return (p[0] + q[0], p[1] + q[1], p[2] + q[2], p[3] + q[3])


@compile_loop
def normalization_correction(q: Quaternion) -> Quaternion:
    """Return what must be added to a quaternion to give it unit length, to first order."""
    s = 0.5 - 0.5 * (q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3])
    return (s * q[0], s * q[1], s * q[2], s * q[3])


@compile_loop
def add_compensated(total: float, error: float, change: float) -> tuple[float, float]:
    """Add a change; return the sum and its rounding error (Kahan 1965; docs/methods/navigation.md,
    Eq. 15): millions of equal small changes all round the same way."""
    change -= error
    together = total + change
    return together, (together - total) - change


@compile_loop
def add_quaternion_compensated(
    total: Quaternion, error: Quaternion, change: Quaternion
) -> tuple[Quaternion, Quaternion]:
    a, error_a = add_compensated(total[0], error[0], change[0])
    b, error_b = add_compensated(total[1], error[1], change[1])
    c, error_c = add_compensated(total[2], error[2], change[2])
    d, error_d = add_compensated(total[3], error[3], change[3])
    return (a, b, c, d), (error_a, error_b, error_c, error_d)


@compile_loop
def rotate(q: Quaternion, v: Vector) -> Vector:
    u = (q[1], q[2], q[3])
    t = scale(2.0, cross(u, v))
    return add(v, add(scale(q[0], t), cross(u, t)))
