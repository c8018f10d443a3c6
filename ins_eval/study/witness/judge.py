"""Scores, with intervals, of how well the gyros' own channels predict and correct flights.

Equations: docs/methods/witness.md, "Judged".
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np
import pandas as pd

from ins_eval.study.scores import measures
from ins_eval.study.scores.coverage import estimate_coverage
from ins_eval.study.scores.groups import FlightGroup, make_group
from ins_eval.study.scores.resampling import Estimate, Statistic, bootstrap, shuffle_devices
from ins_eval.study.specification import TEST
from ins_eval.study.tables.score import ALL
from pyhrg.common.arrays import Array

R2 = "r2"
COVERAGE = "coverage"
CORRECTED = "corrected_over_flown"
WORST = "worst_tenth"
NEES = "nees"
POSITION_NEES = "position_nees"
PREDICTORS = {
    "known": "maps known from the bench",
    "estimated": "maps estimated from the channels",
    "bound": "an estimate that attains the bound",
    "true": "true maps in flight",
}
CORRECTIONS = {
    "by_bench": "by the maps that the bench knows",
    "by_channels": "by those that the channels of the whole flight tell",
    "by_self_test": "by those that the channels tell until the alignment ends",
    "by_bound": "by an estimate that attains the bound, linear",
    "by_true": "by the true maps, linear",
}
SHUFFLED = "estimated, of another triad"


@dataclass(frozen=True)
class WitnessScore:
    """A score of flights of a calibration and a class with one kind of start.

    Attributes:
        self_test_s: duration of the self-test at power-on.
        score: `R2` of the horizontal error, `COVERAGE` of the intervals, `CORRECTED` median error
            over that of the uncorrected flights, `WORST` 90th percentile of that ratio flight by
            flight, `NEES` of the estimated changes over its degrees of freedom, or `POSITION_NEES`
            of the position error that the estimated maps make beside that of the true ones,
            likewise.
        of: key of `PREDICTORS` or `CORRECTIONS`, or `SHUFFLED`.
        low, high: interval of 95 %.
        n: number of triads.
    """

    calibration: str
    mission_class: str
    self_test_s: float
    score: str
    of: str
    value: float
    low: float
    high: float
    n: int


def score_witnesses(flights: pd.DataFrame, seed: int) -> list[WitnessScore]:
    """Scores by calibration, self-test and class, all classes first.

    flights: a row for each triad, calibration, mission and self-test (`tabulate.py`).
    """
    scores: list[WitnessScore] = []
    for (calibration, test), rows in flights.groupby(["calibration", "self_test_s"]):
        parts = [(ALL, rows), *rows.groupby("mission_class", sort=False)]
        for name, part in parts:
            group = make_group(str(calibration), str(name), TEST, part)
            for score, of, estimate in _score(group, seed):
                values = estimate.value, estimate.low, estimate.high
                place = str(calibration), str(name), float(test)
                scores.append(WitnessScore(*place, score, of, *values, group.triads))
    return scores


def _score(group: FlightGroup, seed: int) -> Iterator[tuple[str, str, Estimate]]:
    flown = group.select_pair("flown")
    radial = np.linalg.norm(flown, axis=-1)

    def estimate(statistic: Statistic, *samples: Array) -> Estimate:
        return bootstrap(statistic, samples, seed)

    for key in PREDICTORS:
        median = group.select(f"{key}_median_m")
        yield R2, key, estimate(measures.compute_r2, radial, median)
        low, high = group.select(f"{key}_low_m"), group.select(f"{key}_high_m")
        yield COVERAGE, key, estimate_coverage(radial, low, high, seed)
    for key in CORRECTIONS:
        corrected = np.linalg.norm(group.select_pair(key), axis=-1)
        if np.isfinite(corrected).all():
            yield CORRECTED, key, estimate(compute_size_ratio, radial, corrected)
            yield WORST, key, estimate(compute_worst_tenth, corrected / radial)
    by_bench = group.select_pair("by_bench")
    added = group.select_pair("estimated") - group.select_pair("known")

    def correct(errors: Array, estimated: Array) -> Array:
        return compute_size_ratio(radial, np.linalg.norm(errors - estimated, axis=-1))

    yield CORRECTED, SHUFFLED, shuffle_devices(correct, by_bench, [added], seed)
    squares, degrees = group.select("squares"), group.select("degrees")
    yield NEES, "estimated", estimate(_compute_nees, squares, degrees)
    position = group.select("position_square")
    yield POSITION_NEES, "estimated", estimate(_compute_nees, position, np.full_like(position, 2.0))


def compute_size_ratio(flown: Array, corrected: Array) -> Array:
    """(...,) median of corrected errors (..., r, m) over that of flown ones."""
    medians = [np.median(each, axis=(-2, -1)) for each in (corrected, flown)]
    return np.asarray(medians[0] / medians[1])


def compute_worst_tenth(ratios: Array) -> Array:
    """(...,) ratio that a tenth of the flights (..., r, m) exceeds."""
    return np.asarray(np.quantile(ratios, 0.9, axis=(-2, -1)))


def _compute_nees(squares: Array, degrees: Array) -> Array:
    return np.asarray(squares.sum(axis=(-2, -1)) / degrees.sum(axis=(-2, -1)))


def list_figures(scores: Sequence[WitnessScore]) -> tuple[tuple[str, ...], ...]:
    """Rows of text for a report: calibration, class, self-test, what, value with interval, n."""
    titles = {**PREDICTORS, **CORRECTIONS, SHUFFLED: SHUFFLED}
    return tuple(
        (
            each.calibration,
            each.mission_class,
            f"{each.self_test_s:g} s",
            f"{each.score}: {titles[each.of]}",
            f"{each.value:.3f} ({each.low:.3f} to {each.high:.3f})",
            str(each.n),
        )
        for each in scores
    )
