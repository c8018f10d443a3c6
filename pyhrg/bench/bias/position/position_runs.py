"""Power-ons that have all positions, evenly spaced, and reasons why others are not used.

Mean and standard deviation over positions are those over the circumference (paper 4.1) only where
8N positions are evenly spaced and have equally many data points. A lost position would shift both.
"""

from collections.abc import Sequence

import numpy as np

from pyhrg.bench.outcome import BenchError
from pyhrg.bench.readings.segments import SEGMENT, WARM_UP, Segments, read_segments
from pyhrg.common.units import DEG
from pyhrg.records.campaign import Test

STEP_TOLERANCE = 0.3
"""Largest range of the pattern steps, relative to their median (chosen); a lost position makes one
step twice as long."""

SMALLEST_LEAKAGE = 0.02
"""Share of the fourth harmonic in the mean over positions from which a warning is given."""


def read_complete_runs(
    tests: Sequence[Test], latitude: float, settle: float
) -> tuple[list[Segments], list[str]]:
    """Data points of each complete power-on, equally many at each position.

    `settle` seconds at the beginning of each rest are not used. Returns the runs, and a sentence on
    each power-on or data point that is not used.
    """
    candidates = [read_segments(test.log, latitude, settle, warm_up=WARM_UP) for test in tests]
    expected = max(points.dwells for points in candidates)
    runs, exclusions = [], []
    for test, points in zip(tests, candidates, strict=True):
        reason = _describe_incompleteness(points, expected)
        if not reason:
            runs.append(_balance(points))
            reason = _describe_balancing(points, runs[-1])
        exclusions += [f"{test.log.source}: {reason}"] if reason else []
    if not runs:
        raise BenchError("; ".join(exclusions))
    return runs, exclusions


def _describe_incompleteness(points: Segments, expected: int) -> str:
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


def _balance(points: Segments) -> Segments:
    """The first data points of each position, equally many at each."""
    dwells, counts = np.unique(points.dwell, return_counts=True)
    fewest = counts.min()
    keep = np.concatenate([np.flatnonzero(points.dwell == d)[:fewest] for d in dwells])
    return Segments(*(getattr(points, name)[keep] for name in points.__dataclass_fields__))


def _describe_balancing(points: Segments, balanced: Segments) -> str:
    """Number of data points that balancing excluded, in words; empty for none."""
    fewer = len(points) - len(balanced)
    if not fewer:
        return ""
    each = len(balanced) // balanced.dwells
    return f"{fewer} of {len(points)} data points left out: a position has no more than {each}"


def describe_leakage(points: Segments) -> str:
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
