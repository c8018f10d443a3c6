"""The pattern's own drift, of second order: a gyro's bias turns its pattern, as rotation does.

What is left of a bias after calibration is small, but the pattern goes by the whole of it, which
the electronics take out of the output alone: 1 deg/h turns it by 0.6 deg in two hours, and a fourth
harmonic by four times that. With B the bias that turns it and b what is left of it,

    d rate = b'(th) d th,    d th = -k integral of B(th) dt,

th the angle without drift: sums of products of coefficients, with weights of their own. Of B the
mean and the fourth harmonic count; of b what is left when the gyro is warm. The scale factor's map
is the error e(th) of the angle that is read, and moves as well: e'(th) d th, of which the rate of
change counts.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ins_eval.error_model.effects import BRYAN_FACTOR, Effect, pattern_angle
from ins_eval.error_model.motion import PARTS, Motion
from ins_eval.mission_model.gyro_map import HARMONICS, TERMS
from ins_eval.mission_model.signals import STEADY, WARMING, coefficients_of
from ins_eval.trajectories.trajectory import Trajectory

Array = NDArray[np.float64]

FOURTH = 1 + 2 * HARMONICS.index(4)
TURNING = (0, FOURTH, FOURTH + 1)
"""Terms of the bias that turns the pattern."""
AXES = 3
COUNT = 2 * 2 * len(HARMONICS) * len(TURNING)
"""Products of harmonics, of the bias and then of the scale factor, and `TURNING`."""
STEP = 1.0
"""Of the integral, s."""


@dataclass(frozen=True)
class Swept:
    """Integrals of the terms `TURNING` since power-on, of pattern angles that start at 0.

    time: (n,) s; integrals: (n, TURNING, 3) s.
    """

    time: Array
    integrals: Array

    def at(self, motion: Motion, turning: int, axis: int) -> Array:
        """(m,) at a motion's nodes."""
        nodes = motion.start + motion.step / PARTS * np.arange(len(motion.rate))
        return np.interp(nodes, self.time, self.integrals[:, turning, axis])


def swept(trajectory: Trajectory, start: float, end: float) -> Swept:
    """Along a trajectory that the gyro is switched on at the start of; times in s."""
    count = round((end - start) / STEP)
    turned = np.cumsum(trajectory.increments(start, STEP, count).rotation, axis=0)
    angle = -BRYAN_FACTOR * np.concatenate([np.zeros((1, AXES)), turned])
    waves = np.stack(_turning(angle), axis=1)
    sums = np.cumsum(STEP * (waves[1:] + waves[:-1]) / 2, axis=0)
    return Swept(
        start + STEP * np.arange(count + 1.0),
        np.concatenate([np.zeros((1, *sums.shape[1:])), sums]),
    )


def drift_effects(by: Swept) -> list[Effect]:
    """`COUNT` effects, of products as `drift_products` has them."""
    harmonics = [
        (h, *waves) for h in HARMONICS for waves in ((np.cos, np.sin), (np.sin, _minus_cos))
    ]

    def effect(place: int, turning: int, scale: bool) -> Effect:
        harmonic, wave, slope = harmonics[place]

        def regressor(motion: Motion) -> Array:
            angle = pattern_angle(motion, np.zeros(AXES))
            swept = np.stack([by.at(motion, turning, axis) for axis in range(AXES)], axis=-1)
            moved = harmonic * BRYAN_FACTOR * slope(harmonic * angle) * swept
            if not scale:
                return np.asarray(moved)
            return np.asarray(
                motion.rate * moved + wave(harmonic * angle) * _turning(angle)[turning]
            )

        return Effect(f"pattern drift {place} {turning}", "gyro", "", regressor)

    return [
        effect(place, turning, scale)
        for scale in (False, True)
        for place in range(len(harmonics))
        for turning in range(len(TURNING))
    ]


def drift_products(in_flight: Array, turning: Array) -> Array:
    """(r, COUNT, 3) products, (rad/s)^2 and rad/s.

    Args:
        in_flight: (r, signals.COUNT, 3) coefficients.
        turning: (r, TURNING, 3) of the bias that turns the pattern, rad/s.
    """
    left = in_flight[:, coefficients_of(STEADY)] + sum(
        np.split(in_flight[:, coefficients_of(WARMING)], 2, axis=1)
    )
    harmonics = np.concatenate([left[:, 1:TERMS], left[:, TERMS + 1 :]], axis=1)
    products = harmonics[:, :, None] * turning[:, None]
    return np.asarray(products.reshape(len(products), COUNT, -1))


def _turning(angle: Array) -> tuple[Array, ...]:
    """Waves of the terms `TURNING`."""
    return np.ones_like(angle), np.cos(4 * angle), np.sin(4 * angle)


def _minus_cos(angle: Array) -> Array:
    return np.asarray(-np.cos(angle))
