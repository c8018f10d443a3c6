"""Plans of an 8N-position test, the terms that their positions can separate, and the power-ons that
have all positions, evenly spaced; variances within and between positions.

A table step turns the pattern by -k times as much. Positions 45 deg of pattern angle apart sample
the fourth harmonic at two phases only and alias it into their mean. Within one table turn, the tilt
of the input axis (once a turn) is confounded with the fourth harmonic (four times in 3.61 turns).
Steps that are 90 deg longer leave the harmonics 4 and 8 as they are and turn the table by 0.9 of a
turn more, which separates the two.

Mean and standard deviation over positions are those over the circumference (paper 4.1) only where
8N positions are evenly spaced and have equally many data points. A lost position would shift both.
"""

import math
from collections.abc import Sequence
from dataclasses import dataclass
from functools import lru_cache

import numpy as np

from pyhrg.bench.estimation.harmonics import (
    LARGEST_INFLATION,
    Fit,
    compute_inflations,
    make_columns,
)
from pyhrg.bench.estimation.sizes import estimate_excess
from pyhrg.bench.outcome import BenchError, Finding, estimate_pooled_deviation
from pyhrg.bench.readings.segments import SEGMENT, Points, read_segments
from pyhrg.common.arrays import Array
from pyhrg.common.site import Site
from pyhrg.common.units import DEG
from pyhrg.records.campaign import Test

HARMONICS = (2, 4, 8)
"""Orders of the bias map in the pattern angle."""
STARTS = np.arange(0.0, 90.0, 7.5) * DEG
"""Start angles of the pattern, rad, for the worst of which a plan is rated."""

LARGEST_TURNS = 40.0
"""Most turns of the table in a plan that is chosen."""


@dataclass(frozen=True)
class Plan:
    """Positions of the pattern that the table reaches one after the other.

    Attributes:
        pattern_step: pattern angle between neighbouring positions, rad. The pattern angle falls by
            it while the table turns in its positive direction.
        bryan_factor: angular gain of the gyro.
    """

    positions: int
    pattern_step: float
    bryan_factor: float = 0.277

    def __post_init__(self) -> None:
        if self.positions < 1 or self.positions % 8:
            raise ValueError(f"{self.positions} positions: expected 8, 16, 24, ...")

    @property
    def table_step(self) -> float:
        """Table angle between positions, rad."""
        return self.pattern_step / self.bryan_factor

    def angles(self, start: float = 0.0) -> tuple[Array, Array]:
        """Pattern and table angles (n,), rad, for a start angle of the pattern."""
        number = np.arange(self.positions, dtype=np.float64)
        return start - number * self.pattern_step, number * self.table_step

    def inflation(self, limit: float = math.inf) -> float:
        """Largest variance inflation factor over terms and start angles; over the first start
        angles only, where that exceeds the limit already."""
        largest = 0.0
        for start in STARTS:
            columns = make_columns(*self.angles(start), HARMONICS, tilt=True)
            largest = max(largest, *compute_inflations(columns).values())
            if largest > limit:
                break
        return largest


def select_visible(
    pattern_angle: Array, table_angle: Array, wanted: Sequence[int] = HARMONICS, tilt: bool = True
) -> tuple[list[int], bool, list[str]]:
    """Terms of the bias map that positions can separate.

    The fourth harmonic is tried first, then the tilt, then the other harmonics. A term is accepted
    if all variance inflation factors stay within `LARGEST_INFLATION` and the positions outnumber
    the terms by two. Without the fourth harmonic, the largest of a whole-angle gyro, no term is
    accepted, for it would alias into them. Positions are (n,) rad, of all power-ons together.
    Returns accepted harmonics, whether the tilt is accepted, and a sentence on each term that is
    not.
    """
    pairs = np.column_stack([pattern_angle % math.pi, table_angle % (2 * math.pi)]) / DEG
    distinct = len(np.unique(np.round(pairs), axis=0))  # that differ by 1 deg or more
    accepted: list[int] = []
    with_tilt = False
    refused = []
    harmonics = sorted(wanted, key=lambda order: order != 4)
    first = harmonics[: int(4 in wanted)]
    for term in (*first, *([None] if tilt else []), *harmonics[len(first) :]):
        trial = [*accepted, term] if term is not None else accepted
        columns = make_columns(pattern_angle, table_angle, trial, with_tilt or term is None)
        worst = max(compute_inflations(columns).values())
        name = "the tilt of the input axis" if term is None else f"harmonic {term}"
        if len(columns) + 2 > distinct:
            refused.append(
                f"{distinct} positions are too few to fit {name} as well "
                f"({len(columns)} terms and 2 to show the scatter)"
            )
        elif worst > LARGEST_INFLATION:
            factor = f"{worst:.4g} times" if math.isfinite(worst) else "infinitely"
            refused.append(
                f"{name} is not fitted: at these positions it looks like the other terms, whose "
                f"variance would grow {factor} ({LARGEST_INFLATION:g} times is accepted)"
            )
        elif term is None:
            with_tilt = True
        else:
            accepted.append(term)
    if 4 in wanted and 4 not in accepted:
        refused = [text for text in refused if "harmonic 4" in text]
        hidden = "nothing else is fitted, for harmonic 4 would show as tilt or as another harmonic"
        return [], False, [*refused, hidden]
    return sorted(accepted), with_tilt, refused


@lru_cache(maxsize=64)
def choose_plan(positions: int, bryan_factor: float = 0.277) -> Plan:
    """The plan with the smallest variance inflation; of equal plans, that with the shortest steps.

    Only plans are considered whose positions fill whole periods of the fourth harmonic, so that
    their mean holds none of it, and that take no more turns of the table than `LARGEST_TURNS`.
    """
    share = 90.0 / positions
    plans = [
        Plan(positions, (part * share + 90.0 * more) * DEG, bryan_factor)
        for more in range(5)
        for part in range(1, positions)
    ]
    plans = [p for p in plans if positions * p.table_step <= LARGEST_TURNS * 2 * math.pi]
    plans.sort(key=lambda plan: plan.pattern_step)
    chosen, smallest = plans[0], math.inf
    for plan in plans:
        inflation = round(plan.inflation(smallest), 1)
        if inflation < smallest:
            chosen, smallest = plan, inflation
    return chosen


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
        return f"{present}; the test needs 8N, at least 8, of a pattern that is not swept"
    if count < expected:
        return f"{present}, {expected} in other power-ons; left out"
    first = np.unique(points.dwell, return_index=True)[1]
    steps = np.abs(np.diff(points.pattern_angle[first])) / DEG
    if np.ptp(steps) > STEP_TOLERANCE * np.median(steps):
        return (
            f"positions lie {steps.min():.1f} to {steps.max():.1f} deg of pattern apart; "
            "the test needs them evenly spaced, and a pattern that the electronics don't sweep"
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
BETWEEN = "standard deviation (n - 1) of the positions' true means, without the noise"
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
