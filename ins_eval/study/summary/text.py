"""The summary of a study in words: the lead case, the judged flights, the claims."""

from collections.abc import Iterator

import numpy as np

from ins_eval.study.report.claims import describe_claim, describe_conditions, judge_claims
from ins_eval.study.report.distances import format_distance, format_range
from ins_eval.study.report.figures.filters import name_calibration
from ins_eval.study.report.lead_case import read_lead_case
from ins_eval.study.study_data import StudyData
from ins_eval.study.summary.outcome import Outcome, list_outcomes
from ins_eval.study.tables import columns as c
from ins_eval.study.tables.columns import CIRCUMFERENCE_RULE, FITTED_MAP, FIXED_RULE
from ins_eval.study.tables.score import AGREEMENT, CLASS_CONSTANT, STEADY_AGREEMENT, Score
from pyhrg.common.pages.svg import format_interval

WIDTH = 54
"""Characters of a line before its number."""


def summarize(data: StudyData) -> str:
    """The lead case, then figures of each mission, then the verdict."""
    case = read_lead_case(data.about)
    lines = [*case.sentences, ""] if case else []
    for outcome in list_outcomes(data):
        lines += _describe(outcome, data)
    return "\n".join([*lines, state_verdict(data)])


def state_verdict(data: StudyData) -> str:
    """Each claim with its verdict, interval and number of triads; then where they fail, and how
    far linear and co-simulated flights differ without noise."""
    calibrations = data.calibrations
    lines = []
    for calibration in calibrations:
        if len(calibrations) > 1:
            lines.append(f"{name_calibration(calibration).capitalize()}:")
        lines += [describe_claim(each) for each in judge_claims(data, calibration)]
        for key, flights in ((AGREEMENT, "at 1 kHz"), (STEADY_AGREEMENT, "with steady loops")):
            found = data.select(key, calibration=calibration)
            lines += [
                f"Without noise the linear model differs from the co-simulation {flights} by "
                f"{_format_percent(s)} ({s.mission_class}, {s.n} triads): {s.verdict}."
                for s in found
            ]
    conditions = describe_conditions(data)
    if conditions:
        lines += ["(d) Claims that fail in conditions:", *(f"  {line}" for line in conditions)]
    return "\n".join(lines)


def _describe(outcome: Outcome, data: StudyData) -> Iterator[str]:
    n = len(outcome.flights)
    yield (
        f"{outcome.mission}, {outcome.hours:g} h, {name_calibration(outcome.calibration)}: "
        f"{n} triads, {outcome.cosimulated} co-simulated; medians"
    )
    for title, column in (
        ("bias stability at a fixed position", c.FIXED_STABILITY),
        ("bias stability over the full circumference", c.CIRCUMFERENCE_STABILITY),
    ):
        yield f"  {title:<{WIDTH}}{outcome.flights[column].median():.2g} deg/h"
    for title, key in (
        ("predicted from the fixed position", FIXED_RULE),
        ("predicted from the full circumference", CIRCUMFERENCE_RULE),
        ("predicted from the fitted map", FITTED_MAP),
    ):
        yield f"  {title:<{WIDTH}}{format_distance(float(np.median(outcome.get_predicted(key))))}"
    median = format_distance(float(np.median(outcome.flown)))
    yield f"  {'flown':<{WIDTH}}{median}, 95 %: {format_range(*outcome.flown_interval)}"
    mission_class = outcome.flights[c.CLASS].iloc[0]
    for s in data.select(
        CLASS_CONSTANT, calibration=outcome.calibration, mission_class=mission_class
    ):
        name = c.PREDICTOR_OF[s.predictor].title.split(",")[0].lower()
        constant = f"{format_interval(s.value, s.low, s.high)} nmi/h"
        yield f"  {f'0.01 deg/h, {name}, makes in this class':<{WIDTH}}{constant}"
    yield ""


def _format_percent(score: Score) -> str:
    return f"{format_interval(100 * score.value, 100 * score.low, 100 * score.high)} %"
