"""Rotation and velocity change of one navigation step, in body axes, compiled.

The equations are in docs/methods/navigation.md.
"""

import numpy as np

from ins_eval.navigation.algebra import (
    SMALL_ANGLE_SQUARED,
    Vector,
    add,
    cross,
    dot,
    scale,
    subtract,
)
from ins_eval.navigation.coefficients import StepCoefficients
from pyhrg.common.arrays import Array
from pyhrg.common.caches.compiled import compile_loop


@compile_loop
def integrate_body_step(
    rotation: Array, velocity: Array, first: int, coefficients: StepCoefficients
) -> tuple[Vector, Vector, Vector]:
    """Integrate the (n, 3) increments, rad and m/s, of the step that begins with row `first`
    (docs/methods/navigation.md, Eqs. 1 to 4).

    Returns in the body axes at the step's start: rotation vector, rad; velocity change by specific
    force, m/s; mean of the velocity change over the step, m/s. All are exact for constant rate and
    force at any angle; coning, sculling and scrolling terms are added (Savage 1998, Part I Eq. 23,
    Part II Eqs. 19 and 82).
    """
    turning, scrolling, mean = coefficients
    n = len(mean)
    turn = (0.0, 0.0, 0.0)
    push = (0.0, 0.0, 0.0)
    coning = (0.0, 0.0, 0.0)
    sculling = (0.0, 0.0, 0.0)
    turning_mean = (0.0, 0.0, 0.0)
    mean_change = (0.0, 0.0, 0.0)
    scrolled = (0.0, 0.0, 0.0)
    for j in range(n):
        alpha_j, beta_j = get_row(rotation, first + j), get_row(velocity, first + j)
        turn, push = add(turn, alpha_j), add(push, beta_j)
        turning_mean = add(turning_mean, scale(mean[j], alpha_j))
        mean_change = add(mean_change, scale(mean[j], beta_j))
        for i in range(n):
            alpha_i = get_row(rotation, first + i)
            across = cross(alpha_i, beta_j)
            sculling = add(sculling, scale(turning[i, j], across))
            scrolled = add(scrolled, scale(scrolling[i, j], across))
            if i < j:
                coning = add(coning, scale(turning[i, j], cross(alpha_i, alpha_j)))
    once = cross(turn, push)
    twice = cross(turn, once)
    slopes = slope_correction(turn, push, turning_mean, mean_change, once)
    a, b, c = rotation_integrals(dot(turn, turn))
    change = add(add(add(push, sculling), slopes), add(scale(a, once), scale(b, twice)))
    mean_change = add(add(mean_change, scrolled), add(scale(b, once), scale(c, twice)))
    return add(turn, coning), change, mean_change


@compile_loop
def slope_correction(
    turn: Vector, push: Vector, turning_mean: Vector, mean_change: Vector, once: Vector
) -> Vector:
    """Return the velocity change of second order in the angle and first order in the slopes of
    rate and force (docs/methods/navigation.md, Eq. 5)."""
    rate_slope = subtract(turn, scale(2.0, turning_mean))
    force_slope = subtract(push, scale(2.0, mean_change))
    of_force = cross(turn, cross(turn, force_slope))
    return scale(0.25, subtract(of_force, cross(rate_slope, once)))


@compile_loop
def rotation_integrals(s: float) -> Vector:
    """Return (1 - cos x)/x^2, (x - sin x)/x^3 and (x^2/2 - 1 + cos x)/x^4 for s = x^2.

    They are the factors of r x v and r x (r x v) in the integral and the double integral of a
    constant force in turning axes (docs/methods/navigation.md, Eq. 4).
    """
    if s < SMALL_ANGLE_SQUARED:
        return (
            1 / 2 - s / 24 * (1 - s / 30 * (1 - s / 56 * (1 - s / 90))),
            1 / 6 - s / 120 * (1 - s / 42 * (1 - s / 72 * (1 - s / 110))),
            1 / 24 - s / 720 * (1 - s / 56 * (1 - s / 90 * (1 - s / 132))),
        )
    x = np.sqrt(s)
    versine = 1 - np.cos(x)
    return versine / s, (x - np.sin(x)) / (s * x), (s / 2 - versine) / (s * s)


@compile_loop
def get_row(table: Array, i: int) -> Vector:
    return (table[i, 0], table[i, 1], table[i, 2])
