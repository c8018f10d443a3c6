"""Every explanation of a record beside every other: noise terms, unknowns, and both.

The evidence ratio of the mixture of all explanations with one part to "as believed" is 1 or less
on average over records that are as believed. It therefore exceeds 1/a in a share of at most a of
them (Markov's inequality): the false-alarm rate is bounded without any simulation.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import combinations

import numpy as np
from numpy.typing import NDArray
from scipy.special import logsumexp

from pyhrg.gap.static_record.fit.evidence import Posterior, Problem, posterior
from pyhrg.gap.static_record.fit.likelihood import whitened
from pyhrg.gap.static_record.fit.unknowns import Unknown, competitors

Array = NDArray[np.float64]

FALSE_ALARMS = 0.02
"""Share of records as believed that may be called a gap, at most."""
EACH = 0.2
"""Odds of each further part of an explanation."""
PAIRS = 2
"""Likeliest pairs of noise terms that a third is added to."""
KEPT = 6
"""Likeliest sets of noise terms that unknowns are added to."""


@dataclass(frozen=True)
class Hypothesis:
    """Noise terms that exceed belief, maybe with an unknown on top; log of evidence and prior."""

    terms: Posterior
    unknown: Unknown | None
    log_weight: float


@dataclass(frozen=True)
class Judgement:
    """log_ratio: of the mixture of one-part explanations to belief; null: belief alone;
    hypotheses, the likeliest first, with probabilities; those of no gap among them."""

    log_ratio: float
    null: Posterior
    hypotheses: tuple[Hypothesis, ...]
    probabilities: Array
    unknowns: tuple[Unknown, ...]
    """Beside belief alone."""

    @property
    def best(self) -> Posterior:
        """The likeliest noise terms."""
        return self.hypotheses[0].terms

    def probability_of(self, effect: int) -> float:
        """That a noise term exceeds belief and nothing unknown takes part."""
        chosen = [effect in h.terms.extra and h.unknown is None for h in self.hypotheses]
        return float(np.sum(self.probabilities[chosen]))

    @property
    def unknown_probability(self) -> float:
        """That something unknown takes part."""
        chosen = [h.unknown is not None for h in self.hypotheses]
        return float(np.sum(self.probabilities[chosen]))

    def share_of(self, name: str) -> float:
        """Probability of one unknown."""
        chosen = [h.unknown is not None and h.unknown.name == name for h in self.hypotheses]
        return float(np.sum(self.probabilities[chosen]))


def judged(problem: Problem, seed: int = 0, false_alarms: float = FALSE_ALARMS) -> Judgement:
    """Weigh explanations; those of several parts only where one part alone raises the alarm.

    Args:
        problem: the record and its belief.
        seed: of the samples.
        false_alarms: as `FALSE_ALARMS`.
    """
    null = posterior(problem, (), seed)
    singles = [posterior(problem, (i,), seed) for i in range(problem.effects)]
    unknowns = unknowns_beside(null)
    named = [s.log_evidence - null.log_evidence for s in singles]
    others = [u.log_ratio for u in unknowns]
    log_ratio = float(logsumexp([_mean(named), _mean(others)]) - np.log(2))
    terms = [null, *singles]
    if log_ratio > -np.log(false_alarms):
        pairs = [posterior(problem, s, seed) for s in combinations(range(problem.effects), 2)]
        terms += [*pairs, *(posterior(problem, s, seed) for s in _larger(pairs, problem.effects))]
    return _weighed(log_ratio, null, terms, unknowns)


def _larger(pairs: list[Posterior], effects: int) -> list[tuple[int, ...]]:
    """Sets of three that hold one of the likeliest pairs."""
    best = sorted(pairs, key=lambda p: -p.log_evidence)[:PAIRS]
    sets = {frozenset({*p.extra, more}) for p in best for more in range(effects)}
    return sorted(tuple(sorted(s)) for s in sets if len(s) == 3)


def _mean(logs: Sequence[float]) -> float:
    return float(logsumexp(logs) - np.log(len(logs)))


def unknowns_beside(terms: Posterior) -> tuple[Unknown, ...]:
    """Competitors for what noise terms at their likeliest levels leave."""
    return competitors(whitened(terms.problem.data, *terms.best))


def _weighed(
    log_ratio: float, null: Posterior, terms: list[Posterior], unknowns: tuple[Unknown, ...]
) -> Judgement:
    plain = [Hypothesis(t, None, t.log_evidence + len(t.extra) * np.log(EACH)) for t in terms]
    plain.sort(key=lambda h: -h.log_weight)
    more = [
        Hypothesis(h.terms, u, h.log_weight + u.log_ratio + np.log(EACH / len(unknowns)))
        for h in plain[:KEPT]
        for u in (unknowns if h.terms is null else unknowns_beside(h.terms))
    ]
    every = sorted([*plain, *more], key=lambda h: -h.log_weight)
    logs = np.array([h.log_weight for h in every])
    probabilities = np.exp(logs - logsumexp(logs))
    return Judgement(log_ratio, null, tuple(every), probabilities, unknowns)
