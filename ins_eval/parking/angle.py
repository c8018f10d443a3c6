"""Where to park: pattern angles at which a bias map leaves least error while the pattern creeps.

A level gyro's pattern goes away from where it was parked by what the gyro measures: Earth's rate,
the vehicle's curvature, pitch and roll. So it is the map within that reach that counts, to both
sides, for the heading is not known at power-on.
"""

from collections.abc import Callable

import numpy as np

from pyhrg.common.arrays import Array
from pyhrg.common.units import DEG

BiasMap = Callable[[Array], Array]
"""Bias, rad/s, at pattern angles (...), rad; of period pi."""

REACH = 6.0 * DEG
"""Half width of the pattern angles about the parked one that count, rad. Chosen: Earth's level rate
turns the pattern by up to 6.4 deg in 2 h at latitude 40 deg, and 2 deg of pitch by 0.6 deg. Turns
with roll add to that, always one way."""
_CANDIDATES = np.arange(0.0, 180.0, 0.1) * DEG
_WITHIN = np.linspace(-REACH, REACH, 25)


def find_flattest_zero(bias: BiasMap) -> float:
    """Angle, rad, about which the bias differs least from its mean, for a gyro whose mean bias is
    calibrated: the map's flattest zero."""
    mean = float(np.mean(bias(_CANDIDATES)))
    return _find_least(bias(_within_reach()) - mean)


def find_flattest_extreme(bias: BiasMap) -> float:
    """Angle, rad, about which the bias varies least from its own value, for a gyro whose bias there
    is calibrated: the map's flattest extreme."""
    return _find_least(bias(_within_reach()) - bias(_CANDIDATES)[:, None])


def _within_reach() -> Array:
    return np.asarray(_CANDIDATES[:, None] + _WITHIN)


def _find_least(residual: Array) -> float:
    return float(_CANDIDATES[np.argmin(np.mean(residual**2, axis=1))])
