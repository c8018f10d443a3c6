"""All scores of a study's table, with their intervals and requirements."""

from collections.abc import Iterator

import pandas as pd

from ins_eval.study.scores import measures
from ins_eval.study.scores.coverage import estimate_coverage
from ins_eval.study.scores.groups import group_flights
from ins_eval.study.scores.resampling import bootstrap, shuffle_devices
from ins_eval.study.scores.scorer import Scorer
from ins_eval.study.tables import columns, score
from ins_eval.study.tables.score import Score

FIXED, CIRCUMFERENCE, THEORY = "fixed_rule", "circumference_rule", "manoeuvre_theory"
FITTED, BENCH_ORACLE, ORACLE = "fitted_map", "bench_oracle", "oracle"
STABILITIES = (FIXED, CIRCUMFERENCE, THEORY)
ORACLE_OF = {FITTED: ORACLE, "fitted_map_any_angle": "oracle_any_angle"}
"""Fitted maps, and the oracles with the same knowledge of the power-on angle."""
RANKED_BY = {
    FIXED: columns.GYROS_FIXED,
    CIRCUMFERENCE: columns.GYROS_CIRCUMFERENCE,
    FITTED: columns.GYROS_FITTED,
}
PREDICTABLE_SHARE = 0.1
"""Ratio of unpredictable to expected rms error below which the fitted map must reach `SMALLEST_R2`.
Chosen."""
SMALLEST_R2 = 0.95
"""Smallest accepted R2 of the fitted map in predictable groups. Chosen."""
ORACLE_MARGIN = 0.03
"""Elsewhere the fitted map's R2 may be smaller by this than that of the oracle on the bench, which
does not know the drift either. Chosen."""


def score_flights(table: pd.DataFrame, seed: int, inside: float = 0.9) -> list[Score]:
    """Scores of a table of flights, by calibration, half and class.

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
        _score_intervals,
        _score_ranking,
        _score_advantages,
    )
    scorers = [Scorer(group, seed, inside) for group in group_flights(table)]
    return [found for scorer in scorers for part in parts for found in part(scorer)]


def _score_r2(scorer: Scorer) -> Iterator[Score]:
    """R2 of predicted = flown; the fitted map has a requirement."""
    for key in (*STABILITIES, BENCH_ORACLE, ORACLE):
        yield scorer.make_score(
            score.R2_RADIAL, key, measures.compute_r2, [scorer.flown, scorer.median(key)]
        )
    r2 = bootstrap(measures.compute_r2, [scorer.flown, scorer.median(FITTED)], scorer.seed)
    bound, asked = _choose_r2_bound(scorer)
    yield scorer.fill_score(score.R2_RADIAL, FITTED, r2, asked=asked, holds=r2.value >= bound)
    for key in (FITTED, ORACLE):
        pairs = [scorer.group.select_pair("flown"), scorer.group.select_pair(key)]
        yield scorer.make_score(score.R2_COMPONENTS, key, measures.compute_component_r2, pairs)


def _choose_r2_bound(scorer: Scorer) -> tuple[float, str]:
    """Smallest accepted R2 of the fitted map, as a number and in words."""
    if float(measures.compute_unpredictable_share(*_select_shares(scorer))) < PREDICTABLE_SHARE:
        return SMALLEST_R2, f">= {SMALLEST_R2:g}"
    bound = float(measures.compute_r2(scorer.flown, scorer.median(BENCH_ORACLE))) - ORACLE_MARGIN
    return bound, f">= {bound:.3f}, the oracle's on the bench less {ORACLE_MARGIN:g}"


def _score_control(scorer: Scorer) -> Iterator[Score]:
    """Negative control: the fitted map of another triad must not predict the error."""
    flown, predicted = scorer.group.select_pair("flown"), scorer.group.select_pair(FITTED)
    r2 = shuffle_devices(measures.compute_component_r2, flown, [predicted], scorer.seed)
    yield scorer.fill_score(
        score.R2_COMPONENTS, FITTED, r2, shuffled=True, asked="<= 0", holds=r2.low <= 0
    )


def _score_ratios(scorer: Scorer) -> Iterator[Score]:
    for key in (*STABILITIES, FITTED, ORACLE):
        samples = [scorer.flown, scorer.median(key)]
        yield scorer.make_score(score.MEDIAN_RATIO, key, measures.compute_median_ratio, samples)
        yield scorer.make_score(score.OPTIMISM, key, measures.compute_optimism, samples)


def _score_intervals(scorer: Scorer) -> Iterator[Score]:
    """Coverage and width; only predictors that model the spread have a requirement of coverage."""
    for key in STABILITIES:
        coverage = estimate_coverage(scorer.flown, *scorer.interval(key), seed=scorer.seed)
        yield scorer.fill_score(score.COVERAGE, key, coverage)
    for key in (*ORACLE_OF, *ORACLE_OF.values()):
        coverage = estimate_coverage(scorer.flown, *scorer.interval(key), seed=scorer.seed)
        holds = coverage.low <= scorer.inside <= coverage.high
        asked = f"{scorer.inside:g} within its interval"
        yield scorer.fill_score(score.COVERAGE, key, coverage, asked=asked, holds=holds)
    for key, oracle in ORACLE_OF.items():
        ends = [*scorer.interval(key), *scorer.interval(oracle)]
        yield scorer.make_score(score.WIDTH, key, measures.compute_width_ratio, ends)


def _score_ranking(scorer: Scorer) -> Iterator[Score]:
    """Rank correlation of bench figures with the rms over power-on angles, and its negative
    control."""
    flown = scorer.group.select(columns.GYROS_FLOWN)
    for key, column in RANKED_BY.items():
        figure = scorer.group.select(column)
        yield scorer.make_score(score.SPEARMAN, key, measures.compute_spearman, [flown, figure])
        control = shuffle_devices(measures.compute_spearman, flown, [figure], scorer.seed)
        holds, asked = control.low <= 0 <= control.high, "0 within its interval"
        yield scorer.fill_score(
            score.SPEARMAN, key, control, shuffled=True, asked=asked, holds=holds
        )


def _score_advantages(scorer: Scorer) -> Iterator[Score]:
    """The two scores of the thesis: the circumference predicts better than the fixed position, and
    the fitted map better than the circumference."""
    flown, fixed = scorer.flown, scorer.median(FIXED)
    circumference = scorer.median(CIRCUMFERENCE)
    yield scorer.make_score(
        score.UNPREDICTABLE_SHARE,
        FITTED,
        measures.compute_unpredictable_share,
        _select_shares(scorer),
    )
    yield scorer.make_positive_score(
        score.ADVANTAGE,
        CIRCUMFERENCE,
        measures.compute_advantage,
        [flown, circumference, fixed],
        "Here the fixed-position rule predicts as well as the full circumference.",
    )
    yield scorer.make_positive_score(
        score.VARIANCE_REMOVED,
        FITTED,
        measures.compute_variance_removed,
        [flown, scorer.median(FITTED), circumference],
        "Here the fitted map predicts no better than the full-circumference figure.",
    )


def _select_shares(scorer: Scorer) -> list[measures.Array]:
    return [scorer.group.select(columns.UNPREDICTABLE), scorer.group.select_pair(FITTED)]
