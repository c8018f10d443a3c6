"""All scores of a study's table, with their intervals and requirements."""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from functools import partial

import pandas as pd

from ins_eval.study.scores import measures
from ins_eval.study.scores.coverage import estimate_coverage
from ins_eval.study.scores.groups import FlightGroup, group_flights
from ins_eval.study.scores.judge import judge_bounds, judge_contains, judge_outside
from ins_eval.study.scores.resampling import Estimate, Statistic, bootstrap, shuffle_devices
from ins_eval.study.tables import columns, score
from ins_eval.study.tables.columns import (
    CIRCUMFERENCE_CLASS,
    CIRCUMFERENCE_RULE,
    CLASS_ERROR,
    FITTED_MAP,
    FIXED_CLASS,
    FIXED_MEAN,
    FIXED_RULE,
    PREDICTOR_OF,
    PREDICTORS,
    TRUE_PARAMETERS,
    TURN_ON,
    TURN_ON_ANYWHERE,
)
from ins_eval.study.tables.score import Score
from pyhrg.common.arrays import Array

RANKED_BY: Mapping[str, str] = {
    FIXED_RULE: columns.GYROS_FIXED,
    TURN_ON: columns.GYROS_TURN_ON,
    TURN_ON_ANYWHERE: columns.GYROS_TURN_ON_ANYWHERE,
    CIRCUMFERENCE_RULE: columns.GYROS_CIRCUMFERENCE,
    FITTED_MAP: columns.GYROS_FITTED,
}
"""Column of the bench figure of each gyro, by the key of its score."""
RANKED_TRIADS: Mapping[str, str] = {
    FIXED_RULE: columns.FIXED_STABILITY,
    CIRCUMFERENCE_RULE: columns.CIRCUMFERENCE_STABILITY,
}
"""Column of the bench figure of each triad, for the ranking of single flights."""
SMALLEST_R2 = 0.97
"""Smallest accepted R2 of the fitted map. Chosen."""
SMALLEST_SPEARMAN = 0.95
"""Smallest accepted rank correlation of the circumference's stability. Chosen."""
LARGEST_IDLE_SPEARMAN = 0.2
"""Largest size of a rank correlation that ranks no gyros. Chosen: of two gyros the one with the
better figure then errs less in 44 to 56 % of pairs (normal deviates)."""
SIZE_FACTOR = 1.3
"""Largest accepted factor between flown and predicted error, median, of the circumference with the
constant of the class. Chosen."""
WRONG_FACTOR = 2.0
"""Factor between flown and predicted error beyond which the fixed position's size is wrong.
Chosen."""


NO_REQUIREMENT = ("", "")


@dataclass(frozen=True)
class _Scorer:
    """Makes the scores of a group of flights.

    Attributes:
        seed: of bootstraps and permutations.
        inside: probability of the predicted intervals.
    """

    group: FlightGroup
    seed: int
    inside: float

    @property
    def flown(self) -> Array:
        """(r, m) flown horizontal errors, m."""
        return self.group.select(columns.FLOWN_RADIAL)

    def select_interval(self, key: str) -> list[Array]:
        """(r, m) lower end, median and upper end of a prediction, m."""
        predictor = PREDICTOR_OF[key]
        ends = (predictor.low, predictor.median, predictor.high)
        return [self.group.select(name) for name in ends]

    def estimate(self, statistic: Statistic, *samples: Array) -> Estimate:
        """A statistic with its bootstrap interval."""
        return bootstrap(statistic, samples, self.seed)

    def score(
        self,
        name: str,
        key: str,
        estimate: Estimate,
        requirement: tuple[str, str] = NO_REQUIREMENT,
        shuffled: bool = False,
    ) -> Score:
        """The score of this group; requirement: `asked` and `verdict` of `Score`."""
        return estimate.score(
            score=name,
            predictor=key,
            calibration=self.group.calibration,
            mission_class=self.group.mission_class,
            role=self.group.role,
            n=self.group.triads,
            seed=self.seed,
            shuffled=shuffled,
            asked=requirement[0],
            verdict=requirement[1],
        )


def score_flights(table: pd.DataFrame, seed: int, inside: float = 0.9) -> list[Score]:
    """Scores of a table of flights, by calibration, role and class.

    Args:
        table: columns of `columns`; one row for each triad, calibration and mission.
        seed: seed of bootstraps and permutations.
        inside: probability of the predicted intervals.

    Raises:
        ValueError: a triad lacks a mission or has one twice, or a group has fewer than two triads.
    """
    parts = (
        _score_r2,
        _score_control,
        _score_ratios,
        _score_skill,
        _score_coverage,
        _score_ranking,
        _score_flight_ranking,
    )
    scorers = [_Scorer(group, seed, inside) for group in group_flights(table)]
    return [score for scorer in scorers for part in parts for score in part(scorer)]


def _score_r2(scorer: _Scorer) -> Iterator[Score]:
    """R2 of predicted = flown; the fitted map has a requirement."""
    group, flown = scorer.group, scorer.flown
    for predictor in PREDICTORS:
        r2 = scorer.estimate(measures.compute_r2, flown, group.select(predictor.median))
        requirement = NO_REQUIREMENT
        if predictor.key == FITTED_MAP:
            requirement = f">= {SMALLEST_R2:g}", judge_bounds(r2, SMALLEST_R2)
        yield scorer.score(score.R2_RADIAL, predictor.key, r2, requirement)
    both, leaning = group.select_pair("flown"), group.select_pair("mounting")
    for key in (FITTED_MAP, TRUE_PARAMETERS):
        for name, errors in ((score.R2_COMPONENTS, both), (score.R2_MOUNTED, both - leaning)):
            r2 = scorer.estimate(measures.compute_component_r2, errors, group.select_pair(key))
            yield scorer.score(name, key, r2)
    for name, key, better, worse in (
        (score.R2_SHORTFALL, FITTED_MAP, TRUE_PARAMETERS, FITTED_MAP),
        (score.R2_OVER_FIXED_MEAN, FITTED_MAP, FITTED_MAP, FIXED_MEAN),
        (score.R2_OVER_FIXED, CIRCUMFERENCE_CLASS, CIRCUMFERENCE_CLASS, FIXED_CLASS),
        (score.R2_OVER_CLASS, CIRCUMFERENCE_CLASS, CIRCUMFERENCE_CLASS, CLASS_ERROR),
    ):
        medians = [group.select(PREDICTOR_OF[each].median) for each in (better, worse)]
        gain = scorer.estimate(measures.compute_r2_gain, flown, *medians)
        yield scorer.score(name, key, gain)
    share = scorer.estimate(measures.compute_power_share, both, leaning)
    yield scorer.score(score.MOUNTING_SHARE, "", share)


def _score_control(scorer: _Scorer) -> Iterator[Score]:
    """Negative control: the fitted map of another triad must not predict the error."""
    flown, predicted = (scorer.group.select_pair(name) for name in ("flown", FITTED_MAP))
    r2 = shuffle_devices(measures.compute_component_r2, flown, [predicted], scorer.seed)
    requirement = "<= 0", judge_bounds(r2, high=0.0)
    yield scorer.score(score.R2_COMPONENTS, FITTED_MAP, r2, requirement, shuffled=True)


def _score_ratios(scorer: _Scorer) -> Iterator[Score]:
    """Flown over predicted; requirements on the size by both bench tests."""
    for predictor in PREDICTORS:
        median = scorer.group.select(predictor.median)
        ratio = scorer.estimate(measures.compute_median_ratio, scorer.flown, median)
        requirement = NO_REQUIREMENT
        if predictor.key == FIXED_RULE:
            verdict = judge_outside(ratio, 1 / WRONG_FACTOR, WRONG_FACTOR)
            requirement = f"below {1 / WRONG_FACTOR:g} or above {WRONG_FACTOR:g}", verdict
        if predictor.key == CIRCUMFERENCE_CLASS:
            verdict = judge_bounds(ratio, 1 / SIZE_FACTOR, SIZE_FACTOR)
            requirement = f"within a factor of {SIZE_FACTOR:g}", verdict
        yield scorer.score(score.MEDIAN_RATIO, predictor.key, ratio, requirement)


def _score_skill(scorer: _Scorer) -> Iterator[Score]:
    """Whether the circumference with its class constant gives the size of errors better than what
    needs no circumference: the fixed position with its own constant, and the class alone."""
    statistic = partial(measures.compute_skill, inside=scorer.inside)
    own = scorer.select_interval(CIRCUMFERENCE_CLASS)
    for name, key in ((score.SKILL_OVER_FIXED, FIXED_CLASS), (score.SKILL_OVER_CLASS, CLASS_ERROR)):
        skill = scorer.estimate(statistic, scorer.flown, *own, *scorer.select_interval(key))
        requirement = "above 0", judge_bounds(skill, low=0.0)
        yield scorer.score(name, CIRCUMFERENCE_CLASS, skill, requirement)


def _score_coverage(scorer: _Scorer) -> Iterator[Score]:
    """Coverage of intervals; only the fitted map's have a requirement."""
    for predictor in PREDICTORS:
        low, high = (scorer.group.select(name) for name in (predictor.low, predictor.high))
        coverage = estimate_coverage(scorer.flown, low, high, scorer.seed)
        requirement = NO_REQUIREMENT
        if predictor.key == FITTED_MAP:
            verdict = judge_contains(coverage, scorer.inside)
            requirement = f"{scorer.inside:g} within its interval", verdict
        yield scorer.score(score.COVERAGE, predictor.key, coverage, requirement)


def _score_ranking(scorer: _Scorer) -> Iterator[Score]:
    """Rank correlation of bench figures with the linear rms over power-on angles, and its negative
    control."""
    error, statistic = scorer.group.select(columns.GYROS_LINEAR), measures.compute_spearman
    for key, column in RANKED_BY.items():
        figure = scorer.group.select(column)
        rank = scorer.estimate(statistic, error, figure)
        requirement = NO_REQUIREMENT
        if key == FIXED_RULE:
            bound = LARGEST_IDLE_SPEARMAN
            requirement = f"within {bound:g} of 0", judge_bounds(rank, -bound, bound)
        if key == CIRCUMFERENCE_RULE:
            requirement = f">= {SMALLEST_SPEARMAN:g}", judge_bounds(rank, SMALLEST_SPEARMAN)
        yield scorer.score(score.SPEARMAN, key, rank, requirement)
        control = shuffle_devices(statistic, error, [figure], scorer.seed)
        requirement = "0 within its interval", judge_contains(control, 0.0)
        yield scorer.score(score.SPEARMAN, key, control, requirement, shuffled=True)


def _score_flight_ranking(scorer: _Scorer) -> Iterator[Score]:
    """Rank correlation of triads' bench figures with their single flights, and what the
    circumference gains over the fixed position."""
    figures = {key: scorer.group.select(column) for key, column in RANKED_TRIADS.items()}
    for key, figure in figures.items():
        rank = scorer.estimate(measures.compute_flight_spearman, scorer.flown, figure)
        yield scorer.score(score.FLIGHT_SPEARMAN, key, rank)
    both = figures[CIRCUMFERENCE_RULE], figures[FIXED_RULE]
    gain = scorer.estimate(measures.compute_flight_spearman_gain, scorer.flown, *both)
    yield scorer.score(score.FLIGHT_SPEARMAN_GAIN, CIRCUMFERENCE_RULE, gain)
