"""How far the resonator's temperature wanders where the thermometer sees it steady."""

from collections.abc import Mapping, Sequence

import numpy as np

from pyhrg.common.arrays import Array, Mask
from pyhrg.common.robust import estimate_robust_deviation
from pyhrg.gap.replay.observations import ObservedTest
from pyhrg.gap.whitening.whitening import rise_behind_lag

SHORTEST_SHARE = 1 / 16
"""Shortest duration of the means that are compared, over the thermal lag. Chosen: wandering of the
temperature is slower, and shorter means show white noise."""
MIN_MEAN_DIFFERENCES = 3
"""Fewest differences of means that a test counts with. Chosen: a constant and an offset were
fitted to it."""


def estimate_wander(
    channel: str,
    tests: Sequence[ObservedTest],
    residuals: Sequence[Mapping[str, Array]],
    white: Mapping[float, float],
    thermal_lag: float,
) -> float:
    """Random walk that a channel shows in tests at a steady temperature, SI/sqrt(s); infinite
    without such a test (docs/methods/whitening.md, Eq. 15c).

    `white` is the standard deviation of a row by row length, s. A signal widens the differences in
    some tests, therefore the median of tests counts.
    """
    pairs = [
        (test, _remove_offset(test, residual[channel], test.rows[channel], thermal_lag))
        for test, residual in zip(tests, residuals, strict=True)
        if test.inputs.is_steady and test.rows[channel].any()
    ]
    shown = [0.0]
    duration = thermal_lag * SHORTEST_SHARE
    while seen := _measure_walks(pairs, white, duration):
        shown.append(float(np.median(seen)))
        duration *= 2
    return float(np.sqrt(max(shown))) if len(shown) > 1 else np.inf


def _remove_offset(test: ObservedTest, residual: Array, rows: Mask, thermal_lag: float) -> Array:
    """(n,) residual less a constant and what a constant error of the case's temperature makes; NaN
    where it is not compared."""
    warming = rise_behind_lag(test.log.time, thermal_lag)
    shapes = np.column_stack([np.ones(len(warming)), warming])
    sizes = np.linalg.lstsq(shapes[rows], residual[rows])[0]
    return np.where(rows, residual - shapes @ sizes, np.nan)


def _measure_walks(
    pairs: Sequence[tuple[ObservedTest, Array]], white: Mapping[float, float], duration: float
) -> list[float]:
    """Variance of the random walk in a second that makes the differences of successive means over
    a duration, less those of white noise; of each test with at least `MIN_MEAN_DIFFERENCES`."""
    variances = []
    for test, series in pairs:
        interval = test.log.interval
        count = max(round(duration / interval), 1)
        blocks = series[: len(series) // count * count].reshape(-1, count)
        known = np.isfinite(blocks).sum(axis=1)
        sums = np.nansum(blocks, axis=1)
        means = np.where(2 * known >= count, sums / np.maximum(known, 1), np.nan)
        differences = np.diff(means)
        differences = differences[np.isfinite(differences)]
        if len(differences) >= MIN_MEAN_DIFFERENCES:
            shown = estimate_robust_deviation(differences) ** 2 / 2
            variances.append(3 * (shown - white[interval] ** 2 / count) / (count * interval))
    return variances
