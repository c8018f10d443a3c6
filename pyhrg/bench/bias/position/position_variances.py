"""Analysis of variance of the data points, within and between positions."""

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from pyhrg.bench.estimation.harmonics import Fit
from pyhrg.bench.estimation.spread import estimate_excess
from pyhrg.bench.outcome import Finding, estimate_pooled_deviation
from pyhrg.bench.readings.segments import Segments

WITHIN = "standard deviation of a position's points: noise, and what the pattern drifts over"
BETWEEN = "standard deviation of the positions' true means, without the noise"
ONE_POINT = "one point a position: can't be separated"


def group_by_position(run: Segments) -> list[NDArray[np.float64]]:
    """Rates of each position's data points, rad/s, in the order of the positions."""
    return [run.rate[run.dwell == number] for number in np.unique(run.dwell)]


def estimate_within(name: str, runs: Sequence[Segments], note: str = WITHIN) -> Finding:
    """Standard deviation (n - 1) of a position's data points, pooled over positions and runs; NaN
    where each position has one point."""
    groups = [group for run in runs for group in group_by_position(run)]
    if max(map(len, groups)) < 2:
        return Finding(name, np.nan, "deg/h", note=ONE_POINT)
    return estimate_pooled_deviation(name, groups, "deg/h", note)


def estimate_between(name: str, runs: Sequence[Segments], fits: Sequence[Fit]) -> Finding:
    """Standard deviation (n - 1) of the positions' true means, root mean square over the runs.

    The noise is estimated from the residual of the bias map, or from the scatter within positions
    where that is smaller. The drift of the pattern within a position adds to the scatter, and a map
    that doesn't fit adds to the residual. The runs have equally many data points at each position;
    `fits` has the bias map of each.
    """
    groups = [group_by_position(run) for run in runs]
    square = float(np.mean([np.var([np.mean(g) for g in run], ddof=1) for run in groups]))
    positions, within = sum(map(len, groups)), estimate_within("", runs)
    count, freedom = sum(map(len, runs)) / positions, sum(fitted.freedom for fitted in fits)
    variance = sum(float(fitted.residual @ fitted.residual) for fitted in fits) / freedom
    noises = [(float(np.sqrt(variance)), freedom), (within.value, within.n - positions)]
    noise, noise_freedom = min(noises[: 2 if within.n else 1])
    freedoms = positions - len(runs), noise_freedom
    return estimate_excess(name, square, noise / count**0.5, freedoms, "deg/h", BETWEEN)
