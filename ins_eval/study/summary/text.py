"""The summary of a study with one judged mission, in words."""

from collections.abc import Iterator

import numpy as np

from ins_eval.study.report.condition_section import does_thesis_hold, group_by_condition
from ins_eval.study.report.figures.filters import name_calibration
from ins_eval.study.report.requirements import format_score
from ins_eval.study.study_data import StudyData
from ins_eval.study.summary.outcome import Outcome, list_outcomes
from ins_eval.study.tables import columns as c
from ins_eval.study.tables.columns import CIRCUMFERENCE_RULE, FITTED_MAP, FIXED_RULE
from ins_eval.study.tables.score import (
    AGREEMENT,
    ALL,
    MEDIAN_RATIO,
    R2_COMPONENTS,
    R2_RADIAL,
    Score,
)
from pyhrg.common.units import NAUTICAL_MILE

WIDTH = 45
"""Characters of a line before its number."""


def summarize(data: StudyData) -> str:
    """Figures, verdict, and the conditions in which the thesis does not hold."""
    lines = [line for outcome in list_outcomes(data) for line in _describe(outcome, data)]
    return "\n".join([*lines, *_describe_conditions(data)])


def _describe(outcome: Outcome, data: StudyData) -> Iterator[str]:
    n, mission = len(outcome.flights), " and ".join(outcome.missions)
    yield f"Gyros ({name_calibration(outcome.calibration)}), seed {data.about['seed']}:"
    yield f"{n} test triads on the mission {mission}; no predictor was made on either"
    yield ""
    yield "Bias stability on the bench, median of triads, deg/h"
    for title, column in (
        ("at a fixed position", c.FIXED_STABILITY),
        ("over the full circumference", c.CIRCUMFERENCE_STABILITY),
    ):
        yield f"{title:<{WIDTH}}{outcome.flights[column].median():9.3g}"
    yield ""
    yield f"Median horizontal position error after {outcome.hours:g} h of {mission}, nmi"
    for title, key in (
        ("predicted from the fixed position", FIXED_RULE),
        ("predicted from the full circumference", CIRCUMFERENCE_RULE),
        ("predicted from the fitted map", FITTED_MAP),
    ):
        yield f"{title:<{WIDTH}}{np.median(outcome.predicted(key)) / NAUTICAL_MILE:9.3g}"
    low, high = (end / NAUTICAL_MILE for end in outcome.flown_interval)
    median = np.median(outcome.flown) / NAUTICAL_MILE
    yield f"{f'flown by {n} triads':<{WIDTH}}{median:9.3g}   (95 %: {low:.3g} to {high:.3g})"
    yield ""
    yield outcome.verdict
    yield from _describe_evidence(outcome, data)


def _describe_evidence(outcome: Outcome, data: StudyData) -> Iterator[str]:
    r2 = outcome.select_score(R2_RADIAL, FITTED_MAP)
    control = outcome.select_score(R2_COMPONENTS, FITTED_MAP, shuffled=True)
    yield (
        f"The fitted map predicts single flights with R2 {format_score(r2)}; with maps shuffled "
        f"among triads R2 is {format_score(control)}."
    )
    for s in data.select(AGREEMENT, calibration=outcome.calibration, mission_class=ALL):
        yield (
            f"Flights use the linear error model. For {s.n} triads it differs by "
            f"{_format_percent(s)} from a co-simulation without noise."
        )
    yield ""


def _format_percent(score: Score) -> str:
    value, low, high = (100 * end for end in (score.value, score.low, score.high))
    return f"{value:.2g} % ({low:.2g} to {high:.2g} %)"


def _describe_conditions(data: StudyData) -> Iterator[str]:
    if data.conditions is None:
        return
    yield "In other conditions, flown over predicted from the fixed position and the circumference:"
    for name, scores in group_by_condition(data).items():
        fixed, circumference = (
            data.conditions.select(MEDIAN_RATIO, predictor=key, mission_class=name)[0]
            for key in (FIXED_RULE, CIRCUMFERENCE_RULE)
        )
        word = "holds" if does_thesis_hold(scores) else "does not hold"
        yield (
            f"  {name} ({circumference.n} triads): {format_score(fixed)} and "
            f"{format_score(circumference)}; the thesis {word}"
        )
