"""What diagnoses are worth, against the truths."""

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from itertools import pairwise, permutations

from pyhrg.challenge.scoring.calibration import calibration
from pyhrg.challenge.scoring.coordinates import COORDINATES
from pyhrg.challenge.scoring.diagnosis import Cause, Diagnosis
from pyhrg.challenge.scoring.figure import Figure, Sense, proportion, quantile
from pyhrg.challenge.truths.truth import LEAST, Truth
from pyhrg.device.keys import KEYS
from pyhrg.gap.effects.catalogue import EFFECTS

ANSWERS = ("explained", "ambiguous")
"""Verdicts that name effects as all there is."""
EDGES = (1.0, 1.5, 2.0, 3.0, 4.0, LEAST, 10.0, 20.0, math.inf)
"""Of the strengths that a curve's points stand for, sigmas."""


@dataclass(frozen=True)
class Judged:
    """A truth and what was said of it; `then` is said with the suggested next test as well."""

    name: str
    truth: Truth
    diagnosis: Diagnosis
    then: Diagnosis | None = None


@dataclass(frozen=True)
class Point:
    """Singles within a range of strengths, sigmas: how many were rightly named."""

    low: float
    high: float
    right: Figure


def figures(cases: Sequence[Judged], seed: int) -> list[Figure]:
    """All figures that the challenge is held to.

    Args:
        cases: of any kinds.
        seed: of the resampling.
    """
    by_kind: dict[str, list[Judged]] = {}
    for case in cases:
        by_kind.setdefault(case.truth.kind, []).append(case)
    none, outside, left_out = (by_kind.get(kind, []) for kind in ("none", "outside", "left_out"))
    single, pair, several = (by_kind.get(kind, []) for kind in ("single", "pair", "several"))
    known = single + pair
    strong = none + known + outside
    ratios = [ratio for ratio in map(after_over_noise, known) if ratio is not None]
    settled = [is_settled(case) for case in known if case.then]
    return [
        _share("false alarm without a gap", none, is_alarm, "at most", 0.02),
        _share("single: right effect or its class", single, is_right, "at least", 0.95),
        _share("pair: right effects or their classes", pair, is_right, "at least", 0.90),
        _share("several: right effects or their classes", several, is_right, "at least", 0.90),
        _share("outside: recognised", outside, is_unexplained, "at least", 0.85),
        _share("outside: blamed on a named effect", outside, is_blamed, "at most", 0.10),
        _share("left out: none of these, or a stand-in", left_out, is_owned, "at least", 0.85),
        proportion(
            "95 % intervals that cover",
            [covered for case in known for covered in coverage(case)],
            "about",
            0.95,
        ),
        calibration("calibration error", [claims(c) for c in strong], seed, "at most", 0.05),
        quantile("held-out residual over noise, median", ratios, 0.5, "at most", 1.1),
        quantile("held-out residual over noise, 90 %", ratios, 0.9, "at most", 1.3),
        proportion("next test settles the class", settled, "at least", 0.95),
    ]


def curve(cases: Sequence[Judged]) -> list[Point]:
    """How often one effect is rightly named, by its strength."""
    single = [case for case in cases if case.truth.kind in ("single", "weak")]
    points = []
    for low, high in pairwise(EDGES):
        within = [case for case in single if low <= case.truth.strengths[0] < high]
        points.append(Point(low, high, _share("right", within, is_right, "at least", 0.0)))
    return points


def _share(
    name: str,
    cases: Sequence[Judged],
    judge: Callable[[Judged], bool],
    sense: Sense,
    target: float,
) -> Figure:
    return proportion(name, [judge(case) for case in cases], sense, target)


def is_alarm(case: Judged) -> bool:
    """A gap was said to be there."""
    return case.diagnosis.verdict != "no_gap"


def is_unexplained(case: Judged) -> bool:
    """Something outside the catalogue was said to take part."""
    return case.diagnosis.verdict == "unexplained"


def is_blamed(case: Judged) -> bool:
    """Named effects were said to be all there is."""
    return case.diagnosis.verdict in ANSWERS


def is_right(case: Judged) -> bool:
    """As many classes were named as there are effects, each with one of them in it."""
    named = case.diagnosis.named
    if case.diagnosis.verdict not in ANSWERS or len(named) != len(case.truth.effects):
        return False
    held = [[effect in effects for effects in named] for effect in case.truth.effects]
    return _matched(held)


def _matched(held: Sequence[Sequence[bool]]) -> bool:
    """Whether rows can each have a column of their own."""
    orders = permutations(range(len(held)))
    return any(all(row[i] for row, i in zip(held, order, strict=True)) for order in orders)


def is_owned(case: Judged) -> bool:
    """An effect that the catalogue had no more was none of these, in a coordinate that it shows
    in, or was taken for one that does the same to these tests."""
    truth, diagnosis = case.truth, case.diagnosis
    if is_unexplained(case):
        return coordinate(diagnosis) in COORDINATES[truth.effects[0]]
    named, stand_ins = diagnosis.named, set(truth.stand_ins)
    return is_blamed(case) and bool(named) and all(effects & stand_ins for effects in named)


def coordinate(diagnosis: Diagnosis) -> str | None:
    """Where the greatest share of the gap lies."""
    shares: dict[str, float] = {}
    for name, share in diagnosis.where:
        shares[name] = shares.get(name, 0.0) + share
    return max(shares, key=lambda name: shares[name]) if shares else None


def after_over_noise(case: Judged) -> float | None:
    """What is left of the held-out output angle after closing, over what the noise in these very
    records leaves of a perfect simulation."""
    after, noise = case.diagnosis.holdout_after_arcsec, case.truth.holdout_noise_arcsec
    return None if after is None or noise is None else after / noise


def is_settled(case: Judged) -> bool:
    """With the next test, every effect was named alone."""
    if case.then is None or case.then.verdict != "explained":
        return False
    return {frozenset({e}) for e in case.truth.effects} == set(case.then.named)


def claims(case: Judged) -> list[tuple[float, bool]]:
    """Every probability that was given, and whether it was so."""
    outside = case.truth.kind == "outside"
    unknown = [(case.diagnosis.unknown_probability, outside)]
    true = set(case.truth.effects)
    return [(p, bool(effects & true)) for effects, p in case.diagnosis.classes] + unknown


def coverage(case: Judged) -> list[bool]:
    """Whether each interval of an effect that is there holds the truth."""
    there = [cause for cause in case.diagnosis.causes if cause.effect in case.truth.effects]
    return [covered for cause in there for covered in _covered(cause, case.truth.parameters)]


def _covered(cause: Cause, truth: Mapping[str, float]) -> list[bool]:
    return [
        _within(truth[name], ends, _turn(cause.effect, name))
        for name, ends in cause.interval_95.items()
        if name in truth
    ]


def _within(value: float, ends: tuple[float, float], turn: float) -> bool:
    """Whether a value, or one that means the same, is within an interval."""
    low, high = ends
    if math.isfinite(turn):
        value = low + (value - low) % turn
    return low <= value <= high


def _turn(effect: str, name: str) -> float:
    """After which an angle means the same, in the file's unit; infinite for what is no angle."""
    entry = EFFECTS.get(effect)
    if entry is None or not entry.periods:
        return math.inf
    key = next(key for key in KEYS if key.name == name)
    return 360.0 / entry.periods if key.field == entry.fields[1] else math.inf
