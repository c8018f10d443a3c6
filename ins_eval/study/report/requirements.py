"""The requirements on scores of the test half, by mission class, and whether they are met."""

from collections.abc import Sequence

from ins_eval.study.report.figures.filters import name_calibration
from ins_eval.study.report.figures.matrix import TITLES
from ins_eval.study.specification import TEST
from ins_eval.study.study_data import StudyData
from ins_eval.study.tables import columns as c
from ins_eval.study.tables.score import ALL, SCORES, Score
from pyhrg.common.pages.markup import Table
from pyhrg.common.pages.svg import format_number

YARDSTICKS = ("oracle", "oracle_any_angle")
"""Predictors with which others are compared; their own scores do not decide about the thesis."""


def select_requirements(data: StudyData) -> list[Score]:
    """Scores with a requirement, one for each class and calibration; without negative controls."""
    return [
        s
        for s in select_unseen(data)
        if s.holds is not None
        and not s.shuffled
        and s.mission_class != ALL
        and s.predictor not in YARDSTICKS
    ]


def select_unseen(data: StudyData) -> list[Score]:
    """Scores of gyros and classes on which no predictor was made."""
    return [s for s in data.scores if s.half == TEST]


def tabulate_requirements(data: StudyData) -> Table:
    """A row for each requirement, a column for each calibration."""
    scores = select_requirements(data)
    calibrations = data.list_values(c.CALIBRATION)
    kinds = dict.fromkeys((s.score, s.predictor) for s in scores)
    rows = tuple(
        (
            TITLES[predictor],
            SCORES[score],
            *(
                _format_count(
                    [
                        s
                        for s in scores
                        if (s.score, s.predictor, s.calibration) == (score, predictor, key)
                    ]
                )
                for key in calibrations
            ),
        )
        for score, predictor in kinds
    )
    header = ("Predictor", "Score", *map(name_calibration, calibrations))
    return Table("Requirements on each test class, and where they are met", header, rows)


def _format_count(scores: Sequence[Score]) -> str:
    failed = [s for s in scores if not s.holds]
    if not scores:
        return "–"
    met = f"{len(scores) - len(failed)} of {len(scores)}"
    return f"{met}; not in {list_classes(failed)}" if failed else met


def list_classes(scores: Sequence[Score]) -> str:
    """Mission classes with their scores and requirements."""
    return "; ".join(
        f"{s.mission_class}: {format_score(s)}{f', required {s.asked}' if s.asked else ''}"
        for s in scores
    )


def format_score(score: Score) -> str:
    """A score with its interval."""
    return (
        f"{format_number(score.value)} ({format_number(score.low)} to {format_number(score.high)})"
    )
