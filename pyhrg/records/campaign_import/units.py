"""Units that a laboratory may log in, by quantity, as factors and offsets to SI.

A table of our own: in the general libraries Hz is 1/s, a radian is 1, and mg is a mass, so that a
wrong unit of a gyro's log would pass.
"""

from dataclasses import dataclass

from pyhrg.common.units import ARCSEC, DEG, HOUR, HZ, MINUTE, PPM, STANDARD_GRAVITY, ZERO_CELSIUS


@dataclass(frozen=True)
class Unit:
    """A unit: SI value = factor * value + offset."""

    factor: float
    offset: float = 0.0


PLAIN = Unit(1.0)
TURN = 360 * DEG
FAHRENHEIT = 5 / 9

ANGLE = {
    "rad": Unit(1.0),
    "mrad": Unit(1e-3),
    "urad": Unit(1e-6),
    "deg": Unit(DEG),
    "arcmin": Unit(DEG / 60),
    "arcsec": Unit(ARCSEC),
    "gon": Unit(TURN / 400),
    "turn": Unit(TURN),
}
DURATION = {
    "s": Unit(1.0),
    "ms": Unit(1e-3),
    "us": Unit(1e-6),
    "min": Unit(MINUTE),
    "h": Unit(HOUR),
}
RATE = {
    f"{angle}/{time}": Unit(ANGLE[angle].factor / DURATION[time].factor)
    for angle in ANGLE
    for time in ("s", "min", "h")
} | {"rpm": Unit(TURN / MINUTE)}
ACCELERATION = {
    "m/s2": Unit(1.0),
    "g": Unit(STANDARD_GRAVITY),
    "mg": Unit(1e-3 * STANDARD_GRAVITY),
    "ug": Unit(1e-6 * STANDARD_GRAVITY),
}
TEMPERATURE = {
    "degC": Unit(1.0, ZERO_CELSIUS),
    "K": Unit(1.0),
    "degF": Unit(FAHRENHEIT, ZERO_CELSIUS - 32 * FAHRENHEIT),
}
GROWTH_RATE = {f"1/{time}": Unit(1 / unit.factor) for time, unit in DURATION.items()}
FREQUENCY = {"mHz": Unit(1e-3 * HZ), "Hz": Unit(HZ), "kHz": Unit(1e3 * HZ), "rad/s": Unit(1.0)}
RATIO = {"1": Unit(1.0), "%": Unit(0.01), "ppm": Unit(PPM)}

BY_COLUMN_UNIT = {
    "s": DURATION,
    "deg": ANGLE,
    "rad": ANGLE,
    "deg_s": RATE,
    "m_s2": ACCELERATION,
    "degC": TEMPERATURE,
    "per_s": GROWTH_RATE,
    "Hz": FREQUENCY,
    "": RATIO,
}
"""Units by name that a column of a campaign may be logged in, by the column's own unit."""
