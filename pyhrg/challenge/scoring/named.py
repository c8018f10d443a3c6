"""Effects that a diagnosis names, compared with the truth: classes, families, and the field's
measures."""

import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass

from scipy.optimize import linear_sum_assignment

from pyhrg.challenge.scoring.figure import Figure, f1, mean, proportion
from pyhrg.challenge.truths.truth import Truth
from pyhrg.gap.effects.catalogue import EFFECTS
from pyhrg.gap.findings.diagnosis import Diagnosis

NAMED_PROBABILITY = 0.5
"""Posterior probability from which an equivalence class of causes counts as named (chosen)."""
ANSWERS = ("explained", "ambiguous")
"""Verdicts that exclude a cause outside the catalogue."""
FAMILIES = {name: effect.family for name, effect in EFFECTS.items()}
"""Family of each effect and known parameter by name. Noises are the gyro's."""
LEAST_PROBABILITY = 1e-3
"""Smallest probability that the log score takes, so that a name that is missing has one. Chosen."""


@dataclass(frozen=True)
class ScoredCase:
    """A truth with its diagnosis; `then` is the diagnosis with the next test."""

    name: str
    truth: Truth
    diagnosis: Diagnosis
    then: Diagnosis | None = None


@dataclass(frozen=True)
class RefusedCase:
    """A truth whose campaign was refused, with the sentence that said why."""

    name: str
    truth: Truth
    refusal: str


AnyCase = ScoredCase | RefusedCase


def list_answered(cases: Iterable[AnyCase]) -> list[ScoredCase]:
    """Cases that have a diagnosis."""
    return [case for case in cases if isinstance(case, ScoredCase)]


def merge_classes(diagnosis: Diagnosis) -> list[tuple[frozenset[str], float]]:
    """Equivalence classes of causes with their probabilities; a cause that is in another's class
    shares it."""
    merged: list[tuple[set[str], frozenset[str], float]] = []
    for cause in diagnosis.causes:
        causes, members, probability = {cause.effect}, cause.equivalence_class, cause.probability
        for other in [m for m in merged if cause.effect in m[1] or m[0] & members]:
            merged.remove(other)
            causes, members = causes | other[0], members | other[1]
            probability += other[2]
        merged.append((causes, members, probability))
    return [(members, min(1.0, probability)) for _, members, probability in merged]


def list_named(diagnosis: Diagnosis) -> list[frozenset[str]]:
    """Equivalence classes with a probability of at least `NAMED_PROBABILITY`."""
    return [effects for effects, p in merge_classes(diagnosis) if p >= NAMED_PROBABILITY]


def list_right(case: ScoredCase) -> dict[str, frozenset[str]]:
    """The named class that each true effect has for itself; effects without one are missing."""
    effects, named = case.truth.effects, list_named(case.diagnosis)
    misses = [[effect not in own for own in named] for effect in effects]
    pairs = zip(*linear_sum_assignment(misses), strict=True) if named and effects else ()
    return {effects[i]: named[j] for i, j in pairs if effects[i] in named[j]}


def list_wrong(case: ScoredCase) -> list[frozenset[str]]:
    """Named classes that are no true effect's, nor hold a known parameter that is off by more than
    its tolerance."""
    right, beyond = list_right(case).values(), set(case.truth.beyond)
    return [own for own in list_named(case.diagnosis) if own not in right and not own & beyond]


def is_wrong(case: ScoredCase) -> bool:
    """Something is named that is not there."""
    return bool(list_wrong(case))


def has_all_named(case: ScoredCase) -> bool:
    """Every true effect has a named class for itself."""
    return len(list_right(case)) == len(case.truth.effects)


def has_none_invented(case: ScoredCase) -> bool:
    """Nothing is named that is not there, and no cause without a name is stated."""
    return not is_wrong(case) and case.diagnosis.verdict in ANSWERS


def is_right(case: ScoredCase) -> bool:
    """Every true effect has a named class for itself, and nothing else is stated."""
    return has_all_named(case) and has_none_invented(case)


def is_unexplained(case: ScoredCase) -> bool:
    """The diagnosis states a cause outside the catalogue, whether it is material or not."""
    return case.diagnosis.unknown_probability >= NAMED_PROBABILITY


def is_family_right(case: ScoredCase) -> bool:
    """What is wrong is stated, and each named class has a member of a family that is wrong. A cause
    without a name is of the bench where its terms, or its true place, are, else of the gyro. A
    known parameter that is off by more than its tolerance need not be named."""
    truth, diagnosis = case.truth, case.diagnosis
    families = FAMILIES | {cause.effect: cause.family for cause in diagnosis.causes}
    stated = [{families.get(name, "gyro") for name in own} for own in list_named(diagnosis)]
    if is_unexplained(case):
        places = {term.place for term in diagnosis.terms}
        stated.append({"bench"} if places == {"bench"} else {"gyro"})
    faulty = "bench" if truth.place == "bench" else "gyro"
    true = {faulty} if truth.kind != "none" else set()
    is_found = all(any(family in own for own in stated) for family in true)
    true |= {FAMILIES[name] for name in truth.beyond}
    return is_found and all(own & true for own in stated)


def score_names(cases: Sequence[AnyCase], seed: int) -> list[Figure]:
    """The field's measures. Targets: the best of LISDD (F1), the winner of LiU-ICE at DX'25 (mean
    probability, and its logarithm), and issue 25 (false discoveries)."""
    answered = list_answered(cases)
    true = [list_true_probabilities(case) for case in cases if case.truth.kind in FAULTY]
    faulty = [case for case in cases if case.truth.kind in NAMEABLE]
    right = sum(len(list_right(case)) for case in list_answered(faulty))
    wrong = sum(len(list_wrong(case)) for case in answered)
    missing = sum(len(case.truth.effects) for case in faulty) - right
    extra = sum(len(list_wrong(case)) for case in list_answered(faulty))
    means = [sum(own) / len(own) for own in true]
    logs = [sum(math.log(max(p, LEAST_PROBABILITY)) for p in own) / len(own) for own in true]
    names = [True] * wrong + [False] * right
    return [
        f1("localisation F1", right, missing + extra, 0.80),
        proportion("false discovery rate of names", names, "at most", 0.05),
        proportion("mean probability on the true fault", means, "at least", 0.66),
        mean("log score of the true fault", logs, seed, "at least", math.log(0.66)),
    ]


NAMEABLE = ("single", "pair", "several")
"""Kinds of truths that the catalogue can name."""
FAULTY = (*NAMEABLE, "outside")
"""Kinds of truths with a fault that a diagnosis gives a probability to."""


def list_true_probabilities(case: AnyCase) -> list[float]:
    """Stated probability of each true effect, or of a cause outside the catalogue where that is
    true; 0 where the campaign was refused."""
    effects = case.truth.effects
    if isinstance(case, RefusedCase):
        return [0.0] * max(len(effects), 1)
    if not effects:
        return [case.diagnosis.unknown_probability]
    classes = merge_classes(case.diagnosis)
    return [max((p for own, p in classes if effect in own), default=0.0) for effect in effects]
