"""The verdict in words: every sentence follows from scores of the test half."""

from collections.abc import Sequence

from ins_eval.study.report.figures.filters import name_calibration
from ins_eval.study.report.ratio_verdict import Ratio
from ins_eval.study.report.requirements import format_score, select_requirements, select_unseen
from ins_eval.study.study_data import StudyData
from ins_eval.study.tables import columns as c
from ins_eval.study.tables.columns import CIRCUMFERENCE_RULE, FITTED_MAP, FIXED_RULE, PREDICTOR_OF
from ins_eval.study.tables.score import (
    ALL,
    COVERAGE,
    MEDIAN_RATIO,
    R2_COMPONENTS,
    R2_RADIAL,
    SCORES,
    SPEARMAN,
    VARIANCE_REMOVED,
    Score,
)

LARGE_SHARE, SMALL_SHARE = 0.9, 0.1
"""Shares of the variance: "nearly all" from the first, "almost none" up to the second. Chosen."""
RATIO_PREDICTORS = (FIXED_RULE, CIRCUMFERENCE_RULE)
R2_PREDICTORS = (CIRCUMFERENCE_RULE, FITTED_MAP, "oracle")
COVERAGE_PREDICTORS = (FITTED_MAP, "fitted_map_any_angle")
"""Predictors whose ratio, R2 and coverage the verdict states; the tables have all."""
CONTROL_SCORES = {R2_COMPONENTS: "R2", SPEARMAN: "Spearman"}
"""Scores of the negative control, with short names."""


def count_requirements(data: StudyData) -> str:
    """Whether the thesis holds, by the number of requirements that are met."""
    scores = select_requirements(data)
    met = sum(bool(s.holds) for s in scores)
    if not scores:
        return "This study has no requirements, and therefore no verdict."
    if met == len(scores):
        return f"The thesis holds: all {met} requirements on the test half are met."
    if not met:
        return f"The thesis does not hold: none of {len(scores)} requirements is met."
    return f"The thesis holds in part: {met} of {len(scores)} requirements are met."


def list_verdicts(data: StudyData) -> list[tuple[str, list[str]]]:
    """Calibration and sentences, for each calibration."""
    calibrations = data.list_values(c.CALIBRATION)
    return [(name_calibration(key), list_sentences(data, key)) for key in calibrations]


def list_sentences(data: StudyData, calibration: str) -> list[str]:
    """Sentences on gyros of a calibration, over all test classes; none on missing scores."""
    scores = [s for s in select_unseen(data) if s.calibration == calibration]
    overall = [s for s in scores if s.mission_class == ALL]
    sentences = [
        *_describe_ratios(overall),
        *_describe_r2(overall),
        *_describe_removed(overall),
        *_describe_ranking(overall),
        *_describe_coverage(overall, data.interval_percent),
        *_describe_control(overall),
    ]
    return [*sentences, _describe_sample(scores)] if sentences else []


def _select(scores: Sequence[Score], score: str, predictors: Sequence[str]) -> list[Score]:
    return [
        s
        for key in predictors
        for s in scores
        if (s.score, s.predictor) == (score, key)
        if not s.shuffled
    ]


def _title(score: Score) -> str:
    return PREDICTOR_OF[score.predictor].title


def _describe_ratios(scores: Sequence[Score]) -> list[str]:
    return [
        f"{_title(s)} {Ratio(s.value, s.low, s.high).sentence}: the median flown error is "
        f"{format_score(s)} times the predicted one."
        for s in _select(scores, MEDIAN_RATIO, RATIO_PREDICTORS)
    ]


def _describe_r2(scores: Sequence[Score]) -> list[str]:
    parts = [
        f"{_title(s)} {_name_share(s)}, R2 {format_score(s)}"
        for s in _select(scores, R2_RADIAL, R2_PREDICTORS)
    ]
    return [f"Explained variance between flights: {'; '.join(parts)}."] if parts else []


def _name_share(score: Score) -> str:
    if score.low >= LARGE_SHARE:
        return "nearly all"
    if score.high <= 0:
        return "none"
    if score.high <= SMALL_SHARE:
        return "almost none"
    return "part" if score.low > 0 else "not significantly above none"


def _describe_removed(scores: Sequence[Score]) -> list[str]:
    return [
        f"Within each mission the fitted map removes {format_score(s)} of the residual variance of "
        "the full-circumference figure."
        for s in _select(scores, VARIANCE_REMOVED, [FITTED_MAP])
    ]


def _describe_ranking(scores: Sequence[Score]) -> list[str]:
    parts = [
        f"{_title(s)} {'yes' if s.low > 0 else 'not significantly'}, Spearman {format_score(s)}"
        for s in _select(scores, SPEARMAN, list(PREDICTOR_OF))
    ]
    return [f"Ranking of gyros by their flown error: {'; '.join(parts)}."] if parts else []


def _describe_coverage(scores: Sequence[Score], interval_percent: float) -> list[str]:
    inside = interval_percent / 100
    parts = [
        f"{_title(s)} {format_score(s)}, "
        f"{'compatible' if s.low <= inside <= s.high else 'not compatible'} with {inside:g}"
        for s in _select(scores, COVERAGE, COVERAGE_PREDICTORS)
    ]
    text = f"Share of flown errors inside {interval_percent:g} % intervals: {'; '.join(parts)}."
    return [text] if parts else []


def _describe_control(scores: Sequence[Score]) -> list[str]:
    controls = [s for s in scores if s.shuffled]
    if not controls:
        return []
    failed = [SCORES[s.score] for s in controls if s.low > 0]
    state = f"it FAILS in {'; '.join(failed)}" if failed else "none is above 0"
    parts = "; ".join(f"{_title(s)} {CONTROL_SCORES[s.score]} {format_score(s)}" for s in controls)
    return [f"Negative control, devices shuffled: {state}: {parts}."]


def _describe_sample(scores: Sequence[Score]) -> str:
    counts = " to ".join(f"{n:,}" for n in _list_ends([s.n for s in scores]))
    levels = _list_ends([s.confidence for s in scores])
    percent = " to ".join(f"{100 * level:g} %" for level in levels)
    return f"In brackets: {percent} intervals; n = {counts} triads."


def _list_ends(values: Sequence[float]) -> list[float]:
    return sorted({min(values), max(values)})
