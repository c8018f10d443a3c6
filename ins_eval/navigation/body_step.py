"""One step in body axes: what a few increments of an IMU amount to together; compiled."""

import numpy as np
from numpy.typing import NDArray

from ins_eval.common.compiled import compiled
from ins_eval.navigation.algebra import SMALL_SQUARED, Vector, add, cross, dot, scaled, subtract
from ins_eval.navigation.coefficients import Weights

Array = NDArray[np.float64]


@compiled
def body_step(
    rotation: Array, velocity: Array, first: int, weights: Weights
) -> tuple[Vector, Vector, Vector]:
    """Increments `first` and on, as many as there are weights, in the body axes of their start.

    Returns:
        Rotation vector; velocity change; mean of the velocity change over the step. For constant
        rate and force they are exact at any angle; to these come coning, sculling and scrolling
        (Savage 1998, Part I Eq. 23, Part II Eqs. 19 and 82).
    """
    turning, scrolling, mean = weights
    n = len(mean)
    turn = (0.0, 0.0, 0.0)
    push = (0.0, 0.0, 0.0)
    coning = (0.0, 0.0, 0.0)
    sculling = (0.0, 0.0, 0.0)
    turning_mean = (0.0, 0.0, 0.0)
    moving = (0.0, 0.0, 0.0)
    scrolled = (0.0, 0.0, 0.0)
    for j in range(n):
        alpha_j, beta_j = row(rotation, first + j), row(velocity, first + j)
        turn, push = add(turn, alpha_j), add(push, beta_j)
        turning_mean = add(turning_mean, scaled(mean[j], alpha_j))
        moving = add(moving, scaled(mean[j], beta_j))
        for i in range(n):
            alpha_i = row(rotation, first + i)
            across = cross(alpha_i, beta_j)
            sculling = add(sculling, scaled(turning[i, j], across))
            scrolled = add(scrolled, scaled(scrolling[i, j], across))
            if i < j:
                coning = add(coning, scaled(turning[i, j], cross(alpha_i, alpha_j)))
    once = cross(turn, push)
    twice = cross(turn, once)
    uneven = unevenness(turn, push, turning_mean, moving, once)
    a, b, c = turned_integrals(dot(turn, turn))
    change = add(add(add(push, sculling), uneven), add(scaled(a, once), scaled(b, twice)))
    moving = add(add(moving, scrolled), add(scaled(b, once), scaled(c, twice)))
    return add(turn, coning), change, moving


@compiled
def unevenness(
    turn: Vector, push: Vector, turning_mean: Vector, moving: Vector, once: Vector
) -> Vector:
    """Velocity change of second order in the angle and first in the slopes of rate and force.

    With angle r t + d (t^2 - t) and velocity v t + e (t^2 - t), 0 < t < 1, twice the integral of
    the force through the rotation (Bortz 1971, to second order) leaves
    (r x (r x e) - d x (r x v)) / 12; d = 3 (r - 2 mean angle), e likewise.
    """
    rate_slope = subtract(turn, scaled(2.0, turning_mean))
    force_slope = subtract(push, scaled(2.0, moving))
    of_force = cross(turn, cross(turn, force_slope))
    return scaled(0.25, subtract(of_force, cross(rate_slope, once)))


@compiled
def turned_integrals(s: float) -> Vector:
    """(1 - cos x)/x^2, (x - sin x)/x^3, (x^2/2 - 1 + cos x)/x^4 for x^2 = s: weights of r x v and
    r x (r x v) in the integral and the double integral of a constant force in turning axes."""
    if s < SMALL_SQUARED:
        return (
            1 / 2 - s / 24 * (1 - s / 30 * (1 - s / 56 * (1 - s / 90))),
            1 / 6 - s / 120 * (1 - s / 42 * (1 - s / 72 * (1 - s / 110))),
            1 / 24 - s / 720 * (1 - s / 56 * (1 - s / 90 * (1 - s / 132))),
        )
    x = np.sqrt(s)
    versine = 1 - np.cos(x)
    return versine / s, (x - np.sin(x)) / (s * x), (s / 2 - versine) / (s * s)


@compiled
def row(table: Array, i: int) -> Vector:
    return (table[i, 0], table[i, 1], table[i, 2])
