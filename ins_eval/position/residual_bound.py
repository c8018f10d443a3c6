"""Bounds of the position error that an unexplained residual rate could cause."""

import math
from dataclasses import dataclass
from itertools import product

import numpy as np

from ins_eval.mission_model.mission_weights import MissionWeights
from ins_eval.mission_model.missions import SETTLING, STILL
from pyhrg.noise.coefficients import COEFFICIENT_NAMES

RANDOM_WALK = COEFFICIENT_NAMES.index("angle_random_walk")


@dataclass(frozen=True)
class ResidualBound:
    """Largest horizontal error at a mission's end, m, of three gyros whose rate errors have the
    same rms.

    steady: with rate errors that are constant, over all combinations of signs;
    any_course: with rate errors that vary in time in any way.
    """

    steady: float
    any_course: float


def bound_residual_error(weights: MissionWeights, rate: float) -> ResidualBound:
    """Bounds for rate errors of this rms, rad/s, from the alignment to the mission's end.

    The position error is the integral of each rate error times a weight. By the Cauchy-Schwarz
    inequality it is at most the duration's root times the rms of the rate error times the root of
    the integral of the squared weight; the latter is the error per unit of angle random walk.
    """
    bias = weights.gyros[-1, :, 0]
    steady = max(float(np.hypot(*(bias @ np.array(signs)))) for signs in product((1, -1), repeat=3))
    duration = STILL - SETTLING + float(weights.time[-1])
    largest = np.linalg.eigvalsh(weights.noise[RANDOM_WALK][:, -2:, -2:])[:, -1]
    any_course = math.sqrt(duration) * float(np.sqrt(np.maximum(largest, 0.0)).sum())
    return ResidualBound(rate * steady, rate * any_course)
