"""Scores of one group of flights."""

from collections.abc import Sequence
from dataclasses import dataclass

from ins_eval.study.scores.groups import FlightGroup
from ins_eval.study.scores.resampling import Estimate, Statistic, bootstrap
from ins_eval.study.tables import columns
from ins_eval.study.tables.score import Score
from pyhrg.common.arrays import Array


@dataclass(frozen=True)
class Scorer:
    """Makes the scores of a group.

    group: the flights; seed: seed of bootstraps and permutations; inside: probability of the
    predicted intervals.
    """

    group: FlightGroup
    seed: int
    inside: float

    @property
    def flown(self) -> Array:
        """(r, m) flown horizontal errors, m."""
        return self.group.select(columns.FLOWN_RADIAL)

    def median(self, key: str) -> Array:
        """(r, m) medians of a predictor, m."""
        return self.group.select(f"{key}_median_m")

    def interval(self, key: str) -> tuple[Array, Array]:
        """(r, m) lower and upper ends of a predictor's interval, m."""
        return self.group.select(f"{key}_low_m"), self.group.select(f"{key}_high_m")

    def make_score(
        self, name: str, key: str, statistic: Statistic, samples: Sequence[Array]
    ) -> Score:
        """A score with its bootstrap interval and without a requirement."""
        return self.fill_score(name, key, bootstrap(statistic, samples, self.seed))

    def fill_score(
        self,
        name: str,
        key: str,
        estimate: Estimate,
        *,
        shuffled: bool = False,
        asked: str = "",
        verdict: str = "",
    ) -> Score:
        """The score of this group from an estimate; arguments are fields of `Score`."""
        return estimate.score(
            score=name,
            predictor=key,
            calibration=self.group.calibration,
            mission_class=self.group.mission_class,
            role=self.group.role,
            n=self.group.triads,
            seed=self.seed,
            shuffled=shuffled,
            asked=asked,
            verdict=verdict,
        )
