"""Predictors (1) and (2): a bias stability and the rule that 0.01 deg/h is 1 nmi/h.

The rule knows neither the device's map nor the manoeuvre. Its distance counts as the median of a
circular distribution, the usual circular error probable.
"""

import numpy as np
from numpy.typing import NDArray

from ins_eval.study.predictors.prediction import Normal
from pyhrg.common.units import DEG_PER_H, HOUR, NAUTICAL_MILE

Array = NDArray[np.float64]

RULE = (NAUTICAL_MILE / HOUR) / (0.01 * DEG_PER_H)
"""Drift of the position per bias stability, m/s per rad/s."""
_MEDIAN = np.sqrt(2 * np.log(2))
"""Median radius of a circular normal pair of standard deviation 1."""


def predict(stability: Array, time: Array) -> Normal:
    """Of triads.

    Args:
        stability: (r, 3) rad/s, of the fixed-position or the full-circumference test; a triad
            counts with the root mean square of its three.
        time: (k,) s since alignment.
    """
    triad = np.sqrt(np.mean(np.square(stability), axis=1))
    sigma = RULE * triad[:, None] * time / _MEDIAN
    covariance = sigma[..., None, None] ** 2 * np.eye(2)
    return Normal(np.zeros((*sigma.shape, 2)), covariance)
