"""What was asked of the unseen half, by mission class, and whether it holds."""

from collections.abc import Sequence

from ins_eval.study.report.figures.marks import calibration_title
from ins_eval.study.report.figures.matrix import TITLES
from ins_eval.study.report.result import StudyResult
from ins_eval.study.tables import columns as c
from ins_eval.study.tables.score import ALL, SCORES, Score
from pyhrg.common.pages.markup import Table
from pyhrg.common.pages.svg import number

UNSEEN = "test"
YARDSTICKS = ("oracle", "oracle_any_angle")
"""Predictors that others are held against: how they do neither makes nor breaks the thesis."""


def asked(result: StudyResult) -> list[Score]:
    """Requirements, a class and calibration each; negative controls stand apart."""
    return [
        s
        for s in unseen(result)
        if s.holds is not None
        and not s.shuffled
        and s.mission_class != ALL
        and s.predictor not in YARDSTICKS
    ]


def unseen(result: StudyResult) -> list[Score]:
    """Scores of gyros and classes that no predictor was made on."""
    return [s for s in result.scores if s.half == UNSEEN]


def requirements(result: StudyResult) -> Table:
    """A row a requirement, a column a calibration."""
    scores = asked(result)
    calibrations = result.values(c.CALIBRATION)
    kinds = dict.fromkeys((s.score, s.predictor) for s in scores)
    rows = tuple(
        (
            TITLES[kind[1]],
            SCORES[kind[0]],
            *(
                _met([s for s in scores if (s.score, s.predictor, s.calibration) == (*kind, key)])
                for key in calibrations
            ),
        )
        for kind in kinds
    )
    header = ("Predictor", "What", *map(calibration_title, calibrations))
    return Table("What was asked of each unseen class, and where it is met", header, rows)


def _met(scores: Sequence[Score]) -> str:
    failed = [s for s in scores if not s.holds]
    if not scores:
        return "–"
    met = f"{len(scores) - len(failed)} of {len(scores)}"
    return f"{met}; not in {where(failed)}" if failed else met


def where(scores: Sequence[Score]) -> str:
    """Classes with their figures, and what was asked of each."""
    return "; ".join(
        f"{s.mission_class}: {figure(s)}{f', asked {s.asked}' if s.asked else ''}" for s in scores
    )


def figure(score: Score) -> str:
    """Value and interval."""
    return f"{number(score.value)} ({number(score.low)} to {number(score.high)})"
