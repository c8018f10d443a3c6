"""Strength of non-stationary noise beyond the best stationary noise."""

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]

CELL = 16
"""Coefficients of one time scale over which a level is taken."""


def measure_unsteadiness(kinds: Sequence[Sequence[Array]]) -> float:
    """Root of twice the divergence between white noise with and without what is added to it, sigmas
    of a mean with the same evidence, where steady noise of any spectrum may stand in for it.

    Of a realisation: in cells of a time scale (a Haar coefficient's) and a stretch of time, the
    added power is that of 16 coefficients, what these scatter by chance taken off.

    Args:
        kinds: of series, those of a kind with one steady spectrum; (n,) each, what is added, in
            deviations of the white noise.
    """
    return float(np.sqrt(max(sum(map(_divergence, kinds)), 0.0)))


def _divergence(series: Sequence[Array]) -> float:
    """Twice that of series of one kind."""
    scales = [_cells(one) for one in series]
    total = 0.0
    for scale in range(max(map(len, scales), default=0)):
        added = np.concatenate([cells[scale] for cells in scales if scale < len(cells)])
        level = float(np.mean(added))
        ratio = (1 + added) / (1 + level)
        chance = (level / (1 + level)) ** 2
        total += float(np.sum(CELL * (ratio - 1 - np.log(ratio)) - chance))
    return total


def _cells(series: Array) -> list[Array]:
    """Mean power of Haar coefficients by cells, from the shortest scale on."""
    found = []
    smooth = series
    while len(smooth) >= 2 * CELL:
        pairs = smooth[: len(smooth) // 2 * 2].reshape(-1, 2)
        detail = (pairs[:, 0] - pairs[:, 1]) / np.sqrt(2)
        smooth = pairs.sum(axis=1) / np.sqrt(2)
        count = len(detail) // CELL
        found.append(np.mean(detail[: count * CELL].reshape(count, CELL) ** 2, axis=1))
    return found
