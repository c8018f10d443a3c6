"""How far the resonator's temperature wanders where the thermometer sees it steady."""

from collections.abc import Mapping, Sequence

import numpy as np

from pyhrg.common.arrays import Array
from pyhrg.common.robust import estimate_robust_deviation
from pyhrg.gap.replay.observations import Mask, ObservedTest

SHORTEST_SHARE = 1 / 16
"""Shortest duration of the means that are compared, over the thermal lag. Chosen: wandering of the
temperature is slower, and shorter means show white noise."""

MIN_DIFFERENCES = 3
"""Fewest differences of means that a test counts with. Chosen: a constant and an offset were
fitted to it."""


def is_steady(test: ObservedTest) -> bool:
    """Whether one temperature stands for all readings of a test."""
    return not np.ptp(test.inputs.temperatures)


def estimate_wander(
    channel: str,
    tests: Sequence[ObservedTest],
    residuals: Sequence[Mapping[str, Array]],
    white: Mapping[float, float],
    thermal_lag: float,
) -> float:
    """Random walk that a channel shows in tests at a steady temperature, SI/sqrt(s); infinite
    without such a test (docs/methods/whitening.md, Eq. 15b).

    `white` is the standard deviation of a row by row length, s. A signal widens the differences in
    some tests, therefore the median of tests counts.
    """
    pairs = [
        (test, _remove_offset(test, residual[channel], test.rows[channel], thermal_lag))
        for test, residual in zip(tests, residuals, strict=True)
        if is_steady(test) and test.rows[channel].any()
    ]
    shown = []
    duration = thermal_lag * SHORTEST_SHARE
    while True:
        own = [_measure_walk(series, test.log.interval, white, duration) for test, series in pairs]
        if not (seen := [variance for variance in own if np.isfinite(variance)]):
            break
        shown.append(float(np.median(seen)))
        duration *= 2
    return float(np.sqrt(max(*shown, 0.0))) if shown else np.inf


def _remove_offset(test: ObservedTest, residual: Array, rows: Mask, thermal_lag: float) -> Array:
    """(n,) residual less a constant and what a constant error of the case's temperature makes; NaN
    where it is not compared."""
    warming = -np.expm1(-test.log.time / thermal_lag)
    shapes = np.column_stack([np.ones(len(warming)), warming])
    sizes = np.linalg.lstsq(shapes[rows], residual[rows])[0]
    return np.where(rows, residual - shapes @ sizes, np.nan)


def _measure_walk(
    series: Array, interval: float, white: Mapping[float, float], duration: float
) -> float:
    """Variance of the random walk in a second that makes the differences of successive means over
    a duration, less those of white noise; NaN of fewer than `MIN_MEANS`."""
    count = max(round(duration / interval), 1)
    blocks = series[: len(series) // count * count].reshape(-1, count)
    known = np.isfinite(blocks).sum(axis=1)
    means = np.where(2 * known >= count, np.nansum(blocks, axis=1) / np.maximum(known, 1), np.nan)
    differences = np.diff(means)
    differences = differences[np.isfinite(differences)]
    if len(differences) < MIN_DIFFERENCES:
        return np.nan
    excess = estimate_robust_deviation(differences) ** 2 / 2 - white[interval] ** 2 / count
    return 3 * excess / (count * interval)
