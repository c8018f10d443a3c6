"""The verdict in plain language: every sentence follows from scores of the unseen half."""

from collections.abc import Sequence

from ins_eval.study.report.figures.marks import calibration_title
from ins_eval.study.report.promise import WORDS, Ratio
from ins_eval.study.report.requirements import asked, figure, unseen
from ins_eval.study.report.result import StudyResult
from ins_eval.study.tables import columns as c
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
"""Of explained variance: from here "nearly all", up to here "next to nothing"."""
PROMISING = ("fixed_rule", "circumference_rule")
EXPLAINING = ("circumference_rule", "fitted_map", "oracle")
COVERING = ("fitted_map", "fitted_map_any_angle")
"""Predictors whose ratios, explained variance and coverage the verdict tells; tables tell all."""
CONTROLLED = {R2_COMPONENTS: "R2", SPEARMAN: "Spearman"}
"""Scores of the negative control."""
TITLES = {p.key: p.title for p in c.PREDICTORS}


def headline(result: StudyResult) -> str:
    """Whether what was asked of the study holds."""
    scores = asked(result)
    held = sum(bool(s.holds) for s in scores)
    if not scores:
        return "Nothing was asked of this study: figures without a verdict."
    if held == len(scores):
        return f"The thesis holds: all {held} requirements on the unseen half are met."
    if not held:
        return f"The thesis does not hold: of {len(scores)} requirements none is met."
    return f"The thesis holds in part: {held} of {len(scores)} requirements are met."


def verdict(result: StudyResult) -> Sequence[tuple[str, list[str]]]:
    """Sentences by calibration."""
    return [
        (calibration_title(key), sentences(result, key)) for key in result.values(c.CALIBRATION)
    ]


def sentences(result: StudyResult, calibration: str) -> list[str]:
    """On gyros calibrated so, over all unseen classes; nothing on what was not scored."""
    scores = [s for s in unseen(result) if s.calibration == calibration]
    overall = [s for s in scores if s.mission_class == ALL]
    told = [
        *_promises(overall),
        *_explained(overall),
        *_beyond(overall),
        *_ranked(overall),
        *_covered(overall, result.level),
        *_control(overall),
    ]
    return [*told, _sample(scores)] if told else []


def _picked(scores: Sequence[Score], score: str, predictors: Sequence[str]) -> list[Score]:
    return [
        s
        for key in predictors
        for s in scores
        if (s.score, s.predictor) == (score, key)
        if not s.shuffled
    ]


def _promises(scores: Sequence[Score]) -> list[str]:
    return [
        f"{TITLES[s.predictor]} {WORDS[Ratio(s.value, s.low, s.high).word]}: the median error "
        f"flown is {figure(s)} times the predicted."
        for s in _picked(scores, MEDIAN_RATIO, PROMISING)
    ]


def _explained(scores: Sequence[Score]) -> list[str]:
    told = [
        f"{TITLES[s.predictor]} {_share(s)}, R2 {figure(s)}"
        for s in _picked(scores, R2_RADIAL, EXPLAINING)
    ]
    return [f"Differences between flights that are explained: {'; '.join(told)}."] if told else []


def _share(score: Score) -> str:
    if score.low >= LARGE_SHARE:
        return "nearly all"
    if score.high <= 0:
        return "none"
    if score.high <= SMALL_SHARE:
        return "next to nothing"
    return "part" if score.low > 0 else "no certain part"


def _beyond(scores: Sequence[Score]) -> list[str]:
    return [
        f"Mission by mission the fitted map removes {figure(s)} of the variance that the "
        "full-circumference figure leaves."
        for s in _picked(scores, VARIANCE_REMOVED, ["fitted_map"])
    ]


def _ranked(scores: Sequence[Score]) -> list[str]:
    told = [
        f"{TITLES[s.predictor]} {'yes' if s.low > 0 else 'not certainly'}, Spearman {figure(s)}"
        for s in _picked(scores, SPEARMAN, list(TITLES))
    ]
    return [f"Gyros are ranked as they fly: {'; '.join(told)}."] if told else []


def _covered(scores: Sequence[Score], level: float) -> list[str]:
    inside = level / 100
    told = [
        f"{TITLES[s.predictor]} {figure(s)}, "
        f"{'compatible' if s.low <= inside <= s.high else 'not compatible'} with {inside:g}"
        for s in _picked(scores, COVERAGE, COVERING)
    ]
    return (
        [f"Share of flown errors inside {level:g} % intervals: {'; '.join(told)}."] if told else []
    )


def _control(scores: Sequence[Score]) -> list[str]:
    controls = [s for s in scores if s.shuffled]
    shown = [SCORES[s.score] for s in controls if s.low > 0]
    if not controls:
        return []
    told = "; ".join(f"{TITLES[s.predictor]} {CONTROLLED[s.score]} {figure(s)}" for s in controls)
    found = f"NOT nothing in {'; '.join(shown)}. Be wary" if shown else "none is above 0"
    return [f"Negative control, devices shuffled: {found}: {told}."]


def _sample(scores: Sequence[Score]) -> str:
    counts = " to ".join(f"{n:,}" for n in _ends([s.n for s in scores]))
    levels = " to ".join(f"{100 * level:g} %" for level in _ends([s.confidence for s in scores]))
    return f"In brackets: {levels} intervals; n = {counts} triads."


def _ends(values: Sequence[float]) -> list[float]:
    return sorted({min(values), max(values)})
