"""The judged flights of one calibration in one mission: flown and predicted errors."""

from dataclasses import dataclass

import numpy as np
import pandas as pd

from ins_eval.common.metrics import median_interval
from ins_eval.study.specification import TEST
from ins_eval.study.study_data import StudyData
from ins_eval.study.tables import columns as c
from ins_eval.study.tables.columns import (
    CIRCUMFERENCE_CLASS,
    CIRCUMFERENCE_RULE,
    FITTED_MAP,
    FIXED_CLASS,
    FIXED_RULE,
)
from ins_eval.study.tables.score import MEDIAN_RATIO, Score
from pyhrg.common.arrays import Array
from pyhrg.common.units import HOUR

SHOWN_PREDICTORS = (FIXED_RULE, CIRCUMFERENCE_RULE, FIXED_CLASS, CIRCUMFERENCE_CLASS, FITTED_MAP)
"""Predictors in validation.json."""


@dataclass(frozen=True)
class Outcome:
    """Judged triads of one calibration in one mission.

    flights: their rows of study.parquet; scores: the scores of its class.
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
        """(k,) median over the triads of a stability rule's prediction at `time`, m; the rule is
        proportional to time."""
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
