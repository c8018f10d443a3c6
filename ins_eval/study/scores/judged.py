"""All scores of a study's table, with their intervals and what they are held to."""

from collections.abc import Iterator
from dataclasses import dataclass

import pandas as pd

from ins_eval.study import columns, score
from ins_eval.study.score import Score
from ins_eval.study.scores import measures, resampling
from ins_eval.study.scores.coverage import coverage
from ins_eval.study.scores.groups import Group, groups
from ins_eval.study.scores.resampling import CONFIDENCE, Estimate

RULES = ("fixed_rule", "circumference_rule", "manoeuvre_theory")
FITTED, ORACLE = "fitted_map", "oracle"
ORACLE_OF = {FITTED: ORACLE, "fitted_map_any_angle": "oracle_any_angle"}
"""Fitted maps, and the oracles that know as much of the power-on angle."""
RANKED_BY = {
    "fixed_rule": columns.GYROS_FIXED,
    "circumference_rule": columns.GYROS_CIRCUMFERENCE,
    FITTED: columns.GYROS_FITTED,
}
PREDICTABLE = 0.1
"""Unpredictable over expected rms error, below which the fitted map is held to `LEAST_R2`."""
LEAST_R2 = 0.95
BEHIND_ORACLE = 0.03
"""What the fitted map's R2 may lack to the oracle's elsewhere."""
COVERED = 0.9
"""By intervals from the 5 % to the 95 % quantile."""
FEWEST = 2
"""Triads that can be shuffled."""


def scores(table: pd.DataFrame, seed: int) -> list[Score]:
    """Of a table of `columns`, by calibration, half and class.

    Args:
        table: one row a triad, calibration and mission.
        seed: of bootstraps and shuffles.

    Raises:
        ValueError: a triad lacks a mission or has one twice, or there are fewer than two.
    """
    return [found for group in groups(table) for found in _Judge(group, seed).scores()]


@dataclass(frozen=True)
class _Judge:
    group: Group
    seed: int

    def scores(self) -> Iterator[Score]:
        if self.group.triads < FEWEST:
            raise ValueError(f"{self.group}: {self.group.triads} triads; expected {FEWEST} or more")
        yield self._share()
        yield from self._r2()
        for key in (*RULES, FITTED, ORACLE):
            yield self._bootstrapped(score.MEDIAN_RATIO, key, measures.median_ratio)
            yield self._bootstrapped(score.OPTIMISM, key, measures.optimism)
        yield from self._intervals()
        yield from self._ranking()
        yield self._advantage()
        yield self._variance_removed()

    def _share(self) -> Score:
        expected = self.group.pair(FITTED)
        samples = [self.group.of(columns.UNPREDICTABLE), expected]
        found = resampling.bootstrapped(measures.unpredictable_share, samples, self.seed)
        return self._score(score.UNPREDICTABLE_SHARE, FITTED, found)

    def _r2(self) -> Iterator[Score]:
        for key in (*RULES, ORACLE):
            yield self._bootstrapped(score.R2_RADIAL, key, measures.r2)
        bound, asked = self._bound()
        found = self._radial(measures.r2, FITTED)
        holds = found.value >= bound
        yield self._score(score.R2_RADIAL, FITTED, found, asked=asked, holds=holds)
        for key in (FITTED, ORACLE):
            pairs = [self.group.pair("flown"), self.group.pair(key)]
            both = resampling.bootstrapped(measures.r2_components, pairs, self.seed)
            yield self._score(score.R2_COMPONENTS, key, both)
        yield self._shuffled_r2()

    def _bound(self) -> tuple[float, str]:
        """What R2 of the fitted map is held to."""
        if self._share().value < PREDICTABLE:
            return LEAST_R2, f">= {LEAST_R2:g}"
        flown, predicted = self._flown, self.group.of(f"{ORACLE}_median_m")
        bound = float(measures.r2(flown, predicted)) - BEHIND_ORACLE
        return bound, f">= {bound:.3f}, the oracle's less {BEHIND_ORACLE:g}"

    def _shuffled_r2(self) -> Score:
        predicted = [self.group.pair(FITTED)]
        found = resampling.shuffled(
            measures.r2_components, self.group.pair("flown"), predicted, self.seed
        )
        return self._score(
            score.R2_COMPONENTS,
            FITTED,
            found,
            shuffled=True,
            asked="not above 0",
            holds=found.low <= 0,
        )

    def _intervals(self) -> Iterator[Score]:
        for key in (*RULES, *ORACLE_OF, *ORACLE_OF.values()):
            low, high = self._ends(key)
            found = coverage(self._flown, low, high, self.seed)
            asked = "" if key in RULES else f"{COVERED:g} within its interval"
            holds = found.low <= COVERED <= found.high if asked else None
            yield self._score(score.COVERAGE, key, found, asked=asked, holds=holds)
        for key, oracle in ORACLE_OF.items():
            ends = [*self._ends(key), *self._ends(oracle)]
            found = resampling.bootstrapped(measures.width_ratio, ends, self.seed)
            yield self._score(score.WIDTH, key, found)

    def _ranking(self) -> Iterator[Score]:
        flown = self.group.of(columns.GYROS_FLOWN)
        for key, column in RANKED_BY.items():
            figure = self.group.of(column)
            found = resampling.bootstrapped(measures.spearman, [flown, figure], self.seed)
            yield self._score(score.SPEARMAN, key, found)
            none = resampling.shuffled(measures.spearman, flown, [figure], self.seed)
            yield self._score(
                score.SPEARMAN,
                key,
                none,
                shuffled=True,
                asked="0 within its interval",
                holds=none.low <= 0 <= none.high,
            )

    def _advantage(self) -> Score:
        samples = [
            self._flown,
            *(self._median(key) for key in ("circumference_rule", "fixed_rule")),
        ]
        found = resampling.bootstrapped(measures.advantage, samples, self.seed)
        holds = found.low > 0
        note = (
            "" if holds else "Here the fixed-position rule does as well as the full circumference."
        )
        return self._score(
            score.ADVANTAGE, "circumference_rule", found, asked="> 0", holds=holds, note=note
        )

    def _variance_removed(self) -> Score:
        samples = [self._flown, *(self._median(key) for key in (FITTED, "circumference_rule"))]
        found = resampling.bootstrapped(measures.variance_removed, samples, self.seed)
        holds = found.low > 0
        note = (
            "" if holds else "Here the fitted map tells no more than the full-circumference figure."
        )
        return self._score(
            score.VARIANCE_REMOVED, FITTED, found, asked="> 0", holds=holds, note=note
        )

    @property
    def _flown(self) -> resampling.Array:
        return self.group.of(columns.FLOWN_RADIAL)

    def _median(self, key: str) -> resampling.Array:
        return self.group.of(f"{key}_median_m")

    def _ends(self, key: str) -> tuple[resampling.Array, resampling.Array]:
        return self.group.of(f"{key}_q05_m"), self.group.of(f"{key}_q95_m")

    def _radial(self, statistic: resampling.Statistic, key: str) -> Estimate:
        return resampling.bootstrapped(statistic, [self._flown, self._median(key)], self.seed)

    def _bootstrapped(self, name: str, key: str, statistic: resampling.Statistic) -> Score:
        return self._score(name, key, self._radial(statistic, key))

    def _score(
        self,
        name: str,
        key: str,
        found: Estimate,
        shuffled: bool = False,
        asked: str = "",
        holds: bool | None = None,
        note: str = "",
    ) -> Score:
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
