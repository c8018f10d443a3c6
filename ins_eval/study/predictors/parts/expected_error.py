"""The error of known maps, with the second-order error of the alignment (Eq. 4)."""

import numpy as np

from ins_eval.mission_model.alignment_at_rest import compute_second_order_error
from ins_eval.mission_model.mission_weights import MissionWeights
from ins_eval.mission_model.position_errors import compute_map_errors
from pyhrg.common.arrays import Array


def compute_expected_error(weights: MissionWeights, maps: Array) -> Array:
    """(r, k, 2) expected error, m.

    Args:
        weights: weights of the mission.
        maps: (r, COUNT, 3) coefficients in flight.
    """
    alignment = weights.alignment
    rate = np.einsum("ca,rca->ra", alignment.rates, maps)
    linear = compute_map_errors(weights.maps, maps)
    return linear + compute_second_order_error(alignment, rate, np.zeros_like(rate))
