"""Within and between positions: an analysis of variance of data points over the circumference."""

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from pyhrg.bench.estimation.harmonics import Fit
from pyhrg.bench.estimation.spread import excess_finding
from pyhrg.bench.outcome import Finding, pooled_deviation_finding
from pyhrg.bench.readings.segments import Segments

WITHIN = "standard deviation of a position's points: noise, and what the pattern drifts over"
BETWEEN = "standard deviation of the positions' true means, noise taken off"
ONE = "one point a position: can't be told apart"


def positions_of(run: Segments) -> list[NDArray[np.float64]]:
    """Rates of each position's data points, rad/s, in the order of the positions."""
    return [run.rate[run.dwell == number] for number in np.unique(run.dwell)]


def within_finding(name: str, runs: Sequence[Segments], note: str = WITHIN) -> Finding:
    """Standard deviation (n - 1) of a position's points, pooled over positions and runs; NaN with
    one point a position."""
    groups = [group for run in runs for group in positions_of(run)]
    if max(map(len, groups)) < 2:
        return Finding(name, np.nan, "deg/h", note=ONE)
    return pooled_deviation_finding(name, groups, "deg/h", note)


def between_finding(name: str, runs: Sequence[Segments], fits: Sequence[Fit]) -> Finding:
    """Standard deviation (n - 1) of the positions' true means, in the mean square over runs.

    The noise is what the fitted map leaves of the points: unlike a position's own scatter it is
    free of what the pattern drifts over. Where the map doesn't fit, the scatter is the smaller.

    Args:
        name: of the figure.
        runs: equally many points at each position.
        fits: of the map, one a run.
    """
    groups = [positions_of(run) for run in runs]
    square = float(np.mean([np.var([np.mean(g) for g in run], ddof=1) for run in groups]))
    positions, within = sum(map(len, groups)), within_finding("", runs)
    count, freedom = sum(map(len, runs)) / positions, sum(fitted.freedom for fitted in fits)
    left = sum(float(fitted.residual @ fitted.residual) for fitted in fits) / freedom
    noises = [(float(np.sqrt(left)), freedom), (within.value, within.n - positions)]
    noise, known = min(noises[: 2 if within.n else 1])
    freedoms = positions - len(runs), known
    return excess_finding(name, square, noise / count**0.5, freedoms, "deg/h", BETWEEN)
