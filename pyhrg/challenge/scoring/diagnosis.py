"""What a diagnosis said, as its `diagnosis.json` has it."""

import math
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from pyhrg.records.campaign_index import CampaignError, Entry, index_of

SCHEMA = "hrg-diagnosis/1"
FILE = "diagnosis.json"
VERDICTS = ("no_gap", "explained", "ambiguous", "unexplained")
NAMED = 0.5
"""Probability from which a cause is named."""
ANGLE_UNIT = "arcsec"
"""In the key of the output angle's residual, among `gap`'s tables of stages and of roles."""
Leaf = tuple[tuple[str, ...], Any]
"""Keys that lead to a value, and the value."""


@dataclass(frozen=True)
class Cause:
    """An effect that takes part, with those that these data cannot tell from it."""

    effect: str
    probability: float
    parameters: Mapping[str, float] = field(default_factory=dict)
    interval_95: Mapping[str, tuple[float, float]] = field(default_factory=dict)
    equivalents: tuple[str, ...] = ()

    @property
    def stated(self) -> frozenset[str]:
        """The class: the effect and its equivalents."""
        return frozenset((self.effect, *self.equivalents))


@dataclass(frozen=True)
class Diagnosis:
    """The parts of the result that are scored.

    where: coordinate and share of each entry.
    holdout_after_arcsec: of the output angle; None where it isn't given.
    next_test: kind of test; None where nothing is confounded.
    next_hours: of it.
    """

    verdict: str
    causes: tuple[Cause, ...] = ()
    unknown_probability: float = 0.0
    where: tuple[tuple[str, float], ...] = ()
    holdout_after_arcsec: float | None = None
    next_test: str | None = None
    next_hours: float = 1.0

    @property
    def classes(self) -> list[tuple[frozenset[str], float]]:
        """Classes of effects, each with its probability; causes that share an effect are one."""
        merged: list[tuple[frozenset[str], float]] = []
        for cause in self.causes:
            mine, probability = cause.stated, cause.probability
            for other in [entry for entry in merged if entry[0] & mine]:
                merged.remove(other)
                mine, probability = mine | other[0], probability + other[1]
            merged.append((mine, min(1.0, probability)))
        return merged

    @property
    def named(self) -> list[frozenset[str]]:
        """Classes that are likelier than not."""
        return [effects for effects, probability in self.classes if probability >= NAMED]


def read(path: Path) -> Diagnosis:
    """Read `diagnosis.json`.

    Raises:
        CampaignError: it isn't there or no such result; the message names file, key, what was
            found and what was expected.
    """
    index = index_of(path)
    if index.text("schema") != SCHEMA:
        raise index.error("schema", f"expected {SCHEMA!r}")
    if index.text("verdict") not in VERDICTS:
        raise index.error("verdict", f"expected one of {', '.join(VERDICTS)}")
    return Diagnosis(
        verdict=index.text("verdict"),
        causes=tuple(_cause(entry) for entry in index.entries("causes")),
        unknown_probability=index.number("unknown_probability", 0.0, 1.0),
        where=tuple((w.text("coordinate"), w.number("share")) for w in index.entries("where")),
        holdout_after_arcsec=_after(index.entry("gap")),
        next_test=_kind(index),
        next_hours=_hours(index),
    )


def _cause(entry: Entry) -> Cause:
    parameters, intervals = entry.entry("parameters"), entry.entry("interval_95")
    return Cause(
        effect=entry.text("effect"),
        probability=entry.number("probability", 0.0, 1.0),
        parameters={name: parameters.number(name) for name in parameters.values},
        interval_95={name: _ends(intervals, name) for name in intervals.values},
        equivalents=tuple(_names(entry, "equivalents")),
    )


def _ends(intervals: Entry, name: str) -> tuple[float, float]:
    ends: Any = intervals.values[name]
    numbers = isinstance(ends, list) and len(ends) == 2
    if not numbers or not all(isinstance(end, int | float) for end in ends) or ends[0] > ends[1]:
        raise intervals.error(name, "expected [low, high]")
    return float(ends[0]), float(ends[1])


def _names(entry: Entry, key: str) -> list[str]:
    names = entry.values.get(key)
    if not isinstance(names, list) or not all(isinstance(name, str) for name in names):
        raise entry.error(key, "expected a list of names")
    return names


def _after(gap: Entry) -> float | None:
    """Held-out residual of the output angle after closing."""
    leaves = _leaves(gap.values)
    said = [v for path, v in leaves if "after" in path and _is_held_out_angle(path)]
    if len(said) != 1 or not isinstance(said[0], int | float) or not 0 < said[0] < math.inf:
        return None
    return float(said[0])


def _is_held_out_angle(path: tuple[str, ...]) -> bool:
    return "holdout" in path and any(ANGLE_UNIT in key for key in path)


def _leaves(table: Mapping[str, Any], path: tuple[str, ...] = ()) -> Iterator[Leaf]:
    for key, value in table.items():
        if isinstance(value, dict):
            yield from _leaves(value, (*path, key))
        else:
            yield (*path, key), value


def _kind(index: Entry) -> str | None:
    """The next test's kind, alone or with its reason."""
    test = index.values.get("next_test")
    if test is None or isinstance(test, str):
        return test
    try:
        return index.entry("next_test").text("kind")
    except CampaignError:
        raise index.error("next_test", "expected null, or an object with a kind") from None


def _hours(index: Entry) -> float:
    """Of the next test; one where it isn't given."""
    test = index.values.get("next_test")
    if not isinstance(test, dict) or "hours" not in test:
        return 1.0
    return index.entry("next_test").number("hours", 0.0, math.inf)
