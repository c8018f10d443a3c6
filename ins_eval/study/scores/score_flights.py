"""All scores of a study's table, with their intervals and requirements."""

from collections.abc import Iterator, Mapping

import pandas as pd

from ins_eval.study.scores import measures
from ins_eval.study.scores.coverage import estimate_coverage
from ins_eval.study.scores.groups import group_flights
from ins_eval.study.scores.judge import judge_bounds, judge_contains, judge_outside
from ins_eval.study.scores.resampling import bootstrap, shuffle_devices
from ins_eval.study.scores.scorer import Scorer
from ins_eval.study.tables import columns, score
from ins_eval.study.tables.columns import (
    CIRCUMFERENCE_CLASS,
    CIRCUMFERENCE_RULE,
    FITTED_MAP,
    FIXED_RULE,
    PREDICTORS,
    TRUE_PARAMETERS,
    TURN_ON,
    TURN_ON_ANYWHERE,
)
from ins_eval.study.tables.score import Score

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
SIZE_FACTOR = 1.3
"""Largest accepted factor between flown and predicted error, median, of the circumference with the
constant of the class. Chosen."""
WRONG_FACTOR = 2.0
"""Factor between flown and predicted error beyond which the fixed position's size is wrong.
Chosen."""


def score_flights(table: pd.DataFrame, seed: int, inside: float = 0.9) -> list[Score]:
    """Scores of a table of flights, by calibration, role and class.

    Args:
        table: columns of `columns`; one row for each triad, calibration and mission.
        seed: seed of bootstraps and permutations.
        inside: probability of the predicted intervals.

    Raises:
        ValueError: a triad lacks a mission or has one twice, or a group has fewer than two triads.
    """
    parts = (_score_r2, _score_control, _score_ratios, _score_coverage, _score_ranking)
    scorers = [Scorer(group, seed, inside) for group in group_flights(table)]
    return [found for scorer in scorers for part in parts for found in part(scorer)]


def _score_r2(scorer: Scorer) -> Iterator[Score]:
    """R2 of predicted = flown; the fitted map has a requirement."""
    for predictor in PREDICTORS:
        samples = [scorer.flown, scorer.median(predictor.key)]
        r2 = bootstrap(measures.compute_r2, samples, scorer.seed)
        if predictor.key == FITTED_MAP:
            verdict, asked = judge_bounds(r2, SMALLEST_R2), f">= {SMALLEST_R2:g}"
            yield scorer.fill_score(score.R2_RADIAL, FITTED_MAP, r2, asked=asked, verdict=verdict)
        else:
            yield scorer.fill_score(score.R2_RADIAL, predictor.key, r2)
    flown, leaning = scorer.group.select_pair("flown"), scorer.group.select_pair("mounting")
    for key in (FITTED_MAP, TRUE_PARAMETERS):
        expected, statistic = scorer.group.select_pair(key), measures.compute_component_r2
        yield scorer.make_score(score.R2_COMPONENTS, key, statistic, [flown, expected])
        yield scorer.make_score(score.R2_MOUNTED, key, statistic, [flown - leaning, expected])
    medians = [scorer.median(key) for key in (FITTED_MAP, TRUE_PARAMETERS)]
    yield scorer.make_score(
        score.R2_SHORTFALL, FITTED_MAP, measures.compute_r2_shortfall, [scorer.flown, *medians]
    )
    yield scorer.make_score(
        score.MOUNTING_SHARE, "", measures.compute_power_share, [flown, leaning]
    )


def _score_control(scorer: Scorer) -> Iterator[Score]:
    """Negative control: the fitted map of another triad must not predict the error."""
    flown, predicted = scorer.group.select_pair("flown"), scorer.group.select_pair(FITTED_MAP)
    r2 = shuffle_devices(measures.compute_component_r2, flown, [predicted], scorer.seed)
    verdict = judge_bounds(r2, high=0.0)
    yield scorer.fill_score(
        score.R2_COMPONENTS, FITTED_MAP, r2, shuffled=True, asked="<= 0", verdict=verdict
    )


def _score_ratios(scorer: Scorer) -> Iterator[Score]:
    """Flown over predicted; requirements on the size by both bench tests."""
    for predictor in PREDICTORS:
        samples = [scorer.flown, scorer.median(predictor.key)]
        ratio = bootstrap(measures.compute_median_ratio, samples, scorer.seed)
        asked, verdict = "", ""
        if predictor.key == FIXED_RULE:
            asked = f"wrong by a factor of {WRONG_FACTOR:g}"
            verdict = judge_outside(ratio, 1 / WRONG_FACTOR, WRONG_FACTOR)
        if predictor.key == CIRCUMFERENCE_CLASS:
            asked = f"within a factor of {SIZE_FACTOR:g}"
            verdict = judge_bounds(ratio, 1 / SIZE_FACTOR, SIZE_FACTOR)
        yield scorer.fill_score(
            score.MEDIAN_RATIO, predictor.key, ratio, asked=asked, verdict=verdict
        )


def _score_coverage(scorer: Scorer) -> Iterator[Score]:
    """Coverage of intervals; only the fitted map's have a requirement."""
    for predictor in PREDICTORS:
        ends = scorer.interval(predictor.key)
        coverage = estimate_coverage(scorer.flown, *ends, seed=scorer.seed)
        asked, verdict = "", ""
        if predictor.key == FITTED_MAP:
            asked = f"{scorer.inside:g} within its interval"
            verdict = judge_contains(coverage, scorer.inside)
        yield scorer.fill_score(
            score.COVERAGE, predictor.key, coverage, asked=asked, verdict=verdict
        )


def _score_ranking(scorer: Scorer) -> Iterator[Score]:
    """Rank correlation of bench figures with the rms over power-on angles, its negative control,
    and that of triads with their single flights."""
    flown, statistic = scorer.group.select(columns.GYROS_FLOWN), measures.compute_spearman
    for key, column in RANKED_BY.items():
        figure = scorer.group.select(column)
        rank = bootstrap(statistic, [flown, figure], scorer.seed)
        asked, verdict = "", ""
        if key == FIXED_RULE:
            asked, verdict = "0 within its interval", judge_contains(rank, 0.0)
        if key == CIRCUMFERENCE_RULE:
            asked, verdict = f">= {SMALLEST_SPEARMAN:g}", judge_bounds(rank, SMALLEST_SPEARMAN)
        yield scorer.fill_score(score.SPEARMAN, key, rank, asked=asked, verdict=verdict)
        control = shuffle_devices(statistic, flown, [figure], scorer.seed)
        asked, verdict = "0 within its interval", judge_contains(control, 0.0)
        yield scorer.fill_score(
            score.SPEARMAN, key, control, shuffled=True, asked=asked, verdict=verdict
        )
    for key, column in RANKED_TRIADS.items():
        samples = [scorer.flown, scorer.group.select(column)]
        yield scorer.make_score(
            score.FLIGHT_SPEARMAN, key, measures.compute_flight_spearman, samples
        )
