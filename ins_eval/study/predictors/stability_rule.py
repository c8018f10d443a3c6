"""Predictors (1) and (2): a bias stability, and the rule that 0.01 deg/h makes 1 nmi/h (Eqs. 1, 2).

The rule knows neither the gyro's map nor the mission. Its distance is taken as the median of a
circular normal distribution, the circular error probable.
"""

import numpy as np

from ins_eval.study.predictors.prediction import NormalPrediction
from pyhrg.common.arrays import Array
from pyhrg.common.units import DEG_PER_H, HOUR, NAUTICAL_MILE

DRIFT_PER_STABILITY = (NAUTICAL_MILE / HOUR) / (0.01 * DEG_PER_H)
"""Drift of the position per bias stability, m/s per rad/s."""
_CIRCULAR_MEDIAN = np.sqrt(2 * np.log(2))
"""Median distance from zero of a circular normal distribution with unit standard deviation."""


def compute_rule_distance(stability: Array, time: Array) -> Array:
    """(r, k) distance that the rule makes of stabilities (r, 3), rad/s, at times (k,), s; m."""
    triad = np.sqrt(np.mean(np.square(stability), axis=1))
    return np.asarray(DRIFT_PER_STABILITY * triad[:, None] * time)


def predict(stability: Array, time: Array) -> NormalPrediction:
    """Errors of triads, by a circular normal distribution about zero.

    Args:
        stability: (r, 3) bias stabilities of the fixed-position or the full-circumference test,
            rad/s; the rms of the three is the triad's.
        time: (k,) s since alignment.
    """
    sigma = compute_rule_distance(stability, time) / _CIRCULAR_MEDIAN
    covariance = sigma[..., None, None] ** 2 * np.eye(2)
    return NormalPrediction(np.zeros((*sigma.shape, 2)), covariance)
