"""How a gyro's case and resonator warm after power-on.

The case approaches its final temperature with `CASE_WARM_UP`, the resonator the case with
`WARM_UP`; both begin at the temperature of the calibration.
"""

import numpy as np
from numpy.typing import NDArray

from ins_eval.mission_model.missions import CASE_WARM_UP, STILL, WARM_UP

Array = NDArray[np.float64]


def case_warmth(time: Array) -> Array:
    """How far the case has warmed since power-on, 0 to 1; time: s since alignment."""
    return np.asarray(1 - np.exp(-(time + STILL) / CASE_WARM_UP))


def heating(time: Array) -> Array:
    """Rate of that, 1/s."""
    return np.asarray(np.exp(-(time + STILL) / CASE_WARM_UP) / CASE_WARM_UP)


def warmth(time: Array) -> Array:
    """How far the resonator has warmed, 0 to 1."""
    resonator, case = _left(time)
    return np.asarray(1 - (WARM_UP * resonator - CASE_WARM_UP * case) / (WARM_UP - CASE_WARM_UP))


def growth(time: Array) -> Array:
    """Rate of that, 1/s."""
    resonator, case = _left(time)
    return np.asarray((resonator - case) / (WARM_UP - CASE_WARM_UP))


def _left(time: Array) -> tuple[Array, Array]:
    since = time + STILL
    return np.exp(-since / WARM_UP), np.exp(-since / CASE_WARM_UP)
