"""A validation in words."""

from collections.abc import Iterator

import numpy as np

from ins_eval.study.report.apart import by_condition, holds
from ins_eval.study.report.figures.marks import calibration_title
from ins_eval.study.report.requirements import figure
from ins_eval.study.report.result import StudyResult
from ins_eval.study.tables import columns as c
from ins_eval.study.tables.score import (
    AGREEMENT,
    ALL,
    MEDIAN_RATIO,
    R2_COMPONENTS,
    R2_RADIAL,
    Score,
)
from ins_eval.study.validation.outcome import CIRCUMFERENCE, FITTED, FIXED, Outcome, outcomes
from pyhrg.common.units import NAUTICAL_MILE

WIDTH = 45


def summary(result: StudyResult) -> str:
    """What a person wants to read: figures, the verdict, and where it does not hold."""
    told = [line for outcome in outcomes(result) for line in _outcome(outcome, result)]
    return "\n".join([*told, *_conditions(result)])


def _outcome(outcome: Outcome, result: StudyResult) -> Iterator[str]:
    n = len(outcome.flights)
    yield f"Gyros {calibration_title(outcome.calibration)}, seed {result.about['seed']}: {n} triads"
    yield f"and a mission, {outcome.mission}, that no predictor was made on"
    yield ""
    yield "Bias stability on the bench, median of triads, deg/h"
    for title, column in (
        ("at a fixed position", c.FIXED_STABILITY),
        ("over the full circumference", c.CIRCUMFERENCE_STABILITY),
    ):
        yield f"{title:<{WIDTH}}{outcome.flights[column].median():9.3g}"
    yield ""
    yield f"Median radial position error after {outcome.hours:g} h of {outcome.mission}, nmi"
    for title, key in (
        ("promised by the fixed-position test", FIXED),
        ("promised by the full-circumference test", CIRCUMFERENCE),
        ("predicted by the fitted map", FITTED),
    ):
        yield f"{title:<{WIDTH}}{np.median(outcome.predicted(key)) / NAUTICAL_MILE:9.3g}"
    low, high = (end / NAUTICAL_MILE for end in outcome.interval)
    median = np.median(outcome.flown) / NAUTICAL_MILE
    yield f"{f'flown by {n} triads':<{WIDTH}}{median:9.3g}   (95 %: {low:.3g} to {high:.3g})"
    yield ""
    yield outcome.verdict
    yield from _evidence(outcome, result)


def _evidence(outcome: Outcome, result: StudyResult) -> Iterator[str]:
    known = outcome.score(R2_RADIAL, FITTED)
    control = outcome.score(R2_COMPONENTS, FITTED, shuffled=True)
    yield (
        f"The fitted map predicts each flight: R2 {figure(known)}; shuffled among devices "
        f"{figure(control)}."
    )
    for s in result.picked(AGREEMENT, calibration=outcome.calibration, mission_class=ALL):
        yield (
            f"Flights are by the linear model; {s.n} triads also by FMU at 1 kHz and navigator, "
            f"without noise: {_percent(s)} apart."
        )
    yield ""


def _percent(score: Score) -> str:
    value, low, high = (100 * end for end in (score.value, score.low, score.high))
    return f"{value:.2g} % ({low:.2g} to {high:.2g} %)"


def _conditions(result: StudyResult) -> Iterator[str]:
    if result.apart is None:
        return
    yield "Elsewhere, flown over promised by fixed position, and by full circumference:"
    told = by_condition(result)
    for name in told:
        fixed, new = (
            result.apart.picked(MEDIAN_RATIO, predictor=key, mission_class=name)[0]
            for key in (FIXED, CIRCUMFERENCE)
        )
        word = "holds" if holds(told[name]) else "does not hold"
        yield f"  {name} ({new.n} triads): {figure(fixed)}, and {figure(new)}; the thesis {word}"
