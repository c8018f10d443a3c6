"""The summary of a study as text: the paper's gyro, the judged flights (one calibration in one
mission, flown and predicted), the claims."""

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
import pandas as pd

from ins_eval.common.metrics import median_interval
from ins_eval.study.report.claims import describe_claim, describe_conditions, judge_claims
from ins_eval.study.report.distances import format_distance, format_range
from ins_eval.study.report.figures.parts import name_calibration
from ins_eval.study.report.lead_case import read_lead_case
from ins_eval.study.specification import TEST
from ins_eval.study.study_data import StudyData
from ins_eval.study.tables import columns as c
from ins_eval.study.tables.columns import (
    CIRCUMFERENCE_CLASS,
    CIRCUMFERENCE_RULE,
    CLASS_ERROR,
    FITTED_MAP,
    FIXED_CLASS,
    FIXED_MEAN,
    FIXED_RULE,
)
from ins_eval.study.tables.score import (
    AGREEMENT,
    ALL,
    CLASS_CONSTANT,
    MEDIAN_RATIO,
    RANGE,
    STEADY_AGREEMENT,
    Score,
)
from pyhrg.common.arrays import Array
from pyhrg.common.pages.svg import format_estimate, format_interval
from pyhrg.common.units import HOUR

SHOWN_PREDICTORS = (
    FIXED_RULE,
    CIRCUMFERENCE_RULE,
    FIXED_CLASS,
    CIRCUMFERENCE_CLASS,
    CLASS_ERROR,
    FIXED_MEAN,
    FITTED_MAP,
)
"""Predictors in validation.json."""


@dataclass(frozen=True)
class Outcome:
    """Judged triads of one calibration in one mission.

    Attributes:
        flights: rows of study.parquet of the judged flights.
        scores: the scores of its class.
    """

    calibration: str
    mission: str
    flights: pd.DataFrame
    scores: list[Score]

    @property
    def hours(self) -> float:
        """Duration of the navigation."""
        return float(self.flights[c.HOURS].max())

    @property
    def flown(self) -> Array:
        """(n,) flown horizontal errors at the end, m."""
        return self.flights[c.FLOWN_RADIAL].to_numpy(float)

    @property
    def cosimulated(self) -> int:
        """Number of flights that are co-simulated."""
        return int((self.flights[c.FLOWN_BY] == c.COSIMULATED).sum())

    @property
    def time(self) -> Array:
        """(k,) s since alignment: every 10 min, and the end."""
        steps = np.arange(1, len(self.flights[c.GROWTH].iloc[0]) + 1)
        return np.unique([*c.GROWTH_STEP_HOURS * HOUR * steps, self.hours * HOUR])

    @property
    def growth(self) -> Array:
        """(n, k) flown horizontal errors at `time`, m."""
        errors = np.stack([*self.flights[c.GROWTH]])
        missing = len(self.time) - errors.shape[1]
        return np.hstack([errors, self.flown[:, None][:, :missing]])

    def get_predicted(self, key: str) -> Array:
        """(n,) medians of a predictor at the end, m."""
        return self.flights[c.PREDICTOR_OF[key].median].to_numpy(float)

    def get_predicted_growth(self, key: str) -> Array:
        """(k,) median over the triads of a prediction at `time`, m, by the usual rule or by a class
        constant, which are proportional to time."""
        return np.asarray(np.median(self.get_predicted(key)) * self.time / self.time[-1])

    def ratio(self, key: str) -> Score:
        """Median of flown over predicted error."""
        return next(
            s
            for s in self.scores
            if (s.score, s.predictor, s.shuffled) == (MEDIAN_RATIO, key, False)
        )

    @property
    def flown_interval(self) -> tuple[float, float]:
        """95 % interval of the median flown error, m."""
        return median_interval(self.flown)


def list_outcomes(data: StudyData) -> list[Outcome]:
    judged = data.table[data.table[c.ROLE] == TEST]
    return [
        Outcome(
            str(calibration),
            str(mission),
            flights,
            [
                s
                for s in data.scores
                if s.calibration == calibration and s.mission_class == flights[c.CLASS].iloc[0]
            ],
        )
        for (calibration, mission), flights in judged.groupby(
            [c.CALIBRATION, c.MISSION], sort=False
        )
    ]


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
    """Each claim with its verdict and what decides it; its verdict in other conditions; how far
    linear and co-simulated flights differ without noise."""
    lines = []
    for calibration in data.calibrations:
        if len(data.calibrations) > 1:
            lines.append(f"{name_calibration(calibration).capitalize()}:")
        lines += [describe_claim(each) for each in judge_claims(data, calibration)]
    if conditions := describe_conditions(data):
        lines += [
            "(d) The claims in other conditions, by the linear model:",
            *(f"    {line}" for line in conditions),
        ]
    for key, flights in ((AGREEMENT, "at 1 kHz"), (STEADY_AGREEMENT, "with steady loops")):
        scores = [s for s in data.select(key) if s.mission_class == ALL]
        lines += [
            f"Without noise the linear model differs from the co-simulation {flights} by "
            f"{_format_difference(s)}."
            for s in scores
        ]
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
        ("predicted from the fixed position, usual rule", FIXED_RULE),
        ("predicted from the full circumference, usual rule", CIRCUMFERENCE_RULE),
        ("predicted from the fixed position's mean bias", FIXED_MEAN),
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


def _format_difference(score: Score) -> str:
    """A share in percent with its calibration and verdict; of few triads the range and no
    verdict."""
    numbers = (100 * score.value, 100 * score.low, 100 * score.high)
    group = f"{name_calibration(score.calibration)}, {score.n} triads"
    if score.confidence == RANGE:
        value, low, high = format_estimate(*numbers)
        return f"{value} % ({group}; the single ones by {low} to {high} %; no interval, no verdict)"
    return f"{format_interval(*numbers)} % ({group}): {score.verdict}"
