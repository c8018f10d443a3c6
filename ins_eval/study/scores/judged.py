"""All scores of a study's table, with their intervals and what they are held to."""

from collections.abc import Iterator

import pandas as pd

from ins_eval.study.scores import measures
from ins_eval.study.scores.coverage import coverage
from ins_eval.study.scores.groups import groups
from ins_eval.study.scores.resampling import bootstrapped, shuffled
from ins_eval.study.scores.sheet import Sheet
from ins_eval.study.tables import columns, score
from ins_eval.study.tables.score import Score

FIXED, CIRCUMFERENCE, THEORY = "fixed_rule", "circumference_rule", "manoeuvre_theory"
FITTED, BENCH_ORACLE, ORACLE = "fitted_map", "bench_oracle", "oracle"
STABILITIES = (FIXED, CIRCUMFERENCE, THEORY)
ORACLE_OF = {FITTED: ORACLE, "fitted_map_any_angle": "oracle_any_angle"}
"""Fitted maps, and the oracles that know as much of the power-on angle."""
RANKED_BY = {
    FIXED: columns.GYROS_FIXED,
    CIRCUMFERENCE: columns.GYROS_CIRCUMFERENCE,
    FITTED: columns.GYROS_FITTED,
}
PREDICTABLE = 0.1
"""Unpredictable over expected rms error, below which the fitted map is held to `LEAST_R2`."""
LEAST_R2 = 0.95
BEHIND_ORACLE = 0.03
"""What the fitted map's R2 may lack elsewhere to an oracle's that does not know drift either."""


def scores(table: pd.DataFrame, seed: int, inside: float = 0.9) -> list[Score]:
    """Of a table of `columns`, by calibration, half and class.

    Args:
        table: one row a triad, calibration and mission.
        seed: of bootstraps and shuffles.
        inside: probability that predicted intervals promise.

    Raises:
        ValueError: a triad lacks a mission or has one twice, or a group has fewer than two triads.
    """
    parts = (_agreement, _control, _promises, _intervals, _ranking, _limits)
    sheets = [Sheet(group, seed, inside) for group in groups(table)]
    return [found for sheet in sheets for part in parts for found in part(sheet)]


def _agreement(sheet: Sheet) -> Iterator[Score]:
    """R2 about predicted = flown."""
    for key in (*STABILITIES, BENCH_ORACLE, ORACLE):
        yield sheet.bootstrapped(
            score.R2_RADIAL, key, measures.r2, [sheet.flown, sheet.median(key)]
        )
    found = bootstrapped(measures.r2, [sheet.flown, sheet.median(FITTED)], sheet.seed)
    bound, asked = _held_to(sheet)
    yield sheet.score(score.R2_RADIAL, FITTED, found, asked=asked, holds=found.value >= bound)
    for key in (FITTED, ORACLE):
        pairs = [sheet.group.pair("flown"), sheet.group.pair(key)]
        yield sheet.bootstrapped(score.R2_COMPONENTS, key, measures.r2_components, pairs)


def _held_to(sheet: Sheet) -> tuple[float, str]:
    """Bound of the fitted map's R2, as a number and in words."""
    if float(measures.unpredictable_share(*_shares(sheet))) < PREDICTABLE:
        return LEAST_R2, f">= {LEAST_R2:g}"
    bound = float(measures.r2(sheet.flown, sheet.median(BENCH_ORACLE))) - BEHIND_ORACLE
    return bound, f">= {bound:.3f}, the oracle's on the bench less {BEHIND_ORACLE:g}"


def _control(sheet: Sheet) -> Iterator[Score]:
    """Devices shuffled: the fitted map of another triad tells nothing of where an error goes."""
    flown, predicted = sheet.group.pair("flown"), sheet.group.pair(FITTED)
    found = shuffled(measures.r2_components, flown, [predicted], sheet.seed)
    yield sheet.score(
        score.R2_COMPONENTS, FITTED, found, shuffled=True, asked="<= 0", holds=found.low <= 0
    )


def _promises(sheet: Sheet) -> Iterator[Score]:
    for key in (*STABILITIES, FITTED, ORACLE):
        samples = [sheet.flown, sheet.median(key)]
        yield sheet.bootstrapped(score.MEDIAN_RATIO, key, measures.median_ratio, samples)
        yield sheet.bootstrapped(score.OPTIMISM, key, measures.optimism, samples)


def _intervals(sheet: Sheet) -> Iterator[Score]:
    """Coverage is asked of those that claim to know the spread."""
    for key in STABILITIES:
        found = coverage(sheet.flown, *sheet.ends(key), seed=sheet.seed)
        yield sheet.score(score.COVERAGE, key, found)
    for key in (*ORACLE_OF, *ORACLE_OF.values()):
        found = coverage(sheet.flown, *sheet.ends(key), seed=sheet.seed)
        holds = found.low <= sheet.inside <= found.high
        asked = f"{sheet.inside:g} within its interval"
        yield sheet.score(score.COVERAGE, key, found, asked=asked, holds=holds)
    for key, oracle in ORACLE_OF.items():
        ends = [*sheet.ends(key), *sheet.ends(oracle)]
        yield sheet.bootstrapped(score.WIDTH, key, measures.width_ratio, ends)


def _ranking(sheet: Sheet) -> Iterator[Score]:
    """Of gyros by the rms over power-on angles; with devices shuffled, of nothing."""
    flown = sheet.group.of(columns.GYROS_FLOWN)
    for key, column in RANKED_BY.items():
        figure = sheet.group.of(column)
        yield sheet.bootstrapped(score.SPEARMAN, key, measures.spearman, [flown, figure])
        none = shuffled(measures.spearman, flown, [figure], sheet.seed)
        holds, asked = none.low <= 0 <= none.high, "0 within its interval"
        yield sheet.score(score.SPEARMAN, key, none, shuffled=True, asked=asked, holds=holds)


def _limits(sheet: Sheet) -> Iterator[Score]:
    """Where the thesis doesn't hold: a better bench test that tells no more."""
    flown, fixed, new = sheet.flown, sheet.median(FIXED), sheet.median(CIRCUMFERENCE)
    yield sheet.bootstrapped(
        score.UNPREDICTABLE_SHARE, FITTED, measures.unpredictable_share, _shares(sheet)
    )
    yield sheet.above_zero(
        score.ADVANTAGE,
        CIRCUMFERENCE,
        measures.advantage,
        [flown, new, fixed],
        "The fixed-position rule does as well here as the full circumference.",
    )
    yield sheet.above_zero(
        score.VARIANCE_REMOVED,
        FITTED,
        measures.variance_removed,
        [flown, sheet.median(FITTED), new],
        "The fitted map tells no more here than the full-circumference figure.",
    )


def _shares(sheet: Sheet) -> list[measures.Array]:
    return [sheet.group.of(columns.UNPREDICTABLE), sheet.group.pair(FITTED)]
