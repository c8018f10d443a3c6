"""The verdict in plain language: every sentence follows from scores of the unseen half."""

from collections.abc import Sequence

from ins_eval.study import columns as c
from ins_eval.study.report.marks import calibration_title
from ins_eval.study.report.matrix import TITLES
from ins_eval.study.report.result import StudyResult
from ins_eval.study.report.svg import number
from ins_eval.study.score import (
    ALL,
    COVERAGE,
    MEDIAN_RATIO,
    R2_RADIAL,
    SCORES,
    SPEARMAN,
    VARIANCE_REMOVED,
    Score,
)
from ins_eval.validation.verdict import WORDS, Ratio

UNSEEN = "test"
LARGE_SHARE, SMALL_SHARE = 0.9, 0.1
"""Of explained variance: from here "nearly all", up to here "next to nothing"."""
EXPLAINING = ("circumference_rule", "fitted_map", "oracle")
"""Whose explained variance the verdict tells; the tables tell all."""
INTERVALS = ("fitted_map", "fitted_map_any_angle")
"""Whose coverage."""


def headline(result: StudyResult) -> str:
    """Whether what was asked of the study holds on the unseen half; controls stand apart."""
    asked = _asked(result)
    held = sum(bool(s.holds) for s in asked)
    if not asked:
        return "Nothing was asked of this study: figures without a verdict."
    if held == len(asked):
        return f"The thesis holds: all {held} requirements on the unseen half are met."
    if not held:
        return f"The thesis does not hold: of {len(asked)} requirements none is met."
    return f"The thesis holds in part: {held} of {len(asked)} requirements are met."


def _asked(result: StudyResult) -> list[Score]:
    return [s for s in result.scores if s.holds is not None and s.half == UNSEEN and not s.shuffled]


def sentences(result: StudyResult, calibration: str) -> list[str]:
    """On gyros calibrated so, over all unseen classes; nothing on what was not scored."""
    told = [
        *_promises(result, calibration),
        *_explained(result, calibration),
        *_beyond(result, calibration),
        *_ranked(result, calibration),
        *_covered(result, calibration),
        *_requirements(result, calibration),
        *_control(result, calibration),
    ]
    return [*told, _sample(result, calibration)] if told else []


def _sample(result: StudyResult, calibration: str) -> str:
    judged = [s for s in result.scores if (s.calibration, s.half) == (calibration, UNSEEN)]
    counts = " to ".join(f"{n:,}" for n in _ends([s.n for s in judged]))
    levels = " to ".join(f"{100 * level:g} %" for level in _ends([s.confidence for s in judged]))
    return f"In brackets: {levels} intervals; n = {counts} triads."


def _ends(values: Sequence[float]) -> list[float]:
    return sorted({min(values), max(values)})


def _one(result: StudyResult, score: str, calibration: str, predictor: str) -> list[Score]:
    return result.picked(
        score,
        calibration=calibration,
        predictor=predictor,
        mission_class=ALL,
        half=UNSEEN,
    )


def _promises(result: StudyResult, calibration: str) -> list[str]:
    return [
        f"{predictor.title} {WORDS[Ratio(s.value, s.low, s.high).word]}: the median error flown is "
        f"{_figure(s)} times the predicted."
        for predictor in c.PREDICTORS[:2]
        for s in _one(result, MEDIAN_RATIO, calibration, predictor.key)
    ]


def _explained(result: StudyResult, calibration: str) -> list[str]:
    return [
        f"{predictor.title} explains {_share(s)} of the differences between flights: R2 "
        f"{_figure(s)}."
        for predictor in c.PREDICTORS
        if predictor.key in EXPLAINING
        for s in _one(result, R2_RADIAL, calibration, predictor.key)
    ]


def _share(score: Score) -> str:
    if score.low >= LARGE_SHARE:
        return "nearly all"
    if score.high <= 0:
        return "none"
    if score.high <= SMALL_SHARE:
        return "next to nothing"
    return "part" if score.low > 0 else "no certain part"


def _beyond(result: StudyResult, calibration: str) -> list[str]:
    return [
        f"Mission by mission the fitted map removes {_figure(s)} of the variance that the "
        "full-circumference figure leaves."
        for s in _one(result, VARIANCE_REMOVED, calibration, "fitted_map")
    ]


def _ranked(result: StudyResult, calibration: str) -> list[str]:
    return [
        f"{predictor.title} {'ranks' if s.low > 0 else 'does not certainly rank'} gyros as they "
        f"fly: Spearman {_figure(s)}."
        for predictor in c.PREDICTORS
        for s in _one(result, SPEARMAN, calibration, predictor.key)
    ]


def _covered(result: StudyResult, calibration: str) -> list[str]:
    return [
        f"{predictor.title}: 90 % intervals held {_figure(s)} of the errors flown, "
        f"{'compatible' if s.low <= 0.9 <= s.high else 'not compatible'} with 0.9."
        for predictor in c.PREDICTORS
        if predictor.key in INTERVALS
        for s in _one(result, COVERAGE, calibration, predictor.key)
    ]


def _requirements(result: StudyResult, calibration: str) -> list[str]:
    by_class = [
        s for s in _asked(result) if s.calibration == calibration and s.mission_class != ALL
    ]
    kinds = dict.fromkeys((s.score, s.predictor) for s in by_class)
    return [_requirement([s for s in by_class if (s.score, s.predictor) == kind]) for kind in kinds]


def _requirement(scores: Sequence[Score]) -> str:
    failed = [s.mission_class for s in scores if not s.holds]
    what = f"{TITLES[scores[0].predictor]}, {SCORES[scores[0].score]}"
    held = f"as asked in {len(scores) - len(failed)} of {len(scores)} unseen classes"
    return f"{what}: {held}{', not in ' if failed else ''}{', '.join(failed)}."


def _control(result: StudyResult, calibration: str) -> list[str]:
    controls = [
        s
        for s in result.scores
        if s.shuffled and (s.calibration, s.half, s.mission_class) == (calibration, UNSEEN, ALL)
    ]
    shown = [SCORES[s.score] for s in controls if s.low > 0]
    if not controls:
        return []
    if shown:
        return [f"Negative control, devices shuffled: NOT nothing in {'; '.join(shown)}. Be wary."]
    return [f"Negative control, devices shuffled: none of {len(controls)} figures is above 0."]


def _figure(score: Score) -> str:
    return f"{number(score.value)} ({number(score.low)} to {number(score.high)})"


def verdict(result: StudyResult) -> Sequence[tuple[str, list[str]]]:
    """Sentences by calibration."""
    return [
        (calibration_title(key), sentences(result, key)) for key in result.values(c.CALIBRATION)
    ]
