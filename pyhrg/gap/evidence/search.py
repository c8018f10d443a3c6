"""Which sets of effects, named and unnamed, explain a residual: the best sets found so far are
extended and reduced until the best ones have all been."""

import math
from collections.abc import Callable, Collection, Mapping, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.special import logsumexp

from pyhrg.gap.effects.catalogue import Effect
from pyhrg.gap.effects.design import Design, Group
from pyhrg.gap.effects.jump import Jump
from pyhrg.gap.evidence.evidence import Fit, fit, least_left

Array = NDArray[np.float64]

TRIED = 24
"""Groups by which a set is extended."""
BEAM = 10
"""Best sets that are extended, and reduced."""
MOST = 12
"""Groups in a set."""
NAMED_ODDS = 0.25
"""Prior odds that some effect of the catalogue takes part."""
UNNAMED_ODDS = 0.05
"""Prior odds that something outside the catalogue takes part."""
IMPOSSIBLE = 1e-12
"""Weight of sets that are not kept."""
HOPELESS = 30.0
"""Sets whose evidence is this far below the best are let go."""


@dataclass(frozen=True)
class Ranked:
    """Sets by probability, the most probable first.

    probabilities: of each fit; they add up to 1.
    log_evidence: of all of them together, over that of nothing at all.
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
        """Of all sets, those of the most probable ones first."""
        return tuple(dict.fromkeys(group for fit in self.fits for group in fit.groups))

    def probability(self, *groups: Group) -> float:
        """That one of these groups takes part."""
        pairs = zip(self.fits, self.probabilities, strict=True)
        return sum(p for f, p in pairs if any(group in f.groups for group in groups))

    @property
    def unknown_probability(self) -> float:
        """That something outside the catalogue takes part."""
        pairs = zip(self.fits, self.probabilities, strict=True)
        return sum(p for f, p in pairs if any(not isinstance(g, Effect) for g in f.groups))


def ranked(design: Design, is_possible: Callable[[Fit], bool] = lambda fit: True) -> Ranked:
    """Search among all groups that the tests can see.

    Args:
        design: of a campaign.
        is_possible: whether a gyro can have a fit's sizes.
    """
    groups = design.groups
    odds = log_odds(groups)
    prior = [odds[g] for g in groups]
    found: dict[frozenset[int], tuple[Fit, float]] = {}
    refused: set[frozenset[int]] = set()

    def look_at(key: frozenset[int]) -> None:
        if key in found or key in refused:
            return
        fitted = fit(design, [groups[i] for i in sorted(key)])
        if fitted is None or not is_possible(fitted):
            refused.add(key)
        else:
            found[key] = fitted, fitted.log_evidence + sum(prior[i] for i in key)

    look_at(frozenset())
    extended: set[frozenset[int]] = set()
    while start := _next_best(found, extended):
        extended.update(start)
        for key in start:
            for index in key:
                look_at(key - {index})
            if len(key) < MOST:
                for index in _promising(design, groups, key, prior):
                    look_at(key | {index})
    return _normalised(list(found.values()))


def _next_best(
    found: Mapping[frozenset[int], tuple[Fit, float]], extended: Collection[frozenset[int]]
) -> list[frozenset[int]]:
    """Sets to be extended: of the best ones those that are not yet, and that are not hopeless."""
    order = sorted(found, key=lambda key: -found[key][1])[:BEAM]
    least = found[order[0]][1] - HOPELESS
    are_first = len(extended) <= BEAM
    return [k for k in order if k not in extended and (are_first or found[k][1] > least)]


def _promising(
    design: Design, groups: Sequence[Group], start: frozenset[int], prior: Sequence[float]
) -> list[int]:
    """Groups that would explain most of what a set leaves, the best first."""
    gram, pull = design.gram, design.pull
    if start:
        taken = np.concatenate([design.places[groups[i]] for i in start])
        across = np.linalg.solve(gram[np.ix_(taken, taken)], gram[taken])
        pull = pull - pull[taken] @ across
        gram = gram - gram[:, taken] @ across
    gains = {}
    for index, group in enumerate(groups):
        if index not in start:
            where = design.places[group]
            own = gram[where[:, None], where]
            gains[index] = _gain(own, pull[where], least_left(group)) / 2 + prior[index]
    return sorted(gains, key=lambda i: -gains[i])[:TRIED]


def _gain(gram: Array, pull: Array, least: float) -> float:
    """Power that columns explain beside others; none of what is left of them is too little."""
    if len(pull) == 1:
        return float(pull[0] ** 2 / gram[0, 0]) if gram[0, 0] > least else 0.0
    values, vectors = np.linalg.eigh(gram)
    along = vectors.T @ pull
    kept = values > least
    return float((along[kept] ** 2 / values[kept]).sum())


def log_odds(groups: Sequence[Group]) -> Mapping[Group, float]:
    """Prior log odds that each group takes part."""
    named = sum(isinstance(g, Effect) for g in groups)
    steady = sum(not isinstance(g, Effect | Jump) for g in groups)

    def prior(group: Group) -> float:
        if isinstance(group, Jump):
            return group.log_odds
        is_named = isinstance(group, Effect)
        return math.log(NAMED_ODDS / named if is_named else UNNAMED_ODDS / steady)

    return {group: prior(group) for group in groups}


def _normalised(pairs: Sequence[tuple[Fit, float]]) -> Ranked:
    order = sorted(pairs, key=lambda pair: -pair[1])
    scores = np.array([score for _, score in order])
    weights = np.exp(scores - logsumexp(scores))
    kept = weights > IMPOSSIBLE
    return Ranked(
        tuple(f for (f, _), k in zip(order, kept, strict=True) if k),
        tuple(float(w) for w in weights[kept] / weights[kept].sum()),
        float(logsumexp(scores)),
    )
