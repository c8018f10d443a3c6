"""Findings held to the limits of a specification."""

import math
from collections.abc import Mapping
from dataclasses import dataclass

from pyhrg.bench.outcome import Finding, Outcome


@dataclass(frozen=True)
class Judgement:
    """A finding beside its limit: met or failed where its whole 95 % interval says so."""

    finding: Finding
    limit: float

    @property
    def word(self) -> str:
        """meets, fails, or not decided."""
        if math.isnan(self.finding.value):
            return "not measured"
        low, high = sorted(abs(x) for x in self._bounds())
        if self.finding.low < 0 < self.finding.high:
            low = 0.0
        if high <= self.limit:
            return "meets"
        return "fails" if low > self.limit else "not decided"

    def _bounds(self) -> tuple[float, float]:
        low, high = self.finding.interval_shown
        shown = self.finding.shown
        return (shown if math.isnan(low) else low, shown if math.isnan(high) else high)

    def __str__(self) -> str:
        finding = self.finding
        return f"{finding.key} {finding.shown:.4g}, limit {self.limit:g}: {self.word}"


def judged(outcome: Outcome, limits: Mapping[str, float]) -> list[Judgement]:
    """The findings that the specification limits, by key."""
    return [Judgement(f, limits[f.key]) for f in outcome.findings if f.key in limits]
