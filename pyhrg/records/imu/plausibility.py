"""Finds values in another unit, axis or column than a log says, by gravity and Earth's rate."""

import itertools
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from pyhrg.common.arrays import Array
from pyhrg.common.site import EARTH_RATE
from pyhrg.common.units import ARCSEC, DEG, MICRO_G, STANDARD_GRAVITY
from pyhrg.records.columns import LogError
from pyhrg.records.imu.log import Quantity

BLOCK_LENGTH = 0.1
"""Length of the blocks over which readings are averaged, s. Chosen: no vehicle turns far in it."""
MOVING_FORCE_RANGE = (0.85, 1.4)
"""Range of the ratio to gravity in which half of all blocks must lie for readings to be specific
force. Chosen: turns of up to 45 deg of bank add to it."""
RESTING_FORCE_RANGE = (0.99, 1.01)
"""The like range for the blocks of the first window, in which most vehicles rest. Chosen."""
MAX_SWAPPED_READING = 0.05
"""Largest median reading of accelerometers, in the file's unit, that may be a rate. Chosen."""
MIN_UPSIDE_DOWN_SHARE = 0.8
"""Smallest ratio to gravity of the specific force along z at which z must point up. Chosen."""
MAX_RATE = 100.0
"""Largest rate of a vehicle, rad/s. Chosen."""
EARTH_RATE_TOLERANCE = 0.05
"""Largest relative distance from Earth's rate in a mistaken unit. Chosen."""
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


@dataclass(frozen=True)
class Readings:
    """Readings of gyros and accelerometers, as means over intervals in the file's units.

    Attributes:
        source: the file.
        interval: s.
        gyros, accelerometers: quantities that the file states.
        rate, force: (n, 3) in the file's unit, an increment's over s; body axes forward, right,
            down.
        z: direction of the file's own z axis.
    """

    source: str
    interval: float
    gyros: Quantity
    accelerometers: Quantity
    rate: Array
    force: Array
    z: str = "down"

    @cached_property
    def rate_size(self) -> Array:
        """(m,) size of the rate in each block, in the file's unit."""
        return np.linalg.norm(_average_blocks(self.rate, self.interval, BLOCK_LENGTH), axis=1)

    @cached_property
    def force_size(self) -> Array:
        """(m,) size of the specific force in each block, in the file's unit."""
        return np.linalg.norm(_average_blocks(self.force, self.interval, BLOCK_LENGTH), axis=1)

    def error(self, quantity: Quantity, found: str, expected: str, guess: str) -> LogError:
        """Make the error about the three columns of a quantity."""
        return LogError(
            f"{self.source}: column {quantity.column('x')} and its like: found {found}, "
            f"expected {expected}: {guess}?"
        )


def check_plausibility(readings: Readings) -> None:
    """Refuse a log whose readings only a mix-up explains."""
    _check_swapped(readings)
    _check_gravity(readings)
    _check_down(readings)
    _check_earth_rate(readings)
    _check_largest_rate(readings)


def _is_near(sizes: Array, value: float, within: tuple[float, float]) -> bool:
    """Whether the middle half of all sizes lies in a range of ratios to a value."""
    low, high = np.quantile(sizes, (0.25, 0.75))
    return bool(within[0] * value < low and high < within[1] * value)


def _check_swapped(readings: Readings) -> None:
    gravities = (STANDARD_GRAVITY, 1.0)
    felt = any(_is_gravity(readings.rate_size, g) for g in gravities)
    if felt and np.median(readings.force_size) < MAX_SWAPPED_READING:
        raise readings.error(
            readings.gyros,
            f"{np.median(readings.rate_size):.3g} per second, "
            f"beside accelerometers of {np.median(readings.force_size):.3g}",
            "gravity on the accelerometers",
            "are gyros and accelerometers swapped",
        )


def _is_gravity(sizes: Array, gravity: float) -> bool:
    """Whether blocks show gravity, in the first window or in the whole log."""
    first = sizes[: round(WINDOW_LENGTH / BLOCK_LENGTH)]
    ranges = ((first, RESTING_FORCE_RANGE), (sizes, MOVING_FORCE_RANGE))
    return any(_is_near(some, gravity, within) for some, within in ranges)


def _check_gravity(readings: Readings) -> None:
    kind = readings.accelerometers
    gravity = STANDARD_GRAVITY / kind.factor
    if _is_gravity(readings.force_size, gravity):
        return
    stated = {1.0: "m/s2", STANDARD_GRAVITY: "g"}[kind.factor]
    if not readings.force.any():
        guess = "are the accelerometers switched off"
        raise readings.error(kind, "nothing but 0", f"about {gravity:.3g} {stated}", guess)
    units = {"m/s2": 1.0, "g": STANDARD_GRAVITY, "milli-g": 1e3 * MICRO_G, "micro-g": MICRO_G}
    guesses = {
        f"is {unit} given where {stated} is meant": STANDARD_GRAVITY / factor
        for unit, factor in units.items()
    }
    guesses |= _list_mixups(kind, gravity, readings.interval)
    fitting = [guess for guess, size in guesses.items() if _is_gravity(readings.force_size, size)]
    if fitting:
        first = readings.force_size[: round(WINDOW_LENGTH / BLOCK_LENGTH)]
        found = f"a specific force of {np.median(first):.3g}"
        raise readings.error(kind, found, f"about {gravity:.3g} {stated}", ", or ".join(fitting))


def _check_down(readings: Readings) -> None:
    blocks = _average_blocks(readings.force, readings.interval, BLOCK_LENGTH)
    down = float(np.median(blocks[:, 2]))
    if down > MIN_UPSIDE_DOWN_SHARE * STANDARD_GRAVITY / readings.accelerometers.factor:
        other = "up" if readings.z == "down" else "down"
        raise readings.error(
            readings.accelerometers,
            f"a specific force of {down:.3g} downwards",
            "one upwards, as the ground pushes up",
            f"is z {other} where {readings.z} is meant, or the sign reversed",
        )


def _check_largest_rate(readings: Readings) -> None:
    fastest = float(np.max(readings.rate_size)) * readings.gyros.factor
    if fastest > MAX_RATE:
        given, _ = _name_angle_units(readings.gyros)
        raise readings.error(
            readings.gyros,
            f"a rate of {fastest:.3g} rad/s",
            f"at most {MAX_RATE:g} rad/s",
            "are "
            + (f"{given}s given where radians are meant" if given == "degree" else "units right")
            + (", or rates where increments are meant" if readings.gyros.integral else ""),
        )


def _check_earth_rate(readings: Readings) -> None:
    force = readings.accelerometers.factor * readings.force
    rate = _estimate_rate_at_rest(readings.rate, force, readings.interval)
    if rate is None:
        return
    kind = readings.gyros
    own = EARTH_RATE / kind.factor
    given, stated = _name_angle_units(kind)
    small = "arcseconds" if kind.integral else "degrees per hour"
    sizes = {
        f"are {given}s given where {stated}s are meant": EARTH_RATE * kind.factor / DEG,
        f"are {small} given": EARTH_RATE / ARCSEC,
    }
    sizes |= _list_mixups(kind, own, readings.interval)
    fitting = [g for g, size in sizes.items() if abs(rate / size - 1) < EARTH_RATE_TOLERANCE]
    if fitting:
        found = f"a rate of {rate:.3g} {stated}s per second at rest"
        raise readings.error(kind, found, f"Earth's, {own:.3g}", ", or ".join(fitting))


def _list_mixups(kind: Quantity, size: float, interval: float) -> dict[str, float]:
    """Size that a steady reading has when increments and rates are mixed up, by the mix-up."""
    if kind.integral:
        return {"are rates given where increments are meant": size / interval}
    return {"are increments given where rates are meant": size * interval}


def _name_angle_units(kind: Quantity) -> tuple[str, str]:
    """Names of the mistaken and the stated unit of angles."""
    return ("degree", "radian") if kind.factor == 1.0 else ("radian", "degree")


def _average_blocks(values: Array, interval: float, length: float) -> Array:
    """Means (m, 3) of values (n, 3) over blocks of about a length, s, without an incomplete last
    block."""
    size = min(max(round(length / interval), 1), len(values))
    whole = len(values) // size * size
    return np.asarray(values[:whole].reshape(-1, size, values.shape[1]).mean(axis=1))


def _estimate_rate_at_rest(rate: Array, force: Array, interval: float) -> float | None:
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
    seconds, count = _average_blocks(values, interval, 1.0), round(WINDOW_LENGTH)
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
