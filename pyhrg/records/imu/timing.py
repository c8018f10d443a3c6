"""The times of a log: evenly spaced, each once."""

import numpy as np
from numpy.typing import NDArray

from pyhrg.records.imu.columns import TIME
from pyhrg.records.imu.log import log_error

JITTER = 0.01
"""Largest departure of a step from the interval, relative."""
SHORTEST, LONGEST = 1e-4, 1.0
"""Intervals that are taken, s."""


def interval_of(source: str, time: NDArray[np.float64], first_row: int) -> float:
    """The interval, s.

    Raises:
        LogError: time that stands or runs back, a gap, uneven steps, an interval out of range.
    """
    steps = np.diff(time)
    interval = float(np.median(steps))
    wrong = (steps <= 0) | (np.abs(steps - interval) > JITTER * interval)
    if wrong.any():
        i = int(np.argmax(wrong))
        trouble = _trouble(float(steps[i]), interval)
        found = f"{time[i + 1]:.10g} after {time[i]:.10g}"
        raise log_error(source, first_row + i + 1, TIME, found, trouble)
    if not SHORTEST <= interval <= LONGEST:
        expected = f"{SHORTEST:g} s to {LONGEST:g} s"
        raise log_error(source, first_row + 1, TIME, f"steps of {interval:g} s", expected)
    return float(time[-1] - time[0]) / len(steps)


def _trouble(step: float, interval: float) -> str:
    if step == 0:
        return "each time once"
    if step < 0:
        return "time to increase"
    if step > 1.5 * interval:
        return f"steps of {interval:.6g} s: are {round(step / interval) - 1} rows missing?"
    return f"steps of {interval:.6g} s, even to {JITTER:.0%}"
