"""Findings held to the limits of a specification."""

import difflib
import math
from collections.abc import Iterable, Mapping
from dataclasses import dataclass

from pyhrg.bench.outcome import Finding, Outcome


@dataclass(frozen=True)
class Judgement:
    """A finding beside its limit: met or failed where its whole 95 % interval says so."""

    finding: Finding
    limit: float

    @property
    def word(self) -> str:
        """meets, fails, not decided, or not measured; it is the magnitude that is limited."""
        if math.isnan(self.finding.value):
            return "not measured"
        low, high = self._magnitude()
        if self.finding.at_least:
            low, high, limit = -high, -low, -self.limit
        else:
            limit = self.limit
        if high <= limit:
            return "meets"
        return "fails" if low > limit else "not decided"

    def _magnitude(self) -> tuple[float, float]:
        """Interval of the magnitude; NaN, for which no comparison holds, where the value's is."""
        low, high = self.finding.interval_shown
        if math.isnan(low + high):
            return math.nan, math.nan
        ends = sorted((abs(low), abs(high)))
        return (0.0 if low < 0 < high else ends[0]), ends[1]

    def __str__(self) -> str:
        finding = self.finding
        low, high = finding.interval_shown
        interval = f" ({low:.4g} to {high:.4g})" if low <= high else ""
        side = "at least" if finding.at_least else "at most"
        return f"{finding.key} {finding.shown:.4g}{interval}, {side} {self.limit:g}: {self.word}"


def judged(outcome: Outcome, limits: Mapping[str, float]) -> list[Judgement]:
    """The findings that the specification limits, by key."""
    return [Judgement(f, limits[f.key]) for f in outcome.findings if f.key in limits]


def unmatched(outcomes: Iterable[Outcome], limits: Mapping[str, float]) -> list[str]:
    """A sentence on each limit that no finding of the outcomes has for its key."""
    keys = [finding.key for outcome in outcomes for finding in outcome.findings]
    sentences = []
    for key in (key for key in limits if key not in keys):
        close = difflib.get_close_matches(key, keys, n=1)
        hint = f"; the closest is {close[0]}" if close else ""
        sentences.append(f"{key}: not judged, no test gave a figure of that name{hint}")
    return sentences
