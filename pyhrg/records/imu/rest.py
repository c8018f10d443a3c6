"""Where a vehicle rests, by its specific force, and how fast Earth then turns it."""

import itertools

import numpy as np

from pyhrg.records.imu.log import Array

WINDOW = 30.0
"""Length of the windows in which rest is looked for, s."""
REST_SPREAD = 0.05
"""Most that specific force, averaged over a second, may vary at rest, m/s^2."""
REST_FORCE = (9.74, 9.86)
"""Specific force at rest anywhere on Earth, accelerometer errors of 2 milli-g included, m/s^2; a
vehicle that turns steadily with a bank of 7 deg or more feels more."""
LEVEL_RATE = 0.15
"""Least share of the rate across the vertical at rest; 0.15 is 81 deg of latitude. A vehicle that
turns steadily without bank has none."""


def means(values: Array, interval: float, length: float) -> Array:
    """Means (m, 3) of values (n, 3) over blocks of about a length, s; the rest is left out."""
    size = min(max(round(length / interval), 1), len(values))
    whole = len(values) // size * size
    return np.asarray(values[:whole].reshape(-1, size, values.shape[1]).mean(axis=1))


def rate_at_rest(rate: Array, force: Array, interval: float) -> float | None:
    """Size of the mean rate in the first windows at rest, in the unit of the rate; None if the
    vehicle rests in none, or nothing tells.

    Args:
        rate: (n, 3) means over intervals, in any unit.
        force: (n, 3) specific force, likewise, m/s^2.
        interval: s.
    """
    windows = zip(_windows(force, interval), _windows(rate, interval), strict=True)
    resting = itertools.dropwhile(lambda window: not _rests(*window), windows)
    first = itertools.takewhile(lambda window: _rests(*window), resting)
    sizes = [np.linalg.norm(rate.mean(axis=0)) for _, rate in first]
    return float(np.median(sizes)) if sizes else None


def _windows(values: Array, interval: float) -> list[Array]:
    """Means over a second, in windows."""
    seconds, count = means(values, interval, 1.0), round(WINDOW)
    return [seconds[i : i + count] for i in range(0, len(seconds) - count + 1, count)]


def _rests(force: Array, rate: Array) -> bool:
    """Whether specific force (n, 3), m/s^2, is steady and Earth's, and the rate (n, 3) is not all
    about the vertical."""
    up, mean = force.mean(axis=0), rate.mean(axis=0)
    size = np.linalg.norm(up)
    steady = np.max(np.abs(force - up)) < REST_SPREAD and REST_FORCE[0] < size < REST_FORCE[1]
    level = mean - (mean @ up) / size**2 * up if steady else np.zeros(3)
    return bool(np.linalg.norm(level) > LEVEL_RATE * np.linalg.norm(mean))
