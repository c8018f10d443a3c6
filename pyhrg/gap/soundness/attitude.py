"""Specific force against gravity and attitude; temperature against the loop's frequency."""

import itertools

import numpy as np

from pyhrg.common.units import HZ
from pyhrg.gap.soundness.doubt import Array, Believed, Doubt, Witness, doubt, has
from pyhrg.records import Log

ACCELERATIONS = ("acceleration_x", "acceleration_y", "acceleration_z")
STANDING = (
    *("static", "positions", "rate", "ring_down", "virtual_rotation", "thermal", "amplitude"),
    *("phase_step", "tumble", "manoeuvre"),
)
"""Kinds of tests on a turntable, which feel gravity alone."""
SIZE = 0.05
"""Relative departure from gravity that no accelerometer has."""
TILT = 0.1
"""Departure of accel_z over gravity from axis_up that no mounting has, more than 5 deg."""
FEW = 0.1
"""Share of rows that may be off: vibration, a table on its way."""
DETUNED = 1e-3
"""Relative departure of the frequency that no effect makes."""
KNOWN = 0.3
"""Share by which a stated temperature coefficient of the frequency may be off."""
UNKNOWN = 2e-4
"""Temperature coefficient of the frequency where none is stated, 1/K."""


def doubts_of_attitude(log: Log, kind: str, believed: Believed) -> list[Doubt]:
    """Specific force that is no gravity, or that contradicts `axis_up`."""
    if kind not in STANDING or not has(log, *ACCELERATIONS):
        return []
    gravity = believed.site.gravity
    force = np.stack([getattr(log, field) for field in ACCELERATIONS])
    size = float(np.nanmedian(np.linalg.norm(force, axis=0)))
    if abs(size / gravity - 1) > SIZE:
        return [doubt(log, ACCELERATIONS, f"{size:.4g} m/s2 in all; expected {gravity:.4g}")]
    if not has(log, "axis_up") or _agrees(force[2] / gravity, log.axis_up):
        return []
    found = np.nanmedian(force[2])
    trouble = f"{found:.4g} m/s2 along z; expected axis_up times gravity, "
    trouble += f"{np.nanmedian(log.axis_up) * gravity:.4g}"
    guess = _guess(force / gravity, log.axis_up)
    if guess:
        return [doubt(log, ACCELERATIONS, f"{trouble}: {guess}?")]
    return [doubt(log, (*ACCELERATIONS, "axis_up"), trouble)]


def doubts_of_temperature(log: Log, believed: Believed) -> list[Doubt]:
    """A temperature that the loop's frequency, which stays where it should be, knows nothing of."""
    device = believed.device
    if not device.frequency_per_kelvin or not has(log, "temperature", "frequency_offset"):
        return []
    change = float(np.nanmedian(log.temperature)) - device.reference_temperature
    found = float(np.nanmedian(log.frequency_offset)) / device.frequency
    expected = device.frequency_per_kelvin * change
    if abs(found) > DETUNED or abs(found - expected) <= DETUNED + KNOWN * abs(expected):
        return []
    hertz = device.frequency / HZ
    trouble = f"{change:+.3g} K beside the reference, where the loop's frequency is off by "
    trouble += f"{found * hertz:.3g} Hz; expected {expected * hertz:.3g} Hz: is the unit degC?"
    return [doubt(log, ("temperature",), trouble)]


def witnesses_of_frequency(log: Log, believed: Believed) -> list[Witness]:
    """What the loop's frequency, less what the temperature explains, says of the nominal one."""
    if not has(log, "frequency_offset"):
        return []
    device = believed.device
    change = np.zeros(len(log.time))
    if has(log, "temperature"):
        change = log.temperature - device.reference_temperature
    stated = device.frequency_per_kelvin
    spread = KNOWN * abs(stated) if stated else UNKNOWN
    width = DETUNED + spread * float(np.nanmax(np.abs(change)))
    offset = float(np.nanmedian(log.frequency_offset / device.frequency - stated * change))
    hertz = device.frequency / HZ
    limits = hertz * (1 - width), hertz * (1 + width)
    found = hertz * (1 + offset)
    return [Witness("frequency_Hz", "frequency_offset", log.source, hertz, found, *limits)]


def _agrees(along: Array, axis_up: Array) -> bool:
    known = np.isfinite(along) & np.isfinite(axis_up)
    return bool(np.mean(np.abs(along - axis_up)[known] > TILT) < FEW) if known.any() else True


def _guess(force: Array, axis_up: Array) -> str:
    """Which other axis or sign agrees."""
    for axis, sign in itertools.product((2, 0, 1), (1, -1)):
        if _agrees(sign * force[axis], axis_up):
            swapped = "" if axis == 2 else f"are accel_{'xyz'[axis]} and accel_z swapped"
            turned = "is a sign reversed" if sign < 0 else ""
            return " and ".join(filter(None, (swapped, turned)))
    return ""
