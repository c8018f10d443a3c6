"""Second-order error by the pattern's own drift (docs/methods/mission_model.md, Eq. 5).

A gyro's bias turns its pattern as rotation does. The electronics subtract a calibrated bias from
the output alone, so that the pattern still turns by the whole bias B: 1 deg/h turns it by 0.6 deg
in two hours, and changes the phase of a fourth harmonic by four times as much. The drift shifts the
residual bias map b and the error of the detected angle along the pattern angle. The rate error is a
sum of products of coefficients, and each product has its weight. The model has only the mean and
the fourth harmonic of B. b is the map of the warm gyro that remains after calibration.
"""

from dataclasses import dataclass

import numpy as np

from ins_eval.error_model.effects import ANGULAR_GAIN, Effect, pattern_angle
from ins_eval.error_model.linear_model import AXES
from ins_eval.error_model.motion import PARTS, Motion
from ins_eval.mission_model.gyro_map import HARMONICS, TERMS
from ins_eval.mission_model.signals import STEADY, WARMING, slice_coefficients
from ins_eval.trajectories.trajectory import Trajectory
from pyhrg.common.arrays import Array

FOURTH_HARMONIC = 1 + 2 * HARMONICS.index(4)
TURNING_TERMS = (0, FOURTH_HARMONIC, FOURTH_HARMONIC + 1)
"""Terms of the bias that turns the pattern: its mean and fourth harmonic."""
COUNT = 2 * 2 * len(HARMONICS) * len(TURNING_TERMS)
"""Number of products of two coefficients: one of a harmonic, of the bias map and then of the
scale-factor map, and one of `TURNING_TERMS`."""
STEP = 1.0
"""Step of the integration, s. Chosen: that of the linear model."""


@dataclass(frozen=True)
class TurningIntegrals:
    """Integrals over time since power-on of `TURNING_TERMS`, for patterns that start at angle 0.

    Attributes:
        time: (n,) s.
        integrals: (n, TURNING_TERMS, 3) s.
    """

    time: Array
    integrals: Array

    def at(self, motion: Motion, turning: int, axis: int) -> Array:
        """(m,) integral of a term for a gyro's axis at a motion's nodes, s."""
        nodes = motion.start + motion.step / PARTS * np.arange(len(motion.rate))
        return np.interp(nodes, self.time, self.integrals[:, turning, axis])


def integrate_turning_terms(trajectory: Trajectory, start: float, end: float) -> TurningIntegrals:
    """Integrals along a trajectory; the gyro is switched on at `start`; times in s."""
    count = round((end - start) / STEP)
    turned = np.cumsum(trajectory.increments(start, STEP, count).rotation, axis=0)
    angle = -ANGULAR_GAIN * np.concatenate([np.zeros((1, AXES)), turned])
    waves = np.stack(_evaluate_turning_terms(angle), axis=1)
    sums = np.cumsum(STEP * (waves[1:] + waves[:-1]) / 2, axis=0)
    return TurningIntegrals(
        start + STEP * np.arange(count + 1.0),
        np.concatenate([np.zeros((1, *sums.shape[1:])), sums]),
    )


def list_drift_effects(integrals: TurningIntegrals) -> list[Effect]:
    """`COUNT` effects, in the order of `compute_drift_products`."""
    harmonics = [
        (h, *waves) for h in HARMONICS for waves in ((np.cos, np.sin), (np.sin, _minus_cos))
    ]

    def effect(place: int, turning: int, scale: bool) -> Effect:
        harmonic, wave, slope = harmonics[place]

        def regressor(motion: Motion) -> Array:
            angle = pattern_angle(motion, np.zeros(AXES))
            swept = np.stack([integrals.at(motion, turning, axis) for axis in range(AXES)], axis=-1)
            moved = harmonic * ANGULAR_GAIN * slope(harmonic * angle) * swept
            if not scale:
                return np.asarray(moved)
            return np.asarray(
                motion.rate * moved
                + wave(harmonic * angle) * _evaluate_turning_terms(angle)[turning]
            )

        return Effect(f"pattern drift {place} {turning}", "gyro", regressor)

    return [
        effect(place, turning, scale)
        for scale in (False, True)
        for place in range(len(harmonics))
        for turning in range(len(TURNING_TERMS))
    ]


def compute_drift_products(in_flight: Array, turning: Array) -> Array:
    """(r, COUNT, 3) products of coefficients: (rad/s)^2 for the bias, rad/s for the scale factor.

    in_flight: (r, signals.COUNT, 3) coefficients in flight; turning: (r, TURNING_TERMS, 3) bias
    that turns the pattern, rad/s.
    """
    warm = in_flight[:, slice_coefficients(STEADY)] + sum(
        np.split(in_flight[:, slice_coefficients(WARMING)], 2, axis=1)
    )
    harmonics = np.concatenate([warm[:, 1:TERMS], warm[:, TERMS + 1 :]], axis=1)
    products = harmonics[:, :, None] * turning[:, None]
    return np.asarray(products.reshape(len(products), COUNT, -1))


def _evaluate_turning_terms(angle: Array) -> tuple[Array, ...]:
    """`TURNING_TERMS` of pattern angles, rad."""
    return np.ones_like(angle), np.cos(4 * angle), np.sin(4 * angle)


def _minus_cos(angle: Array) -> Array:
    return np.asarray(-np.cos(angle))
