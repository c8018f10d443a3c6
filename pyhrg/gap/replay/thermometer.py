"""The step in which a thermometer is read or logged, where it hides the thermometer's noise."""

from collections.abc import Mapping

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]

MOSTLY = 0.3
"""Share of readings that are the one before, from which on noise is finer than the step."""
ON = 0.25
"""Distance from whole steps, over one: a step may be rounded when it is printed."""
FINEST, COARSEST = 1e-6, 2.0
"""Steps that are looked for, K: not the rounding of numbers, nor set points that change."""
ONE = 1.5
"""Changes up to this many smallest ones are of one step."""


def reading_steps(logs: Mapping[str, Array]) -> dict[str, float]:
    """Step of each log's readings, K; of one that never changes, that of the finest other one.

    Args:
        logs: (n,) temperature by test, K.
    """
    changes = {name: _changes(log) for name, log in logs.items()}
    steps = {name: _step(own) for name, own in changes.items()}
    finest = min((step for step in steps.values() if step), default=0.0)
    return {name: steps[name] if own.any() else finest for name, own in changes.items()}


def toggling(log: Array) -> float:
    """Step between which a thermometer's readings go to and fro, K; 0 where they don't.

    Args:
        log: (n,) K.
    """
    changes = _changes(log)
    return _step(changes) if changes.min(initial=0.0) < 0 < changes.max(initial=0.0) else 0.0


def _changes(log: Array) -> Array:
    """From reading to reading, without the rounding of numbers."""
    changes = np.diff(log[np.isfinite(log)])
    return np.asarray(np.where(np.abs(changes) > FINEST, changes, 0.0))


def _step(changes: Array) -> float:
    """0 where readings are finer than their noise, or never change."""
    moved = np.abs(changes[changes != 0])
    if not len(moved) or len(moved) > (1 - MOSTLY) * len(changes):
        return 0.0
    step = float(np.median(moved[moved < ONE * moved.min()]))
    counts = moved / step
    return step if step < COARSEST and np.all(np.abs(counts - np.round(counts)) < ON) else 0.0
