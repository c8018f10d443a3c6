"""The step in which a thermometer is read or logged, where it hides the thermometer's noise."""

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]

MOSTLY = 0.5
"""Share of readings that are the one before, from which on noise is finer than the step."""
ON = 0.01
"""Distance from whole steps, relative."""
FINEST = 1e-6
"""Steps that are looked for, K: not the rounding of numbers."""


def reading_step(logs: Sequence[Array]) -> float:
    """Step of readings, K; 0 where they are finer than their noise, or never change.

    Args:
        logs: (n,) temperature of each test, K.
    """
    changes = np.concatenate([np.diff(log) for log in logs])
    changes = np.abs(changes[np.isfinite(changes)])
    moved = changes[changes > FINEST]
    if not len(moved) or len(moved) > (1 - MOSTLY) * len(changes):
        return 0.0
    counts = moved / moved.min()
    return float(moved.min()) if np.all(np.abs(counts - np.round(counts)) < ON * counts) else 0.0
