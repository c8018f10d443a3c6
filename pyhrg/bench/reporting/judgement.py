"""Findings compared with the limits of a specification."""

import difflib
import math
from collections.abc import Iterable, Mapping
from dataclasses import dataclass

from pyhrg.bench.outcome import Finding, Outcome
from pyhrg.common.pages.svg import format_interval


@dataclass(frozen=True)
class Judgement:
    """A finding beside its limit.

    Attributes:
        limit: limit of the finding's magnitude, in the unit that the finding's key names.
    """

    finding: Finding
    limit: float

    @property
    def word(self) -> str:
        """`meets` or `fails` where the whole 95 % interval of the magnitude lies on one side of the
        limit, else `not decided`; `not measured` where the finding has no value."""
        if math.isnan(self.finding.si_value):
            return "not measured"
        low, high = self.finding.interval
        if math.isnan(low + high):
            return "not decided"
        ends = sorted((abs(low), abs(high)))
        low, high = (0.0 if low < 0 < high else ends[0]), ends[1]
        if self.finding.at_least:
            return "meets" if low >= self.limit else "fails" if high < self.limit else "not decided"
        return "meets" if high <= self.limit else "fails" if low > self.limit else "not decided"

    def __str__(self) -> str:
        finding = self.finding
        low, high = finding.interval
        value = format_interval(finding.value, low, high) if low <= high else f"{finding.value:.4g}"
        side = "at least" if finding.at_least else "at most"
        return f"{finding.key} {value}, {side} {self.limit:g}: {self.word}"


def judge_findings(outcome: Outcome, limits: Mapping[str, float]) -> list[Judgement]:
    """A judgement of each finding for whose key the specification has a limit."""
    return [Judgement(f, limits[f.key]) for f in outcome.findings if f.key in limits]


def describe_unmatched_limits(
    outcomes: Iterable[Outcome], limits: Mapping[str, float]
) -> list[str]:
    """A sentence on each limit whose key no finding has."""
    keys = [finding.key for outcome in outcomes for finding in outcome.findings]
    sentences = []
    for key in (key for key in limits if key not in keys):
        close = difflib.get_close_matches(key, keys, n=1)
        hint = f"; the closest is {close[0]}" if close else ""
        sentences.append(f"{key}: not judged, no test gave a figure of that name{hint}")
    return sentences
