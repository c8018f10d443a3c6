"""The quantization step of a temperature log where it exceeds the thermometer's noise."""

from collections.abc import Mapping

import numpy as np

from pyhrg.common.arrays import Array

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
