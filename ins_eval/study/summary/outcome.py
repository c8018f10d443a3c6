"""The judged flights of one calibration: flown and predicted errors, and the verdict."""

from dataclasses import dataclass

import numpy as np
import pandas as pd
from numpy.typing import NDArray

from ins_eval.common.metrics import median_interval
from ins_eval.study.report.ratio_verdict import Ratio, compare_tests
from ins_eval.study.specification import TEST
from ins_eval.study.study_data import StudyData
from ins_eval.study.tables import columns as c
from ins_eval.study.tables.columns import CIRCUMFERENCE_RULE, FITTED_MAP, FIXED_RULE
from ins_eval.study.tables.score import ALL, MEDIAN_RATIO, Score
from pyhrg.common.units import HOUR

Array = NDArray[np.float64]

SHOWN_PREDICTORS = (FIXED_RULE, CIRCUMFERENCE_RULE, FITTED_MAP)
"""Predictors in the summary, the figure and the CSV; the report shows all."""


@dataclass(frozen=True)
class Outcome:
    """Test triads of one calibration in the test missions.

    flights: their rows of study.parquet; scores: the scores over all test classes.
    """

    calibration: str
    flights: pd.DataFrame
    scores: list[Score]

    @property
    def missions(self) -> list[str]:
        """Names of the judged missions."""
        return list(map(str, self.flights[c.MISSION].unique()))

    @property
    def hours(self) -> float:
        """Longest duration of the navigation."""
        return float(self.flights[c.HOURS].max())

    @property
    def flown(self) -> Array:
        """(n,) flown horizontal errors at the end, m."""
        return self.flights[c.FLOWN_RADIAL].to_numpy(float)

    @property
    def time(self) -> Array:
        """(k,) s since alignment: every 10 min, and the end; for a single mission."""
        steps = np.arange(1, len(self.flights[c.GROWTH].iloc[0]) + 1)
        return np.unique([*c.GROWTH_STEP_HOURS * HOUR * steps, self.hours * HOUR])

    @property
    def growth(self) -> Array:
        """(n, k) flown horizontal errors at `time`, m; for a single mission."""
        errors = np.stack([*self.flights[c.GROWTH]])
        missing = len(self.time) - errors.shape[1]
        return np.hstack([errors, self.flown[:, None][:, :missing]])

    def predicted(self, key: str) -> Array:
        """(n,) medians of a predictor at the end, m."""
        return self.flights[c.PREDICTOR_OF[key].median].to_numpy(float)

    def predicted_growth(self, key: str) -> Array:
        """(k,) median over the triads of a stability rule's prediction at `time`, m; the rule is
        proportional to time."""
        return np.asarray(np.median(self.predicted(key)) * self.time / self.time[-1])

    def select_score(self, name: str, key: str, shuffled: bool = False) -> Score:
        """The score of a predictor."""
        wanted = (name, key, shuffled)
        return next(s for s in self.scores if (s.score, s.predictor, s.shuffled) == wanted)

    def ratio(self, key: str) -> Ratio:
        """Median of flown over predicted error."""
        score = self.select_score(MEDIAN_RATIO, key)
        return Ratio(score.value, score.low, score.high)

    @property
    def flown_interval(self) -> tuple[float, float]:
        """95 % interval of the median flown error, m."""
        return median_interval(self.flown)

    @property
    def verdict(self) -> str:
        """Which bench test predicts the error: a headline, and a line for each test."""
        return compare_tests(self.ratio(FIXED_RULE), self.ratio(CIRCUMFERENCE_RULE))


def list_outcomes(data: StudyData) -> list[Outcome]:
    """Outcomes by calibration."""
    judged = data.table[data.table[c.HALF] == TEST]
    return [
        Outcome(
            str(calibration),
            flights,
            [
                s
                for s in data.scores
                if (s.calibration, s.half, s.mission_class) == (calibration, TEST, ALL)
            ],
        )
        for calibration, flights in judged.groupby(c.CALIBRATION)
    ]
