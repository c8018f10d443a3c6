"""The error of maps that are known, what aligning does beyond first order included."""

import numpy as np
from numpy.typing import NDArray

from ins_eval.study.flown import map_errors
from ins_eval.study.mission_weights import MissionWeights
from ins_eval.study.predictors.flown_maps import flown_weights
from ins_eval.study.standing import beyond_first_order

Array = NDArray[np.float64]


def expected_error(weights: MissionWeights, maps: Array) -> Array:
    """(r, k, 2) m.

    Args:
        weights: of the mission.
        maps: (r, COUNT, 3) in flight, as `flown_maps`.
    """
    standing = weights.standing
    aligning = np.concatenate([standing.started, standing.warming, standing.curving])
    rate = np.einsum("ca,rca->ra", aligning, maps)
    linear = map_errors(flown_weights(weights), maps)
    return linear + beyond_first_order(standing, rate, np.zeros_like(rate))
