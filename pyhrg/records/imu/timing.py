"""Times of an IMU's log: evenly spaced, each once."""

import numpy as np
from numpy.typing import NDArray

from pyhrg.records.imu.columns import TIME
from pyhrg.records.imu.log import make_field_error

MAX_JITTER = 0.01
"""Largest departure of a time step from the interval, relative. Chosen."""
MIN_INTERVAL, MAX_INTERVAL = 1e-4, 1.0
"""Shortest and longest interval, s. Chosen."""


def find_interval(source: str, time: NDArray[np.float64], first_row: int) -> float:
    """The sampling interval, s.

    Raises:
        LogError: time stands or runs back, there is a gap, steps are uneven, or the interval is out
            of range.
    """
    steps = np.diff(time)
    interval = float(np.median(steps))
    wrong = (steps <= 0) | (np.abs(steps - interval) > MAX_JITTER * interval)
    if wrong.any():
        i = int(np.argmax(wrong))
        trouble = _describe_step(float(steps[i]), interval)
        found = f"{time[i + 1]:.10g} after {time[i]:.10g}"
        raise make_field_error(source, first_row + i + 1, TIME, found, trouble)
    if not MIN_INTERVAL <= interval <= MAX_INTERVAL:
        expected = f"{MIN_INTERVAL:g} s to {MAX_INTERVAL:g} s"
        raise make_field_error(source, first_row + 1, TIME, f"steps of {interval:g} s", expected)
    return float(time[-1] - time[0]) / len(steps)


def _describe_step(step: float, interval: float) -> str:
    if step == 0:
        return "each time once"
    if step < 0:
        return "time to increase"
    if step > 1.5 * interval:
        return f"steps of {interval:.6g} s: are {round(step / interval) - 1} rows missing?"
    return f"steps of {interval:.6g} s, even to {MAX_JITTER:.0%}"
