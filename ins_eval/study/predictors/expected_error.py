"""The error of maps that are known, what aligning does beyond first order included."""

import numpy as np
from numpy.typing import NDArray

from ins_eval.study.flown import map_errors
from ins_eval.study.mission_weights import MissionWeights
from ins_eval.study.standing import beyond_first_order

Array = NDArray[np.float64]


def expected_error(weights: MissionWeights, started: Array, warming: Array) -> Array:
    """(r, k, 2) m.

    Args:
        weights: of the mission.
        started: (r, 2 TERMS, 3) maps from the power-on angles.
        warming: (r, 2 TERMS, 3) what they gain as the gyros warm.
    """
    linear = map_errors(weights.gyros, started) + map_errors(weights.warming, warming)
    standing = weights.standing
    rate = np.einsum("ca,rca->ra", standing.started, started)
    rate += np.einsum("ca,rca->ra", standing.warming, warming)
    return linear + beyond_first_order(standing, rate, np.zeros_like(rate))
