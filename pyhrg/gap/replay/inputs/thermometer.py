"""A thermometer's quantization step, its noise, and the case's temperature behind it."""

from collections.abc import Mapping

import numpy as np
from scipy.signal import savgol_filter

from pyhrg.bench.readings.first_order_lag import follow_with_lag
from pyhrg.common.arrays import Array
from pyhrg.device.device import Device

MIN_REPEATED_SHARE = 0.3
"""Share of readings that repeat the one before, above which noise is finer than the step.
Chosen."""
WHOLE_STEP_TOLERANCE = 0.25
"""Largest departure of a change from a whole number of steps, in steps: a printed step may be
rounded. Chosen."""
MIN_STEP, MAX_STEP = 1e-6, 2.0
"""Range of steps that are looked for, K: above the rounding of numbers, below changes of a set
point. Chosen."""
SINGLE_STEP_RATIO = 1.5
"""Changes up to this many times the smallest change are changes by one step. Chosen."""
SLOPE_TIME = 10.0
"""Time either way over which the slope of a thermometer's readings is taken, s, but at least a row.
Chosen: a slope over less would be that of their noise."""
NOISE_ROWS = 9
"""Rows through which a parabola is laid to tell a thermometer's noise from the temperature. Chosen:
odd; it keeps three quarters of the noise, and next to nothing of the corner of a ramp."""


def estimate_reading_steps(logs: Mapping[str, Array]) -> dict[str, float]:
    """Quantization step of each (n,) temperature log, K; a log that never changes gets the finest
    step of the others. 0 means that the step is finer than the noise."""
    changes = {name: _compute_changes(log) for name, log in logs.items()}
    steps = {name: _estimate_step(own) for name, own in changes.items()}
    finest = min((step for step in steps.values() if step), default=0.0)
    return {name: steps[name] if own.any() else finest for name, own in changes.items()}


def estimate_toggling_step(log: Array) -> float:
    """Step between which a thermometer's readings, (n,) K, go to and fro, K; 0 where they don't."""
    changes = _compute_changes(log)
    goes_both_ways = changes.min(initial=0.0) < 0 < changes.max(initial=0.0)
    return _estimate_step(changes) if goes_both_ways else 0.0


def _compute_changes(log: Array) -> Array:
    """Changes from reading to reading, 0 where they are the rounding of numbers."""
    changes = np.diff(log[np.isfinite(log)])
    return np.asarray(np.where(np.abs(changes) > MIN_STEP, changes, 0.0))


def _estimate_step(changes: Array) -> float:
    """Step, K; 0 where it is finer than the noise, or readings never change."""
    sizes = np.abs(changes[changes != 0])
    if not len(sizes) or len(sizes) > (1 - MIN_REPEATED_SHARE) * len(changes):
        return 0.0
    step = float(np.median(sizes[sizes < SINGLE_STEP_RATIO * sizes.min()]))
    counts = sizes / step
    is_whole = np.all(np.abs(counts - np.round(counts)) < WHOLE_STEP_TOLERANCE)
    return step if step < MAX_STEP and is_whole else 0.0


def correct_temperatures(device: Device, readings: Array, interval: float) -> Array:
    """(n,) temperatures of the case from the thermometer's readings at this interval, s, K.

    A first-order lag of the thermometer behind the case is undone by the slope of its readings; a
    negative one is that of the case behind the thermometer. Where it is short the slope serves too:
    a lag from row to row would smooth the thermometer's noise as well."""
    lag = device.thermometer_lag
    if lag < -SLOPE_TIME:
        readings = follow_with_lag(readings, interval, -lag)
    else:
        readings = readings + lag * compute_slopes(readings, interval, SLOPE_TIME)
    reference = device.reference_temperature
    change = readings - device.thermometer_offset - reference
    return np.asarray(reference + change / (1 + device.thermometer_gain))


def estimate_thermometer_noise(temperatures: Array) -> Array:
    """(n,) noise of temperatures, K: their departure from parabolas through the nearest
    `NOISE_ROWS` (A. Savitzky, M. J. E. Golay, Anal. Chem. 36 (1964))."""
    if len(temperatures) < NOISE_ROWS:
        return np.zeros(len(temperatures))
    return np.asarray(temperatures - savgol_filter(temperatures, NOISE_ROWS, 2))


def compute_slopes(readings: Array, interval: float, reach: float) -> Array:
    """(n,) slopes of readings at this interval, s, over a reach either way, s."""
    rows, half = np.arange(len(readings)), max(1, round(reach / interval))
    low, high = np.maximum(rows - half, 0), np.minimum(rows + half, len(rows) - 1)
    return np.asarray((readings[high] - readings[low]) / ((high - low) * interval))
