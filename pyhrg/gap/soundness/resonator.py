"""Amplitude and its force against set point and decay time."""

import math

import numpy as np
from numpy.typing import NDArray

from pyhrg.gap.soundness.doubt import Array, Believed, Doubt, Witness, doubt, has
from pyhrg.records import Log

OFF_SETPOINT = 0.1
"""Relative departure of the amplitude, in the median, that a loop at work does not have."""
DECAY = 0.2
"""Relative departure from the nominal decay time that no effect makes near the reference
temperature."""
NEAR = 10.0
"""Of the reference temperature, K."""
LEAST_RING_DOWN = 50.0
"""Duration, s."""


def doubts_of_amplitude(log: Log) -> list[Doubt]:
    """An amplitude that is elsewhere than its set point."""
    driven = (log.drive_on == 1) & (log.amplitude_setpoint > 0)
    if not has(log, "amplitude") or not np.isfinite(log.amplitude[driven]).any():
        return []
    share = float(np.nanmedian(log.amplitude[driven] / log.amplitude_setpoint[driven]))
    if abs(share - 1) <= OFF_SETPOINT:
        return []
    return [doubt(log, ("amplitude",), f"{share:.4g} of amplitude_setpoint; expected about 1")]


def doubts_of_swapped_forces(log: Log, believed: Believed) -> list[Doubt]:
    """Amplitude and quadrature forces under each other's name."""
    pair = ("amplitude_force", "quadrature_force")
    low, high = _decay_times(believed)
    found, other = (_decay_time(getattr(log, field), log, believed) for field in pair)
    if low <= found <= high or not low <= other <= high:
        return []
    trouble = f"the second holds 1/{other:.4g} s, the decay: are they swapped?"
    return [doubt(log, pair, trouble)]


def witnesses_of_decay_time(log: Log, believed: Believed) -> list[Witness]:
    """What the amplitude's force, and its decay without, say of the nominal decay time."""
    witnesses = []
    found = _decay_time(log.amplitude_force, log, believed)
    if math.isfinite(found):
        limits = _decay_times(believed)
        values = (believed.device.decay_time, found, *limits)
        witnesses.append(Witness("decay_time_s", "amplitude_force", log.source, *values))
    return witnesses + _ring_down(log, believed)


def _decay_times(believed: Believed) -> tuple[float, float]:
    nominal = believed.device.decay_time
    return nominal * (1 - DECAY), nominal * (1 + DECAY)


def _decay_time(force: Array, log: Log, believed: Believed) -> float:
    """At the reference temperature, s; NaN where it can't be told."""
    device = believed.device
    change = log.temperature - device.reference_temperature
    chosen = (log.drive_on == 1) & (np.abs(change) < NEAR) & np.isfinite(force)
    if not chosen.any():
        return math.nan
    rates = force[chosen] * (1 + device.decay_time_per_kelvin * change[chosen])
    median = float(np.median(rates))
    return 1 / median if median else math.inf


def _ring_down(log: Log, believed: Believed) -> list[Witness]:
    """Energy decays by the decay time alone; a split may hide up to half of it as quadrature."""
    rows = _longest(log.drive_on == 0)
    amplitude = log.amplitude[rows]
    time = log.time[rows][np.isfinite(amplitude)]
    amplitude = amplitude[np.isfinite(amplitude)]
    if len(time) < 2 or time[-1] - time[0] < LEAST_RING_DOWN or min(amplitude[[0, -1]]) <= 0:
        return []
    duration = float(time[-1] - time[0])
    decay = math.log(amplitude[0] / amplitude[-1]) / duration
    shortest, longest = _decay_times(believed)
    shortest = 1 / (1 / shortest + math.log(2) / 2 / duration)
    found = 1 / decay if decay > 0 else math.inf
    values = (believed.device.decay_time, found, shortest, longest)
    return [Witness("decay_time_s", "amplitude", log.source, *values)]


def _longest(chosen: NDArray[np.bool_]) -> slice:
    """The longest run of chosen rows."""
    edges = np.diff(np.concatenate([[0], chosen.astype(np.int8), [0]]))
    first, end = np.flatnonzero(edges == 1), np.flatnonzero(edges == -1)
    if not len(first):
        return slice(0, 0)
    i = int(np.argmax(end - first))
    return slice(int(first[i]), int(end[i]))
