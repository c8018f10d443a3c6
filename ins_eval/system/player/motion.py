"""The file that the trajectory's FMU plays: the motion of a vehicle, sampled."""

import numpy as np

from ins_eval.navigation.height import Clamped
from pyhrg.common.arrays import Array
from pyhrg.records.imu.log import Increments

MAGIC = b"HRGPATH1"
"""The first bytes of the file; the number is that of its format."""
SAMPLES = 2
"""Increments a step of the navigator's FMU."""


def format_motion(increments: Increments, heights: Array) -> bytes:
    """Content of the file, as `trajectory.c` reads it.

    increments: ideal ones, n; heights: (n + 1,) above the ellipsoid at their bounds, m. The climb
    rate is that of the navigator's clamped height, straight within its steps.
    """
    interval, count = increments.interval, len(increments)
    channel = Clamped(heights).make_channel(count, SAMPLES, interval)
    bounds = np.arange(count + 1.0)
    rows = np.zeros((count + 1, 8))
    rows[:-1, :3] = increments.rotation / interval
    rows[:-1, 3:6] = increments.velocity / interval
    rows[:, 6] = heights
    rows[:, 7] = np.interp(bounds, bounds[::SAMPLES], channel.climb)
    return MAGIC + np.array([interval, count], "<f8").tobytes() + rows.astype("<f8").tobytes()
