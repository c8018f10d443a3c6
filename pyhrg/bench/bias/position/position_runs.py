"""Power-ons that went evenly round the circumference, and what keeps the others from it.

The mean over positions is that of the circumference, and their standard deviation its stability
(paper 4.1), only where 8N positions are evenly spaced and count alike: a lost one would shift both.
"""

from collections.abc import Sequence

import numpy as np

from pyhrg.bench.outcome import BenchError
from pyhrg.bench.readings.segments import SEGMENT, WARM_UP, Segments, segment_means
from pyhrg.common.units import DEG
from pyhrg.records.campaign import Test

UNEVEN = 0.3
"""Share of a step of the pattern by which steps may differ: a lost position makes one of two."""

LEAKS = 0.02
"""Share of the fourth harmonic in the mean over positions, from which it is told."""


def complete_runs(
    tests: Sequence[Test], latitude: float, settle: float
) -> tuple[list[Segments], list[str]]:
    """Data points of each complete power-on, equally many a position, and what was left out.

    Args:
        tests: of positions.
        latitude: of the site, rad.
        settle: left out at the beginning of each rest, s.

    Raises:
        BenchError: no power-on is complete.
    """
    found = [segment_means(test.log, latitude, settle, warm_up=WARM_UP) for test in tests]
    most = max(points.dwells for points in found)
    runs, left_out = [], []
    for test, points in zip(tests, found, strict=True):
        trouble = _incomplete(points, most)
        if not trouble:
            runs.append(_balanced(points))
            trouble = _unbalanced(points, runs[-1])
        left_out += [f"{test.log.source}: {trouble}"] if trouble else []
    if not runs:
        raise BenchError("; ".join(left_out))
    return runs, left_out


def _incomplete(points: Segments, most: int) -> str:
    """What makes a power-on useless, or nothing."""
    count = points.dwells
    held = f"{count} positions hold a segment of {SEGMENT:g} s after settling"
    if count < 8 or count % 8:
        return f"{held}; the test needs 8N, at least 8"
    if count < most:
        return f"{held}, {most} in other power-ons; left out"
    first = np.unique(points.dwell, return_index=True)[1]
    steps = np.abs(np.diff(points.pattern_angle[first])) / DEG
    if np.ptp(steps) > UNEVEN * np.median(steps):
        return (
            f"positions lie {steps.min():.1f} to {steps.max():.1f} deg of pattern apart; "
            "the test needs them evenly spaced"
        )
    return ""


def _balanced(points: Segments) -> Segments:
    """The same number of data points at each position, so that each counts alike."""
    dwells, counts = np.unique(points.dwell, return_counts=True)
    fewest = counts.min()
    keep = np.concatenate([np.flatnonzero(points.dwell == d)[:fewest] for d in dwells])
    return Segments(*(getattr(points, name)[keep] for name in points.__dataclass_fields__))


def _unbalanced(points: Segments, balanced: Segments) -> str:
    """What balancing left out, or nothing."""
    fewer = len(points) - len(balanced)
    if not fewer:
        return ""
    held = len(balanced) // balanced.dwells
    return f"{fewer} of {len(points)} data points left out: a position has no more than {held}"


def leakage(points: Segments) -> str:
    """How much of the fourth harmonic is in the mean over positions, where it is much.

    Evenly spaced positions take the harmonic at evenly spaced phases, which sum to zero only where
    they fill whole periods.
    """
    share = float(np.abs(np.mean(np.exp(4j * points.pattern_angle))))
    if share < LEAKS:
        return ""
    return (
        f"the positions don't fill whole periods of the fourth harmonic: up to {share:.0%} of its "
        "amplitude, by the power-on angle, is in the mean over positions (bias, repeatability)"
    )
