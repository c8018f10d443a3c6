"""Scores of one group, filled in."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ins_eval.study.scores.groups import Group
from ins_eval.study.scores.resampling import CONFIDENCE, Estimate, Statistic, bootstrapped
from ins_eval.study.tables import columns
from ins_eval.study.tables.score import Score

Array = NDArray[np.float64]


@dataclass(frozen=True)
class Sheet:
    """group: what is judged; seed: of bootstraps and shuffles; inside: probability that predicted
    intervals promise."""

    group: Group
    seed: int
    inside: float

    @property
    def flown(self) -> Array:
        """(r, m) radial errors, m."""
        return self.group.of(columns.FLOWN_RADIAL)

    def median(self, key: str) -> Array:
        """(r, m) a predictor's median, m."""
        return self.group.of(f"{key}_median_m")

    def ends(self, key: str) -> tuple[Array, Array]:
        """(r, m) of a predictor's interval, m."""
        return self.group.of(f"{key}_low_m"), self.group.of(f"{key}_high_m")

    def bootstrapped(
        self, name: str, key: str, statistic: Statistic, samples: Sequence[Array]
    ) -> Score:
        """Asked for nothing."""
        return self.score(name, key, bootstrapped(statistic, samples, self.seed))

    def above_zero(
        self, name: str, key: str, statistic: Statistic, samples: Sequence[Array], otherwise: str
    ) -> Score:
        """Asked to be above 0 with its interval; the note says what it means if it isn't."""
        found = bootstrapped(statistic, samples, self.seed)
        note = "" if found.low > 0 else otherwise
        return self.score(name, key, found, asked="> 0", holds=found.low > 0, note=note)

    def score(
        self,
        name: str,
        key: str,
        found: Estimate,
        *,
        shuffled: bool = False,
        asked: str = "",
        holds: bool | None = None,
        note: str = "",
    ) -> Score:
        """Of this group."""
        return Score(
            score=name,
            predictor=key,
            calibration=self.group.calibration,
            mission_class=self.group.mission_class,
            half=self.group.half,
            value=found.value,
            low=found.low,
            high=found.high,
            confidence=CONFIDENCE,
            n=self.group.triads,
            seed=self.seed,
            shuffled=shuffled,
            asked=asked,
            holds=holds,
            note=note,
        )
