"""What a residual that nothing explains could do to the position."""

import math
from dataclasses import dataclass
from itertools import product

import numpy as np

from ins_eval.mission_model.mission_weights import MissionWeights
from ins_eval.mission_model.missions import SETTLING, STILL
from ins_eval.mission_model.noise_weights import KINDS

WALK = KINDS.index("angle random walk")


@dataclass(frozen=True)
class Leftover:
    """Horizontal error at the end, m, of three gyros whose rates err by the same rms: steadily,
    signs as bad as may be; and at most, whatever the errors' course."""

    steady: float
    most: float


def leftover(weights: MissionWeights, rate: float) -> Leftover:
    """What rate errors of this rms, rad/s, from the alignment on, can do in a mission.

    The error is an integral of each rate error with a weight, so that by Cauchy and Schwarz it
    stays within the root of the product of both mean squares; the weight's is what a unit of angle
    random walk does.
    """
    bias = weights.gyros[-1, :, 0]
    steady = max(float(np.hypot(*(bias @ np.array(signs)))) for signs in product((1, -1), repeat=3))
    duration = STILL - SETTLING + float(weights.time[-1])
    largest = np.linalg.eigvalsh(weights.noise[WALK][:, -2:, -2:])[:, -1]
    most = math.sqrt(duration) * float(np.sqrt(np.maximum(largest, 0.0)).sum())
    return Leftover(rate * steady, rate * most)
