"""A self-test at power-on by virtual rotation, both ways in turn."""

import numpy as np

from pyhrg.common.arrays import Array
from pyhrg.common.units import DEG

ROTATION, HALF_PERIOD = 5 * DEG, 30.0
"""Virtual rotation, rad/s, and the time after which it changes its sign, s. Chosen."""
SELF_TEST = 2 * HALF_PERIOD
"""Duration of the self-test, s."""
SETTLING = 5.0
"""Time after the self-test before the alignment begins, s. Chosen."""


def rotate_virtually(since: Array, duration: float) -> Array:
    """Virtual rotation at times since power-on, s, as an input rate, rad/s."""
    return np.where(since < duration, ROTATION * np.sign(np.sin(np.pi * since / HALF_PERIOD)), 0.0)
