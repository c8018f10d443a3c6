"""What a study says of one calibration's judged flights, as `hrg validate` tells it."""

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
import pandas as pd
from numpy.typing import NDArray

from ins_eval.common.metrics import median_interval
from ins_eval.study.report.promise import Ratio, verdict
from ins_eval.study.report.result import StudyResult
from ins_eval.study.specification import TEST
from ins_eval.study.tables import columns as c
from ins_eval.study.tables.score import ALL, MEDIAN_RATIO, Score
from pyhrg.common.units import HOUR

Array = NDArray[np.float64]

FIXED, CIRCUMFERENCE, FITTED = "fixed_rule", "circumference_rule", "fitted_map"
TOLD = (FIXED, CIRCUMFERENCE, FITTED)
"""Predictors that the terminal, the figure and the CSV tell; the report tells all."""
PREDICTORS = {p.key: p for p in c.PREDICTORS}


@dataclass(frozen=True)
class Outcome:
    """calibration; flights: rows of study.parquet, of triads and a mission that no predictor was
    made on; scores: of them."""

    calibration: str
    flights: pd.DataFrame
    scores: list[Score]

    @property
    def mission(self) -> str:
        """That is judged."""
        return str(self.flights[c.MISSION].iloc[0])

    @property
    def hours(self) -> float:
        """Of navigation."""
        return float(self.flights[c.HOURS].iloc[0])

    @property
    def flown(self) -> Array:
        """(n,) radial errors at the end, m."""
        return self.flights[c.FLOWN_RADIAL].to_numpy(float)

    @property
    def interval(self) -> tuple[float, float]:
        """95 % interval of their median, m."""
        return median_interval(self.flown)

    @property
    def time(self) -> Array:
        """(k,) s since alignment: every 10 min, and the end."""
        steps = np.arange(1, len(self.flights[c.GROWTH].iloc[0]) + 1)
        return np.unique([*c.GROWTH_STEP_HOURS * HOUR * steps, self.hours * HOUR])

    @property
    def growth(self) -> Array:
        """(n, k) radial errors at those times, m."""
        grown = np.stack([*self.flights[c.GROWTH]])
        missing = len(self.time) - grown.shape[1]
        return np.hstack([grown, self.flown[:, None][:, :missing]])

    def predicted(self, key: str) -> Array:
        """(n,) medians of a predictor at the end, m."""
        return self.flights[PREDICTORS[key].median].to_numpy(float)

    def promised(self, key: str) -> Array:
        """(k,) median over the triads of what a stability promises by the usual rule, which grows
        with time, m."""
        return np.asarray(np.median(self.predicted(key)) * self.time / self.time[-1])

    def score(self, name: str, key: str, shuffled: bool = False) -> Score:
        """Of the judged flights."""
        wanted = (name, key, shuffled)
        return next(s for s in self.scores if (s.score, s.predictor, s.shuffled) == wanted)

    def ratio(self, key: str) -> Ratio:
        """Flown over promised."""
        found = self.score(MEDIAN_RATIO, key)
        return Ratio(found.value, found.low, found.high)

    @property
    def verdict(self) -> str:
        """Which test told the truth: a headline, and a line each."""
        return verdict(self.ratio(FIXED), self.ratio(CIRCUMFERENCE))


def outcomes(result: StudyResult) -> Iterator[Outcome]:
    """By calibration."""
    judged = result.table[result.table[c.HALF] == TEST]
    for calibration, flights in judged.groupby(c.CALIBRATION):
        scores = [
            s
            for s in result.scores
            if (s.calibration, s.half, s.mission_class) == (calibration, TEST, ALL)
        ]
        yield Outcome(str(calibration), flights, scores)
