"""Values under another unit, axis or column than a log says, told by gravity and Earth's rate."""

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from pyhrg.common.site import EARTH_RATE
from pyhrg.common.units import ARCSEC, DEG, MICRO_G, STANDARD_GRAVITY
from pyhrg.records.imu.columns import Quantity
from pyhrg.records.imu.log import Array, LogError
from pyhrg.records.imu.rest import WINDOW, means, rate_at_rest

BLOCK = 0.1
"""Time over which readings are averaged against noise, s: no vehicle turns far in it."""
TRAVELLING = (0.85, 1.4)
"""Specific force over gravity that half of all blocks must stay within to be one: turns add to it,
up to 45 deg of bank, more often than anything takes away."""
RESTING = (0.99, 1.01)
"""Likewise of the blocks of the first window, in which most vehicles rest."""
SWAPPED = 0.05
"""Most that accelerometers show, in the file's unit, if what they show is a rate."""
UPSIDE_DOWN = 0.8
"""Share of the specific force, downward along z, at which z is taken to be up."""
FASTEST = 100.0
"""Highest rate that is believed, rad/s."""
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

    @cached_property
    def down(self) -> float:
        """Median specific force downwards, in the file's unit."""
        return float(np.median(means(self.force, self.interval, BLOCK)[:, 2]))

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
    _check_earth_rate(readings)
    _check_fastest(readings)


def _near(sizes: Array, value: float, within: tuple[float, float]) -> bool:
    """Whether half of all sizes are about a value."""
    low, high = np.quantile(sizes, (0.25, 0.75))
    return bool(within[0] * value < low and high < within[1] * value)


def _check_swapped(readings: Readings) -> None:
    gravities = (STANDARD_GRAVITY, 1.0)
    felt = any(_is_gravity(readings.rate_size, g) for g in gravities)
    if felt and np.median(readings.force_size) < SWAPPED:
        raise readings.error(
            readings.gyros,
            f"{np.median(readings.rate_size):.3g} per second, "
            f"beside accelerometers of {np.median(readings.force_size):.3g}",
            "gravity on the accelerometers",
            "are gyros and accelerometers swapped",
        )


def _is_gravity(sizes: Array, gravity: float) -> bool:
    """Whether blocks show it, in the first window or in the whole log."""
    first = sizes[: round(WINDOW / BLOCK)]
    return _near(first, gravity, RESTING) or _near(sizes, gravity, TRAVELLING)


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
    guesses |= _sums(kind, gravity, readings.interval)
    fitting = [guess for guess, size in guesses.items() if _is_gravity(readings.force_size, size)]
    if fitting:
        found = f"a specific force of {np.median(readings.force_size[: round(WINDOW / BLOCK)]):.3g}"
        raise readings.error(kind, found, f"about {gravity:.3g} {stated}", ", or ".join(fitting))


def _check_down(readings: Readings) -> None:
    down = readings.down
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
    force = readings.accelerometers.factor * readings.force
    rate = rate_at_rest(readings.rate, force, readings.interval)
    if rate is None:
        return
    kind = readings.gyros
    own = EARTH_RATE / kind.factor
    given, stated = _angle_units(kind)
    small = "arcseconds" if kind.integral else "degrees per hour"
    sizes = {
        f"are {given}s given where {stated}s are meant": EARTH_RATE * kind.factor / DEG,
        f"are {small} given": EARTH_RATE / ARCSEC,
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
