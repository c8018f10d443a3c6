"""Strength of non-stationary noise beyond the best stationary noise."""

from collections.abc import Sequence

import numpy as np

from pyhrg.common.arrays import Array

CELL = 16
"""Neighbouring coefficients of one time scale whose mean power is one estimate (chosen)."""


def measure_unsteadiness(kinds: Sequence[Sequence[Array]]) -> float:
    """How clearly noise that is added to white noise is not stationary, sigmas: the root of twice
    its Kullback-Leibler divergence from the closest stationary noise.

    The added power is estimated in cells, from 16 Haar coefficients each: one time scale by one
    stretch of time. The expected contribution of their scatter is subtracted.

    Args:
        kinds: the added noise as series (n,), in standard deviations of the white noise; the series
            of one kind share a stationary spectrum.
    """
    return float(np.sqrt(max(sum(map(_divergence, kinds)), 0.0)))


def _divergence(series: Sequence[Array]) -> float:
    """Twice the divergence of series of one kind."""
    scales = [_average_cells(values) for values in series]
    total = 0.0
    for scale in range(max(map(len, scales), default=0)):
        added = np.concatenate([cells[scale] for cells in scales if scale < len(cells)])
        level = float(np.mean(added))
        ratio = (1 + added) / (1 + level)
        chance = (level / (1 + level)) ** 2
        total += float(np.sum(CELL * (ratio - 1 - np.log(ratio)) - chance))
    return total


def _average_cells(series: Array) -> list[Array]:
    """Mean power of the Haar coefficients in each cell, from the shortest time scale on."""
    scales = []
    smooth = series
    while len(smooth) >= 2 * CELL:
        pairs = smooth[: len(smooth) // 2 * 2].reshape(-1, 2)
        detail = (pairs[:, 0] - pairs[:, 1]) / np.sqrt(2)
        smooth = pairs.sum(axis=1) / np.sqrt(2)
        count = len(detail) // CELL
        scales.append(np.mean(detail[: count * CELL].reshape(count, CELL) ** 2, axis=1))
    return scales
