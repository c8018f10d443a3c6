"""Shock pulses: their programme, and the change of the output angle that they cause."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from pyhrg.bench.outcome import BenchError
from pyhrg.bench.programme import Programme
from pyhrg.bench.readings.segments import FORCES
from pyhrg.common.arrays import Array
from pyhrg.common.site import Site
from pyhrg.common.units import STANDARD_GRAVITY
from pyhrg.records import Log

PEAK = 100 * STANDARD_GRAVITY
"""Largest specific force of a pulse, m/s2."""
DURATION = 6e-3
"""Duration of a pulse, a half sine, s."""
PAUSE = 2.0
"""Time between pulses, s."""
THRESHOLD = 1.0 * STANDARD_GRAVITY
"""Deviation of the specific force from its median, m/s2, above which there is a pulse."""
SETTLE, WINDOW = 0.5, 0.5
"""Time from the end of a pulse to the reading of the angle, and duration of that reading, s."""
QUIET = 20.0
"""Time before the first pulse in which the bias is measured, s."""


@dataclass(frozen=True)
class Pulse:
    """Response of the output angle to one pulse.

    Attributes:
        axis: axis of the pulse: x, y or z, after its sign.
        kept: lasting change of the angle, rad.
        swing: largest deviation of the angle until it is read, rad.
        valid: whether the output was valid throughout.
    """

    axis: str
    kept: float
    swing: float
    valid: bool


def add_pulses(course: Programme, axis: str, sign: float, count: int = 3) -> None:
    """Append half-sine pulses along an axis to a programme, as means over its rows."""
    name = f"acceleration_{axis}"
    steady = course.current(name)
    rows = max(1, int(np.ceil(DURATION / course.interval - 1e-9)))
    ends = np.minimum(np.arange(rows + 1) * course.interval, DURATION)
    swept = PEAK * DURATION / np.pi * (1 - np.cos(np.pi * ends / DURATION))
    for _ in range(count):
        for mean in np.diff(swept) / course.interval:
            course.command(**{name: steady + sign * float(mean)}).rest(course.interval)
        course.command(**{name: steady}).rest(PAUSE)


def find_pulses(log: Log, site: Site) -> list[Pulse]:
    """Responses to the pulses of a log, which its specific force shows."""
    force = _read_pulse_force(log)
    starts, ends = _find_bounds(log, force)
    angle = _remove_drift(log, site, starts[0])
    pairs = zip(starts.tolist(), ends.tolist(), strict=True)
    pulses = [_measure_pulse(log, force, angle, start, end) for start, end in pairs]
    return [pulse for pulse in pulses if pulse]


def read_quiet_changes(log: Log, site: Site) -> list[float]:
    """Changes of the angle, rad, read as `Pulse.kept` is but before the first pulse: a reference.

    The drift that is subtracted has an error that is common to all pulses. These readings have it
    too, so that the difference of the means is free of it.
    """
    starts, ends = _find_bounds(log, _read_pulse_force(log))
    angle = _remove_drift(log, site, starts[0])
    settle, window = (round(t / log.interval) for t in (SETTLE, WINDOW))
    later = window + settle + int(ends[0] - starts[0])
    first = starts[0] - round(QUIET / log.interval)
    begins = range(first, starts[0] - later - window + 1, later + window)
    change = angle[later:] - angle[:-later]
    return [float(np.mean(change[begin : begin + window])) for begin in begins]


def _read_pulse_force(log: Log) -> Array:
    """(n, 3) specific force less its median, m/s2."""
    force = np.column_stack([getattr(log, name) for name in FORCES])
    return np.asarray(force - np.nanmedian(force, axis=0))


def _find_bounds(log: Log, force: Array) -> tuple[NDArray[np.int64], NDArray[np.int64]]:
    """First and last row of each pulse."""
    shaken = np.max(np.abs(force), axis=1) > THRESHOLD
    starts = np.flatnonzero(shaken & ~np.append(False, shaken[:-1]))
    ends = np.flatnonzero(shaken & ~np.append(shaken[1:], False))
    if not len(starts) or log.interval > WINDOW / 4:
        raise BenchError(
            f"{log.source}: {len(starts)} pulses of specific force above {THRESHOLD:.3g} m/s2 in "
            f"rows of {log.interval:g} s; the shock test needs pulses, and rows of "
            f"{WINDOW / 4:g} s or less"
        )
    if starts[0] * log.interval < QUIET:
        raise BenchError(
            f"{log.source}: the first pulse comes after {starts[0] * log.interval:.3g} s; "
            f"{QUIET:g} s are needed before it to know the bias"
        )
    return starts, ends


def _remove_drift(log: Log, site: Site, first: int) -> Array:
    """(n,) output angle less Earth's rotation and the drift before the first pulse, rad."""
    angle = log.gyro_angle - np.cumsum(site.vertical_rate * log.axis_up) * log.interval
    quiet = slice(first - round(QUIET / log.interval), first)
    return np.asarray(angle - np.polyfit(log.time[quiet], angle[quiet], 1)[0] * log.time)


def _measure_pulse(log: Log, force: Array, angle: Array, start: int, end: int) -> Pulse | None:
    """Response to one pulse; None where the log begins or ends too close to it."""
    settle, window = (round(t / log.interval) for t in (SETTLE, WINDOW))
    before, after = slice(start - window, start), slice(end + settle, end + settle + window)
    if before.start < 0 or after.stop > len(angle):
        return None
    level = float(np.mean(angle[before]))
    shaken = force[start : end + 1]
    peak = np.unravel_index(np.argmax(np.abs(shaken)), shaken.shape)
    sign = "+" if shaken[peak] > 0 else "-"
    swing = float(np.max(np.abs(angle[start : after.start] - level)))
    kept = float(np.mean(angle[after])) - level
    valid = log.valid[start : after.stop]
    return Pulse(sign + "xyz"[int(peak[1])], kept, swing, not np.any(valid < 1))
