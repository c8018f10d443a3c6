"""The error of maps that are known, what aligning does beyond first order included."""

import numpy as np
from numpy.typing import NDArray

from ins_eval.mission_model.flown import map_errors
from ins_eval.mission_model.mission_weights import MissionWeights
from ins_eval.mission_model.standing import beyond_first_order

Array = NDArray[np.float64]


def expected_error(weights: MissionWeights, maps: Array) -> Array:
    """(r, k, 2) m.

    Args:
        weights: of the mission.
        maps: (r, COUNT, 3) in flight.
    """
    standing = weights.standing
    rate = np.einsum("ca,rca->ra", standing.rates, maps)
    linear = map_errors(weights.maps, maps)
    return linear + beyond_first_order(standing, rate, np.zeros_like(rate))
