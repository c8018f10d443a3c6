"""Comparison of all explanations of a record: noise terms, unknowns, and both together
(docs/methods/noise.md, Eq. 13).

The Bayes factor of the mixture of all explanations with one part to "as believed" is 1 or less on
average over records that are as believed. By Markov's inequality it exceeds 1/a in a share of at
most a of them, so the false-alarm rate is bounded without simulation.
"""

from collections.abc import Iterable
from dataclasses import dataclass
from itertools import combinations

import numpy as np
from scipy.special import logsumexp

from pyhrg.common.arrays import Array
from pyhrg.gap.static_record.fit.evidence import Posterior, Problem, compute_posterior
from pyhrg.gap.static_record.fit.likelihood import whiten_coefficients
from pyhrg.gap.static_record.fit.unknowns import Unknown, assess_unknowns, average_logs

FALSE_ALARMS = 0.02
"""Largest share of records as believed that are called a gap (chosen)."""
PART_ODDS = 0.2
"""Prior odds of each further part of an explanation (chosen)."""
EXTENDED_PAIRS = 2
"""Number of the most probable pairs of noise terms that a third term is added to (chosen)."""
EXTENDED_SETS = 6
"""Number of the most probable sets of noise terms that unknowns are added to (chosen)."""


@dataclass(frozen=True)
class Hypothesis:
    """Noise terms that exceed the belief, with or without an unknown; log_weight: natural logarithm
    of evidence times prior."""

    terms: Posterior
    unknown: Unknown | None
    log_weight: float


@dataclass(frozen=True)
class Ranking:
    """All explanations of a record.

    log_ratio: natural logarithm of the Bayes factor of the mixture of one-part explanations to
        the belief.
    null: the belief alone.
    hypotheses: all explanations, that of no gap among them, the most probable first.
    probabilities: posterior probability of each hypothesis.
    unknowns: the unknowns beside the belief alone.
    """

    log_ratio: float
    null: Posterior
    hypotheses: tuple[Hypothesis, ...]
    probabilities: Array
    unknowns: tuple[Unknown, ...]

    def get_probability(self, effect: int) -> float:
        """Probability that a noise term exceeds the belief and no unknown takes part."""
        return self._sum(effect in h.terms.extra and h.unknown is None for h in self.hypotheses)

    @property
    def unknown_probability(self) -> float:
        """Probability that an unknown takes part."""
        return self._sum(h.unknown is not None for h in self.hypotheses)

    def get_unknown_probability(self, name: str) -> float:
        """Probability that the unknown of this name takes part."""
        return self._sum(h.unknown is not None and h.unknown.name == name for h in self.hypotheses)

    def _sum(self, chosen: Iterable[bool]) -> float:
        return float(np.sum(self.probabilities[list(chosen)]))


def rank_explanations(problem: Problem, seed: int, false_alarms: float) -> Ranking:
    """Compute the posterior probabilities of all explanations. Those of several parts are added
    only where those of one part raise the alarm, as at most the share `false_alarms` of records as
    believed does."""
    null = compute_posterior(problem, (), seed)
    singles = [compute_posterior(problem, (i,), seed) for i in range(problem.effects)]
    unknowns = compare_unknowns_beside(null)
    of_terms = [s.log_evidence - null.log_evidence for s in singles]
    of_unknowns = [u.log_ratio for u in unknowns]
    log_ratio = float(average_logs([average_logs(of_terms), average_logs(of_unknowns)]))
    terms = [null, *singles]
    if log_ratio > -np.log(false_alarms):
        sets = combinations(range(problem.effects), 2)
        pairs = [compute_posterior(problem, s, seed) for s in sets]
        triples = _extend_pairs(pairs, problem.effects)
        terms += [*pairs, *(compute_posterior(problem, s, seed) for s in triples)]
    return _add_unknowns(log_ratio, null, terms, unknowns)


def _extend_pairs(pairs: list[Posterior], effects: int) -> list[tuple[int, ...]]:
    """Sets of three terms that contain one of the most probable pairs."""
    best = sorted(pairs, key=lambda p: -p.log_evidence)[:EXTENDED_PAIRS]
    sets = {frozenset({*p.extra, more}) for p in best for more in range(effects)}
    return sorted(tuple(sorted(s)) for s in sets if len(s) == 3)


def compare_unknowns_beside(terms: Posterior) -> tuple[Unknown, ...]:
    """The unknowns in a record that is whitened with noise terms at their posterior mean."""
    return assess_unknowns(whiten_coefficients(terms.problem.data, *terms.best))


def _add_unknowns(
    log_ratio: float, null: Posterior, terms: list[Posterior], unknowns: tuple[Unknown, ...]
) -> Ranking:
    plain = [Hypothesis(t, None, t.log_evidence + len(t.extra) * np.log(PART_ODDS)) for t in terms]
    plain.sort(key=lambda h: -h.log_weight)
    extended = [
        Hypothesis(h.terms, u, h.log_weight + u.log_ratio + np.log(PART_ODDS / len(unknowns)))
        for h in plain[:EXTENDED_SETS]
        for u in (unknowns if h.terms is null else compare_unknowns_beside(h.terms))
    ]
    hypotheses = sorted([*plain, *extended], key=lambda h: -h.log_weight)
    logs = np.array([h.log_weight for h in hypotheses])
    probabilities = np.exp(logs - logsumexp(logs))
    return Ranking(log_ratio, null, tuple(hypotheses), probabilities, unknowns)
