"""Integration of a step's increments against exact integration and closed forms."""

from itertools import pairwise

import numpy as np
import pytest
from scipy.spatial.transform import Rotation
from scipy.special import j1

from ins_eval.navigation.body_step import integrate_body_step, rotation_integrals
from ins_eval.navigation.coefficients import SAMPLES_PER_STEP, derive_coefficients
from pyhrg.common.units import DEG_PER_H

NODES, WEIGHTS = np.polynomial.legendre.leggauss(8)


def rate_and_force(t: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Rate and force of a body that cones and vibrates."""
    omega = np.stack([np.cos(9 * t), np.sin(9 * t), 0.3 + 0.2 * t], axis=-1)
    force = np.stack([3 * np.sin(9 * t), 2 + np.cos(9 * t), 9.8 + t], axis=-1)
    return omega, force


def exact_motion(start: float, length: float) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Rotation vector, velocity change in the axes of the start, and its mean over the step: from
    2000 midpoint steps and 1000, extrapolated."""
    coarse, fine = (integrate_by_midpoints(start, length, count) for count in (1000, 2000))
    turn, change, mean = np.split((4 * fine - coarse) / 3, 3)
    return turn, change, mean


def integrate_by_midpoints(start: float, length: float, count: int) -> np.ndarray:
    h = length / count
    omega, force = rate_and_force(start + h * (np.arange(count) + 0.5))
    turned = Rotation.identity()
    felt = np.empty((count, 3))
    for i, step in enumerate(Rotation.from_rotvec(0.5 * h * omega)):
        turned = turned * step
        felt[i] = turned.apply(force[i])
        turned = turned * step
    to_go = 1 - (np.arange(count) + 0.5) / count
    return np.concatenate([turned.as_rotvec(), h * felt.sum(axis=0), h * to_go @ felt])


def increments(start: float, length: float, samples: int) -> tuple[np.ndarray, np.ndarray]:
    part = length / samples
    t = start + part * (np.arange(samples)[:, None] + 0.5 + 0.5 * NODES)
    omega, force = rate_and_force(t)
    weight = 0.5 * part * WEIGHTS[:, None]
    return np.sum(weight * omega, axis=1), np.sum(weight * force, axis=1)


@pytest.mark.parametrize("samples", SAMPLES_PER_STEP)
def test_errors_of_a_step_fall_as_they_should(samples: int) -> None:
    """With the fifth power of the step for rotation and velocity, the fourth for the mean of the
    velocity change; each lacking term would leave one power less."""
    errors = []
    for length in (0.08, 0.04):
        rotation, velocity = increments(0.2, length, samples)
        got = integrate_body_step(rotation, velocity, 0, derive_coefficients(samples))
        pairs = zip(got, exact_motion(0.2, length), strict=True)
        errors.append([np.linalg.norm(np.subtract(a, b)) for a, b in pairs])
    orders = np.log2(np.array(errors[0]) / errors[1])
    assert np.all(orders > [4.5, 4.5, 3.5]), orders


@pytest.mark.parametrize(("samples", "limit_deg_per_h"), [(2, 4e-3), (3, 2e-5), (4, 1e-5)])
def test_coning_rectification(samples: int, limit_deg_per_h: float) -> None:
    """1 deg at 2 Hz, increments at 100 Hz: the drift left after a minute."""
    half_angle, w, rate, seconds = np.deg2rad(1.0), 2 * np.pi * 2.0, 100, 60
    t = np.arange(seconds * rate + 1) / rate
    rotation = np.diff(
        np.stack(
            [
                np.sin(half_angle) * np.cos(w * t),
                np.sin(half_angle) * np.sin(w * t),
                -2 * w * np.sin(half_angle / 2) ** 2 * t,
            ],
            axis=-1,
        ),
        axis=0,
    )
    drift = accumulate_attitude(rotation, samples) * Rotation.from_rotvec([half_angle, 0, 0]).inv()
    assert np.linalg.norm(drift.as_rotvec()) / seconds < limit_deg_per_h * DEG_PER_H


def accumulate_attitude(rotation: np.ndarray, samples: int) -> Rotation:
    """Attitude after increments of a body that starts coning."""
    attitude = Rotation.from_rotvec([np.deg2rad(1.0), 0, 0])
    for first in range(0, len(rotation), samples):
        turned, _, _ = integrate_body_step(
            rotation, np.zeros_like(rotation), first, derive_coefficients(samples)
        )
        attitude = attitude * Rotation.from_rotvec(turned)
    return attitude


@pytest.mark.parametrize(("samples", "limit"), [(2, 1e-6), (3, 5e-8), (4, 5e-8)])
def test_sculling_rectification(samples: int, limit: float) -> None:
    """Rolling by a sin wt while shaking sideways with b sin wt lifts with b J1(a) on the average
    (Jacobi-Anger); 1 deg and 10 m/s^2 at 2 Hz, increments at 100 Hz. Limits in m/s^2, of 0.087."""
    a, b, w, rate, seconds = np.deg2rad(1.0), 10.0, 2 * np.pi * 2.0, 100, 60
    t = np.arange(seconds * rate + 1) / rate
    rotation, velocity = np.zeros((len(t) - 1, 3)), np.zeros((len(t) - 1, 3))
    rotation[:, 0] = np.diff(a * np.sin(w * t))
    velocity[:, 1] = np.diff(-b / w * np.cos(w * t))
    lifted = 0.0
    for first in range(0, len(rotation), samples):
        _, change, _ = integrate_body_step(rotation, velocity, first, derive_coefficients(samples))
        roll = a * np.sin(w * t[first])
        lifted += change[1] * np.sin(roll) + change[2] * np.cos(roll)
    assert abs(lifted / seconds - b * j1(a)) < limit


@pytest.mark.parametrize("samples", SAMPLES_PER_STEP)
@pytest.mark.parametrize("angle", [0.19, 0.21, 2.5])
def test_steady_turn_and_force_are_exact_at_any_angle(samples: int, angle: float) -> None:
    axis = np.array([0.6, 0.0, 0.8])
    turn, push = angle * axis, np.array([0.3, -2.0, 1.0])
    shares = np.full((samples, 1), 1 / samples)
    turned, change, mean = integrate_body_step(
        shares * turn, shares * push, 0, derive_coefficients(samples)
    )
    along = axis * (axis @ push)
    across, aside = push - along, np.cross(axis, push)
    sin, cos = np.sin(angle), np.cos(angle)
    exact = along + (sin * across + (1 - cos) * aside) / angle
    assert np.array(turned) == pytest.approx(turn, abs=1e-14)
    assert np.array(change) == pytest.approx(exact, abs=1e-13)
    exact = along / 2 + ((1 - cos) * across + (angle - sin) * aside) / angle**2
    assert np.array(mean) == pytest.approx(exact, abs=1e-12)


def test_series_meet_sine_and_cosine() -> None:
    """The relative step where one gives way to the other is of rounding."""
    for below, above in pairwise([0.04 * (1 - 1e-15), 0.04]):
        assert rotation_integrals(below) == pytest.approx(rotation_integrals(above), rel=1e-12)
