"""Search for the sets of effects and candidate terms that explain a residual.

A beam search: the best sets so far are extended by one group and reduced by one group, until all of
the best sets have been (docs/methods/evidence.md, "Search").
"""

import math
from collections.abc import Callable, Collection, Mapping, Sequence
from dataclasses import dataclass
from typing import TypeGuard

import numpy as np
from scipy.special import logsumexp

from pyhrg.gap.effects.candidate_terms import CandidateTerm
from pyhrg.gap.effects.catalogue import Effect
from pyhrg.gap.effects.design import Design
from pyhrg.gap.effects.jump import Jump
from pyhrg.gap.effects.linear_test import Group
from pyhrg.gap.evidence.evidence import (
    BEYOND_ODDS,
    EFFECT_ODDS,
    EQUIVALENCE_LOG_ODDS,
    UNNAMED_ODDS,
    Fit,
    fit,
)
from pyhrg.gap.evidence.extension import Extensions

Key = frozenset[int]
"""A set of groups, by their indices."""

MAX_EXTENSIONS = 24
"""Number of groups by which a set is extended: those with the highest score. Chosen."""
BEAM_WIDTH = 10
"""Number of best sets that are extended and reduced. Chosen."""
MAX_GROUPS = 12
"""Number of groups that a set may have. Chosen: the challenge plants up to 7."""
PRODUCT_WEIGHT = 0.02
"""Prior odds of a candidate term that is a product of two functions, over those of one function: of
two that explain as much the simpler one is the more probable. Chosen."""
MIN_PROBABILITY = 1e-12
"""Sets with a smaller posterior probability are not kept. Chosen."""
MAX_LOG_ODDS_BELOW_BEST = 30.0
"""Sets whose log posterior is further below the best are not extended: together they could not
reach a probability of 1e-10. Chosen."""


@dataclass(frozen=True)
class Ranking:
    """Sets by posterior probability, the most probable first.

    probabilities: posterior probability of each fit; they add up to 1 (Eq. (7)).
    log_evidence: log evidence of all sets together, over that of the empty set.
    """

    fits: tuple[Fit, ...]
    probabilities: tuple[float, ...]
    log_evidence: float

    @property
    def best(self) -> Fit:
        """The most probable set."""
        return self.fits[0]

    @property
    def groups(self) -> tuple[Group, ...]:
        """Groups of all sets, those of the most probable sets first."""
        return tuple(dict.fromkeys(group for fit in self.fits for group in fit.groups))

    def probability(self, *groups: Group) -> float:
        """Posterior probability that one of these groups takes part."""
        pairs = zip(self.fits, self.probabilities, strict=True)
        return sum(p for f, p in pairs if any(group in f.groups for group in groups))

    @property
    def unknown_probability(self) -> float:
        """Posterior probability that something outside the catalogue takes part."""
        return self.probability(*(g for g in self.groups if is_unnamed(g)))

    def list_near(self) -> list[Fit]:
        """Sets that are confounded with the most probable one, itself included."""
        threshold = self.probabilities[0] * math.exp(-EQUIVALENCE_LOG_ODDS)
        pairs = zip(self.fits, self.probabilities, strict=True)
        return [fit for fit, probability in pairs if probability > threshold]

    def list_replacements(self, effect: Effect) -> list[str]:
        """Names of effects that sets confounded with the most probable one have without this
        effect, and the most probable one has not."""
        others = [fit for fit in self.list_near() if effect not in fit.groups]
        return [e.name for fit in others for e in fit.named if e not in self.best.groups]


def is_unnamed(group: Group) -> TypeGuard[CandidateTerm]:
    """Whether it is neither an effect of the catalogue nor a fault of the bench."""
    return not isinstance(group, Effect) and group.fault is None


def rank_sets(
    design: Design,
    is_feasible: Callable[[Fit], bool] = lambda fit: True,
    start: Collection[Group] = (),
    required: Collection[Group] = (),
) -> Ranking:
    """Rank sets of all groups that the tests of a campaign can see at all, of those whose fits a
    gyro can have. A set that explained a similar design, and its effects alone, may be given to
    start from. Required groups are in every set, unless they are collinear."""
    groups = design.groups
    prior = list_prior_log_odds(groups)
    fits: dict[Key, tuple[Fit, float]] = {}
    refused: set[Key] = set()

    def evaluate(key: Key) -> None:
        if key in fits or key in refused:
            return
        fitted = fit(design, [groups[i] for i in sorted(key)])
        if fitted is None or not is_feasible(fitted):
            refused.add(key)
        else:
            fits[key] = fitted, fitted.log_evidence + sum(prior[i] for i in key)

    named = [i for i, group in enumerate(groups) if isinstance(group, Effect)]
    known = frozenset(i for i, group in enumerate(groups) if group in start)
    base = frozenset(i for i, group in enumerate(groups) if group in required)
    evaluate(base)
    base = base if base in fits else frozenset()
    starts = {base, base | known, base | known.intersection(named)}
    for key in starts:
        evaluate(key)

    def climb(allowed: Collection[int], reached: Collection[Key]) -> set[Key]:
        """Extend the best of these sets, and of those reached from them, by groups allowed."""
        extensions = Extensions(design, groups, prior, allowed)
        reached, extended = {key for key in reached if key in fits}, set[Key]()
        while due := _select_next({key: fits[key] for key in reached}, extended):
            extended.update(due)
            near = {key - {index} for key in due for index in key - base}
            for key in due:
                if len(key) < MAX_GROUPS:
                    near |= {key | {i} for i in extensions.list_best(key, MAX_EXTENSIONS)}
            for key in near:
                evaluate(key)
            reached |= near & fits.keys()
        return reached

    everything = range(len(groups))
    climb(everything, climb(named, {base, base | known.intersection(named)}) | starts)
    climb(everything, starts)  # sets of effects may have filled the beam
    return _normalize(list(fits.values()))


def _select_next(fits: Mapping[Key, tuple[Fit, float]], extended: Collection[Key]) -> list[Key]:
    """The best sets that were not extended yet, without those that are far below the best."""
    order = sorted(fits, key=lambda key: -fits[key][1])[:BEAM_WIDTH]
    threshold = fits[order[0]][1] - MAX_LOG_ODDS_BELOW_BEST
    is_first = len(extended) <= BEAM_WIDTH
    return [k for k in order if k not in extended and (is_first or fits[k][1] > threshold)]


def list_prior_log_odds(groups: Sequence[Group]) -> list[float]:
    """Prior log odds that each group takes part (Eq. (6))."""
    kinds = [_name_kind(group) for group in groups]
    weights = [PRODUCT_WEIGHT if _is_product(group) else 1.0 for group in groups]
    pairs = list(zip(kinds, weights, strict=True))
    whole = {kind: sum(weight for own, weight in pairs if own == kind) for kind in set(kinds)}
    odds = {
        "effect": EFFECT_ODDS,
        "known": BEYOND_ODDS,
        "term": UNNAMED_ODDS,
    }
    return [
        g.log_odds if isinstance(g, Jump) else math.log(odds[kind] * weight / whole[kind])
        for g, (kind, weight) in zip(groups, pairs, strict=True)
    ]


def _is_product(group: Group) -> bool:
    return isinstance(group, CandidateTerm) and bool(group.second)


def _name_kind(group: Group) -> str:
    if isinstance(group, Effect):
        return "effect" if group.family == "gyro" else "known"
    return "jump" if isinstance(group, Jump) else "term"


def _normalize(scored: Sequence[tuple[Fit, float]]) -> Ranking:
    """Posterior probabilities from log posteriors (Eq. (7))."""
    order = sorted(scored, key=lambda pair: -pair[1])
    scores = np.array([score for _, score in order])
    weights = np.exp(scores - logsumexp(scores))
    kept = weights > MIN_PROBABILITY
    return Ranking(
        tuple(f for (f, _), k in zip(order, kept, strict=True) if k),
        tuple(float(w) for w in weights[kept] / weights[kept].sum()),
        float(logsumexp(scores)),
    )
