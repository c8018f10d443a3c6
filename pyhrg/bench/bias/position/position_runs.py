"""Power-ons that have all positions, evenly spaced; variances within and between positions.

Mean and standard deviation over positions are those over the circumference (paper 4.1) only where
8N positions are evenly spaced and have equally many data points. A lost position would shift both.
"""

from collections.abc import Sequence

import numpy as np

from pyhrg.bench.estimation.harmonics import Fit
from pyhrg.bench.estimation.spread import estimate_excess
from pyhrg.bench.outcome import BenchError, Finding, estimate_pooled_deviation
from pyhrg.bench.readings.segments import SEGMENT, Points, read_segments
from pyhrg.common.arrays import Array
from pyhrg.common.site import Site
from pyhrg.common.units import DEG
from pyhrg.records.campaign import Test

STEP_TOLERANCE = 0.3
"""Largest range of the pattern steps, relative to their median (chosen); a lost position makes one
step twice as long."""

SMALLEST_LEAKAGE = 0.02
"""Share of the fourth harmonic in the mean over positions from which a warning is given."""


def read_complete_runs(
    tests: Sequence[Test], site: Site, settle: float
) -> tuple[list[Points], list[str]]:
    """Data points of each complete power-on, equally many at each position.

    `settle` seconds at the beginning of each rest are not used. Returns the runs, and a sentence on
    each power-on or data point that is not used.
    """
    candidates = [read_segments(test.log, site, settle) for test in tests]
    expected = max(points.dwells for points in candidates)
    runs, exclusions = [], []
    for test, points in zip(tests, candidates, strict=True):
        reason = _describe_incompleteness(points, expected)
        if not reason:
            runs.append(_balance(points))
            fewer, each = len(points) - len(runs[-1]), len(runs[-1]) // points.dwells
            if fewer:
                left = f"{fewer} of {len(points)} data points left out"
                reason = f"{left}: a position has no more than {each}"
        exclusions += [f"{test.log.source}: {reason}"] if reason else []
    if not runs:
        raise BenchError("; ".join(exclusions))
    return runs, exclusions


def _describe_incompleteness(points: Points, expected: int) -> str:
    """Why a power-on can't be used; empty where it can."""
    count = points.dwells
    present = f"{count} positions hold a segment of {SEGMENT:g} s after settling"
    if count < 8 or count % 8:
        return f"{present}; the test needs 8N, at least 8"
    if count < expected:
        return f"{present}, {expected} in other power-ons; left out"
    first = np.unique(points.dwell, return_index=True)[1]
    steps = np.abs(np.diff(points.pattern_angle[first])) / DEG
    if np.ptp(steps) > STEP_TOLERANCE * np.median(steps):
        return (
            f"positions lie {steps.min():.1f} to {steps.max():.1f} deg of pattern apart; "
            "the test needs them evenly spaced"
        )
    return ""


def _balance(points: Points) -> Points:
    """The first data points of each position, equally many at each."""
    dwells, counts = np.unique(points.dwell, return_counts=True)
    fewest = counts.min()
    keep = np.concatenate([np.flatnonzero(points.dwell == d)[:fewest] for d in dwells])
    return points.part(keep)


def describe_leakage(points: Points) -> str:
    """Share of the fourth harmonic in the mean over positions, in words; empty for little.

    Evenly spaced positions sample the harmonic at evenly spaced phases. Their sum is zero only
    where the phases fill whole periods.
    """
    share = float(np.abs(np.mean(np.exp(4j * points.pattern_angle))))
    if share < SMALLEST_LEAKAGE:
        return ""
    return (
        f"the positions don't fill whole periods of the fourth harmonic: up to {share:.0%} of its "
        "amplitude, by the power-on angle, is in the mean over positions (bias, repeatability)"
    )


WITHIN = "standard deviation of a position's points: noise, and what the pattern drifts over"
BETWEEN = "standard deviation of the positions' true means, without the noise"
ONE_POINT = "one point a position: can't be separated"


def group_by_position(run: Points) -> list[Array]:
    """Rates of each position's data points, rad/s, in the order of the positions."""
    return [run.rate[run.dwell == number] for number in np.unique(run.dwell)]


def estimate_within(name: str, runs: Sequence[Points]) -> Finding:
    """Standard deviation (n - 1) of a position's data points, pooled over positions and runs; NaN
    where each position has one point."""
    groups = [group for run in runs for group in group_by_position(run)]
    if max(map(len, groups)) < 2:
        return Finding(name, np.nan, "deg/h", note=ONE_POINT)
    return estimate_pooled_deviation(name, groups, "deg/h", WITHIN)


def estimate_between(name: str, runs: Sequence[Points], fits: Sequence[Fit]) -> Finding:
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
    noises = [(float(np.sqrt(variance)), freedom), (within.si_value, within.n - positions)]
    noise, noise_freedom = min(noises[: 2 if within.n else 1])
    freedoms = positions - len(runs), noise_freedom
    return estimate_excess(name, square, noise / count**0.5, freedoms, "deg/h", BETWEEN)
