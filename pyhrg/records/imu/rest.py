"""Stretches at rest, by the specific force, and the rate at which Earth then turns the vehicle."""

import itertools

import numpy as np

from pyhrg.records.imu.log import Array

WINDOW_LENGTH = 30.0
"""Length of the windows in which rest is looked for, s. Chosen."""
MAX_REST_SPREAD = 0.05
"""Largest departure of the specific force, averaged over a second, from its mean at rest, m/s^2.
Chosen."""
REST_FORCE_RANGE = (9.74, 9.86)
"""Specific force at rest anywhere on Earth, accelerometer errors of 2 milli-g included, m/s^2; a
vehicle that turns steadily with a bank of 7 deg or more feels more."""
MIN_LEVEL_SHARE = 0.15
"""Smallest share of the rate that is horizontal at rest. Chosen: 0.15 is that of Earth's rate at 81
deg of latitude; a vehicle that turns steadily without bank has none."""


def average_blocks(values: Array, interval: float, length: float) -> Array:
    """Means (m, 3) of values (n, 3) over blocks of about a length, s, without an incomplete last
    block."""
    size = min(max(round(length / interval), 1), len(values))
    whole = len(values) // size * size
    return np.asarray(values[:whole].reshape(-1, size, values.shape[1]).mean(axis=1))


def estimate_rate_at_rest(rate: Array, force: Array, interval: float) -> float | None:
    """Median size of the mean rate in the first windows at rest, in the unit of the rate; None if
    there is no window at rest. Rate (n, 3) and specific force (n, 3), m/s^2, are means over
    intervals, s."""
    windows = zip(_split_windows(force, interval), _split_windows(rate, interval), strict=True)
    resting = itertools.dropwhile(lambda window: not _is_at_rest(*window), windows)
    first = itertools.takewhile(lambda window: _is_at_rest(*window), resting)
    sizes = [np.linalg.norm(rate.mean(axis=0)) for _, rate in first]
    return float(np.median(sizes)) if sizes else None


def _split_windows(values: Array, interval: float) -> list[Array]:
    """Means over a second, by window."""
    seconds, count = average_blocks(values, interval, 1.0), round(WINDOW_LENGTH)
    return [seconds[i : i + count] for i in range(0, len(seconds) - count + 1, count)]


def _is_at_rest(force: Array, rate: Array) -> bool:
    """Whether specific force (n, 3), m/s^2, is steady and gravity's, and the rate (n, 3) is not all
    about the vertical."""
    up, mean = force.mean(axis=0), rate.mean(axis=0)
    size = np.linalg.norm(up)
    steady = (
        np.max(np.abs(force - up)) < MAX_REST_SPREAD
        and REST_FORCE_RANGE[0] < size < REST_FORCE_RANGE[1]
    )
    level = mean - (mean @ up) / size**2 * up if steady else np.zeros(3)
    return bool(np.linalg.norm(level) > MIN_LEVEL_SHARE * np.linalg.norm(mean))
