"""Checks of specific force against gravity and attitude, and of temperature against frequency."""

import itertools

import numpy as np

from pyhrg.common.arrays import Array
from pyhrg.common.units import HZ
from pyhrg.device.device import Device
from pyhrg.gap.soundness.exclusion import Exclusion, NominalEstimate, exclude_columns
from pyhrg.records import Log, LogError

ACCELERATIONS = ("acceleration_x", "acceleration_y", "acceleration_z")
TURNTABLE_KINDS = (
    *("static", "positions", "rate", "ring_down", "virtual_rotation", "thermal", "amplitude"),
    *("phase_step", "tumble", "manoeuvre"),
)
"""Kinds of tests on a turntable, where the specific force is gravity alone."""
GRAVITY_TOLERANCE = 0.05
"""Relative departure of specific force from gravity above which no accelerometer explains it.
Chosen."""
TILT_TOLERANCE = 0.1
"""Departure of accel_z over gravity from axis_up above which no mounting explains it. Chosen: more
than 5 deg."""
MAX_DEPARTING_SHARE = 0.1
"""Share of rows that may depart from axis_up, by vibration or a moving table. Chosen."""
FREQUENCY_TOLERANCE = 1e-2
"""Relative departure of the frequency above which the records are another gyro's. Chosen: ten times
the tolerance of a nominal frequency."""
TELLING_FREQUENCY_TOLERANCE = 3e-3
"""Relative departure of the frequency up to which it tells a wrong temperature. Chosen: three times
the tolerance of a nominal frequency."""
COEFFICIENT_TOLERANCE = 0.3
"""Relative error allowed in a stated temperature coefficient of the frequency. Chosen."""
UNSTATED_COEFFICIENT = 2e-4
"""Temperature coefficient of the frequency that is allowed for where none is stated, 1/K. Chosen:
about twice that of fused silica, 8.5e-5."""

MAX_UNSEEN_WARMING = 1.0
"""Change of temperature by the loop's frequency up to which a log without a temperature is taken
for one of a gyro at rest, K. Chosen."""
UNSEEN_SHARE = 0.01
"""Share of rows at either end of the frequency's range that may be wrong. Chosen."""


def check_attitude(log: Log, kind: str, nominal: Device) -> list[Exclusion]:
    """Exclude specific force that is not gravity, or that contradicts `axis_up`."""
    if kind not in TURNTABLE_KINDS or not log.has_values(*ACCELERATIONS):
        return []
    gravity = nominal.site.gravity
    force = np.stack([getattr(log, field) for field in ACCELERATIONS])
    size = float(np.nanmedian(np.linalg.norm(force, axis=0)))
    if abs(size / gravity - 1) > GRAVITY_TOLERANCE:
        trouble = f"{size:.4g} m/s2 in all; expected {gravity:.4g}"
        return [exclude_columns(log, ACCELERATIONS, trouble)]
    if not log.has_values("axis_up") or _agrees(force[2] / gravity, log.axis_up):
        return []
    along_z = np.nanmedian(force[2])
    trouble = f"{along_z:.4g} m/s2 along z; expected axis_up times gravity, "
    trouble += f"{np.nanmedian(log.axis_up) * gravity:.4g}"
    guess = _guess_mistake(force / gravity, log.axis_up)
    if guess:
        return [exclude_columns(log, ACCELERATIONS, f"{trouble}: {guess}?")]
    return [exclude_columns(log, (*ACCELERATIONS, "axis_up"), trouble)]


def check_temperature(log: Log, nominal: Device) -> list[Exclusion]:
    """Exclude a temperature that contradicts a loop frequency which is near its nominal value."""
    if not nominal.frequency_per_kelvin or not log.has_values("temperature", "frequency_offset"):
        return []
    change = float(np.nanmedian(log.temperature)) - nominal.reference_temperature
    offset = float(np.nanmedian(log.frequency_offset)) / nominal.frequency
    expected = nominal.frequency_per_kelvin * change
    allowed = TELLING_FREQUENCY_TOLERANCE + COEFFICIENT_TOLERANCE * abs(expected)
    if abs(offset) > TELLING_FREQUENCY_TOLERANCE or abs(offset - expected) <= allowed:
        return []
    hertz = nominal.frequency / HZ
    trouble = f"{change:+.3g} K from the reference, but the loop's frequency is off by "
    trouble += f"{offset * hertz:.3g} Hz; expected {expected * hertz:.3g} Hz: is the unit degC?"
    return [exclude_columns(log, ("temperature",), trouble)]


def require_steady_temperature(log: Log, nominal: Device) -> None:
    """Refuse a log without a temperature whose loop frequency shows that it changed.

    Raises:
        LogError: the frequency's range is that of more than `MAX_UNSEEN_WARMING`.
    """
    if log.has_values("temperature") or not nominal.frequency_per_kelvin:
        return
    if not log.has_values("frequency_offset"):
        return
    low, high = np.nanquantile(log.frequency_offset, (UNSEEN_SHARE, 1 - UNSEEN_SHARE))
    change = float(high - low) / nominal.frequency / abs(nominal.frequency_per_kelvin)
    if change > MAX_UNSEEN_WARMING:
        raise LogError(
            f"{log.source}: temperature_degC: missing, and the loop's frequency changes as over "
            f"{change:.3g} K; expected at most {MAX_UNSEEN_WARMING:g}"
        )


def estimate_frequency(log: Log, nominal: Device) -> list[NominalEstimate]:
    """Estimate of the nominal frequency: the loop's, without what the temperature explains."""
    if not log.has_values("frequency_offset"):
        return []
    change = np.zeros(len(log.time))
    if log.has_values("temperature"):
        change = log.temperature - nominal.reference_temperature
    stated = nominal.frequency_per_kelvin
    spread = COEFFICIENT_TOLERANCE * abs(stated) if stated else UNSTATED_COEFFICIENT
    width = FREQUENCY_TOLERANCE + spread * float(np.nanmax(np.abs(change)))
    offset = float(np.nanmedian(log.frequency_offset / nominal.frequency - stated * change))
    hertz = nominal.frequency / HZ
    values = (hertz, hertz * (1 + offset), hertz * (1 - width), hertz * (1 + width))
    return [NominalEstimate("frequency_Hz", "frequency_offset", log.source, *values)]


def _agrees(along: Array, axis_up: Array) -> bool:
    """Whether specific force along an axis, over gravity, agrees with `axis_up` in most rows."""
    known = np.isfinite(along) & np.isfinite(axis_up)
    if not known.any():
        return True
    departs = np.abs(along - axis_up)[known] > TILT_TOLERANCE
    return bool(np.mean(departs) < MAX_DEPARTING_SHARE)


def _guess_mistake(force: Array, axis_up: Array) -> str:
    """Which other axis or sign agrees, in words; empty where none does."""
    for axis, sign in itertools.product((2, 0, 1), (1, -1)):
        if _agrees(sign * force[axis], axis_up):
            swapped = "" if axis == 2 else f"are accel_{'xyz'[axis]} and accel_z swapped"
            turned = "is a sign reversed" if sign < 0 else ""
            return " and ".join(filter(None, (swapped, turned)))
    return ""
