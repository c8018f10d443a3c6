"""Warming of a gyro's case and resonator after power-on (docs/methods/mission_model.md, Eq. 3).

The case approaches its final temperature with the time constant `CASE_WARM_UP`. The resonator
follows the case with `WARM_UP`. Both begin at the temperature of the calibration. Warmth is the
share, 0 to 1, of the final rise of temperature. Times are seconds since the alignment.
"""

import numpy as np

from ins_eval.mission_model.missions import CASE_WARM_UP, STILL, WARM_UP
from pyhrg.common.arrays import Array


def compute_case_warmth(time: Array) -> Array:
    return np.asarray(1 - np.exp(-(time + STILL) / CASE_WARM_UP))


def compute_case_warming_rate(time: Array) -> Array:
    """Rate of the case's warmth, 1/s."""
    return np.asarray(np.exp(-(time + STILL) / CASE_WARM_UP) / CASE_WARM_UP)


def compute_resonator_warmth(time: Array) -> Array:
    resonator, case = _compute_lags(time)
    return np.asarray(1 - (WARM_UP * resonator - CASE_WARM_UP * case) / (WARM_UP - CASE_WARM_UP))


def compute_resonator_warming_rate(time: Array) -> Array:
    """Rate of the resonator's warmth, 1/s."""
    resonator, case = _compute_lags(time)
    return np.asarray((resonator - case) / (WARM_UP - CASE_WARM_UP))


def _compute_lags(time: Array) -> tuple[Array, Array]:
    since = time + STILL
    return np.exp(-since / WARM_UP), np.exp(-since / CASE_WARM_UP)
