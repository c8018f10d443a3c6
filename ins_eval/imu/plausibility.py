"""Values under another unit, axis or column than a log says, told by gravity and Earth's rate."""

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from ins_eval import earth
from ins_eval.imu.columns import Quantity
from ins_eval.imu.log import Array, LogError
from pyhrg.units import ARCSEC, DEG, MICRO_G, STANDARD_GRAVITY

BLOCK = 0.1
"""Time over which readings are averaged against noise, s: no vehicle turns far in it."""
NEAR_GRAVITY = 0.2
"""Relative distance from a mistaken gravity that half of all blocks must stay within."""
UPSIDE_DOWN = 0.8
"""Share of the specific force, downward along z, at which z is taken to be up."""
FASTEST = 100.0
"""Highest rate that is believed, rad/s."""
REST = 30.0
"""Length of the windows in which rest is looked for, s."""
REST_SPREAD = 0.05
"""Most that specific force, averaged over a second, may vary at rest, m/s^2."""
REST_FORCE = (9.74, 9.86)
"""Specific force at rest anywhere on Earth, accelerometer errors of 2 milli-g included, m/s^2; a
vehicle that turns steadily with a bank of 7 deg or more feels more."""
LEVEL_RATE = 0.15
"""Least share of the rate across the vertical at rest; 0.15 is 81 deg of latitude. A vehicle that
turns steadily without bank has none."""
NEAR_EARTH = 0.05
"""Relative distance from a mistaken Earth's rate."""


@dataclass(frozen=True)
class Readings:
    """What gyros and accelerometers show, as means over intervals in the file's units.

    source: the file; interval: s; gyros, accelerometers: what the columns are said to be;
    rate, force: (n, 3) in the file's unit, an increment's over s; body axes forward, right, down;
    z: where the file's own z axis points.
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
        """Of each block, in the file's unit."""
        return np.linalg.norm(means(self.rate, self.interval, BLOCK), axis=1)

    @cached_property
    def force_size(self) -> Array:
        """Likewise."""
        return np.linalg.norm(means(self.force, self.interval, BLOCK), axis=1)

    def error(self, quantity: Quantity, found: str, expected: str, guess: str) -> LogError:
        """What is wrong with three columns."""
        return LogError(
            f"{self.source}: column {quantity.column('x')} and its like: found {found}, "
            f"expected {expected}: {guess}?"
        )


def check(readings: Readings) -> None:
    """Refuse a log that only a mix-up explains.

    Raises:
        LogError: it names the mix-up.
    """
    _check_swapped(readings)
    _check_gravity(readings)
    _check_down(readings)
    _check_fastest(readings)
    _check_earth_rate(readings)


def means(values: Array, interval: float, length: float) -> Array:
    """Means (m, 3) of values (n, 3) over blocks of about a length, s; the rest is left out."""
    size = min(max(round(length / interval), 1), len(values))
    whole = len(values) // size * size
    return np.asarray(values[:whole].reshape(-1, size, values.shape[1]).mean(axis=1))


def _near(sizes: Array, value: float, tolerance: float) -> bool:
    """Whether half of all sizes are about a value."""
    low, high = np.quantile(sizes, (0.25, 0.75))
    return bool(value * (1 - tolerance) < low and high < value * (1 + tolerance))


def _check_swapped(readings: Readings) -> None:
    gravities = (STANDARD_GRAVITY, 1.0)
    felt = any(_near(readings.rate_size, g, NEAR_EARTH) for g in gravities)
    if felt and np.median(readings.force_size) < 0.05:
        raise readings.error(
            readings.gyros,
            f"{np.median(readings.rate_size):.3g} per second, "
            f"beside accelerometers of {np.median(readings.force_size):.3g}",
            "gravity on the accelerometers",
            "are gyros and accelerometers swapped",
        )


def _check_gravity(readings: Readings) -> None:
    kind, interval = readings.accelerometers, readings.interval
    gravity = STANDARD_GRAVITY / kind.factor
    if _near(readings.force_size, gravity, NEAR_GRAVITY):
        return
    stated = {1.0: "m/s2", STANDARD_GRAVITY: "g"}[kind.factor]
    units = {"m/s2": 1.0, "g": STANDARD_GRAVITY, "milli-g": 1e3 * MICRO_G, "micro-g": MICRO_G}
    guesses = {
        f"is {unit} given where {stated} is meant": STANDARD_GRAVITY / factor
        for unit, factor in units.items()
    }
    guesses |= _sums(kind, gravity, interval)
    fitting = [g for g, size in guesses.items() if _near(readings.force_size, size, NEAR_GRAVITY)]
    if fitting:
        found = f"a specific force of {np.median(readings.force_size):.3g}"
        raise readings.error(kind, found, f"about {gravity:.3g} {stated}", ", or ".join(fitting))


def _check_down(readings: Readings) -> None:
    down = np.median(means(readings.force, readings.interval, BLOCK)[:, 2])
    if down > UPSIDE_DOWN * STANDARD_GRAVITY / readings.accelerometers.factor:
        other = "up" if readings.z == "down" else "down"
        raise readings.error(
            readings.accelerometers,
            f"a specific force of {down:.3g} downwards",
            "one upwards, as the ground pushes up",
            f"is z {other} where {readings.z} is meant, or the sign reversed",
        )


def _check_fastest(readings: Readings) -> None:
    fastest = float(np.max(readings.rate_size)) * readings.gyros.factor
    if fastest > FASTEST:
        given, _ = _angle_units(readings.gyros)
        raise readings.error(
            readings.gyros,
            f"a rate of {fastest:.3g} rad/s",
            f"at most {FASTEST:g} rad/s",
            "are "
            + (f"{given}s given where radians are meant" if given == "degree" else "units right")
            + (", or rates where increments are meant" if readings.gyros.integral else ""),
        )


def _check_earth_rate(readings: Readings) -> None:
    rate = _rate_at_rest(readings)
    if rate is None:
        return
    kind = readings.gyros
    own = earth.RATE / kind.factor
    given, stated = _angle_units(kind)
    small = "arcseconds" if kind.integral else "degrees per hour"
    sizes = {
        f"are {given}s given where {stated}s are meant": earth.RATE * kind.factor / DEG,
        f"are {small} given": earth.RATE / ARCSEC,
    }
    sizes |= _sums(kind, own, readings.interval)
    fitting = [guess for guess, size in sizes.items() if abs(rate / size - 1) < NEAR_EARTH]
    if fitting:
        found = f"a rate of {rate:.3g} {stated}s per second at rest"
        raise readings.error(kind, found, f"Earth's, {own:.3g}", ", or ".join(fitting))


def _sums(kind: Quantity, size: float, interval: float) -> dict[str, float]:
    """What a steady size looks like when increments and rates are mixed up."""
    if kind.integral:
        return {"are rates given where increments are meant": size / interval}
    return {"are increments given where rates are meant": size * interval}


def _angle_units(kind: Quantity) -> tuple[str, str]:
    """Taken for it by mistake, and as stated."""
    return ("degree", "radian") if kind.factor == 1.0 else ("radian", "degree")


def _rate_at_rest(readings: Readings) -> float | None:
    """Size of the mean rate at rest, in the file's unit; None where that isn't certain."""
    force = readings.accelerometers.factor * means(readings.force, readings.interval, 1.0)
    rate = means(readings.rate, readings.interval, 1.0)
    count = round(REST)
    sizes = []
    for first in range(0, len(force) - count + 1, count):
        window = slice(first, first + count)
        up = force[window].mean(axis=0)
        spread = np.max(np.abs(force[window] - up))
        size = np.linalg.norm(up)
        mean = rate[window].mean(axis=0)
        level = mean - (mean @ up) / size**2 * up
        still = spread < REST_SPREAD and REST_FORCE[0] < size < REST_FORCE[1]
        if still and np.linalg.norm(level) > LEVEL_RATE * np.linalg.norm(mean):
            sizes.append(np.linalg.norm(mean))
    return float(np.median(sizes)) if sizes else None
