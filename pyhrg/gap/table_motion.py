"""How the turntable moved between the rows of a log."""

import numpy as np
from numpy.typing import NDArray
from scipy import sparse
from scipy.sparse import linalg

Array = NDArray[np.float64]

ENCODER = 1e-9
"""What a rate's integral may miss of the encoder's increments, rad."""
ROUGHNESS = 0.1
"""Change of a rate's slope from row to row that is nothing special, rad/s."""


def rates_at_bounds(table_angle: Array, interval: float) -> Array:
    """The table's rate at the rows' bounds: linear in between, 0 at the start.

    The encoder's increments leave one freedom, a rate that alternates from bound to bound; the
    smoothest rates are taken.

    Args:
        table_angle: (n,) encoder at the rows' ends, rad; 0 at the start.
        interval: of the rows, s.

    Returns:
        (n + 1,) rad/s.
    """
    means = np.diff(table_angle, prepend=0.0) / interval
    n = len(means)
    if not means.any():
        return np.zeros(n + 1)
    mean = sparse.diags_array([0.5, 0.5], offsets=[0, -1], shape=(n, n)) * (interval / ENCODER)
    bend = sparse.diags_array([1.0, -2.0, 1.0], offsets=[-1, 0, 1], shape=(n - 1, n)) / ROUGHNESS
    normal = sparse.csc_array(mean.T @ mean + bend.T @ bend)
    rates = linalg.spsolve(normal, mean.T @ (means * interval / ENCODER))
    return np.append(0.0, rates)
