"""Comparison of all explanations of a record: noise terms, unknowns, and both together
(docs/methods/noise.md, Eq. 9 to 11 and 13).

The Bayes factor of the mixture of all explanations with one part to "as believed" is 1 or less on
average over records that are as believed. By Markov's inequality it exceeds 1/a in a share of at
most a of them, so the false-alarm rate is bounded without simulation.

Unknowns are explanations that are no noise term. Each is an alternative to the standard normal
distribution of the whitened coefficients, with its size marginalised. Over white records its Bayes
factor to "white" is 1 or less on average.
"""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from itertools import combinations

import numpy as np
from scipy.fft import idct
from scipy.special import gammaln, logsumexp

from pyhrg.common.arrays import Array
from pyhrg.gap.static_record.fit.evidence import Posterior, Problem, compute_posterior
from pyhrg.gap.static_record.fit.likelihood import whiten_coefficients

PRIOR_SHAPES = np.geomspace(0.5, 2000.0, 13)
"""Shapes of the inverse gamma distributions, mean about 1, that the prior of a variance mixes with
equal weights (chosen)."""
LINE_POWERS = np.geomspace(3.0, 3e6, 13)
"""Variances of a line's two coefficients over that of the noise, with equal prior weights
(chosen)."""
TIME_BLOCKS = 16
"""Blocks of time whose powers are compared (chosen)."""
MIN_COEFFICIENTS = 8
"""Smallest number of coefficients in a block of time (chosen)."""


@dataclass(frozen=True)
class Unknown:
    """An unknown explanation, its coordinate as in a diagnosis, and the natural logarithm of its
    Bayes factor to white noise."""

    name: str
    coordinate: str
    log_ratio: float


def split_octaves(m: int) -> list[slice]:
    """Octaves of m coefficients from the highest frequencies down. The 16 or fewer slowest
    coefficients are one octave."""
    edges = [m]
    while edges[-1] > 16:
        edges.append(edges[-1] // 2)
    return [slice(low, high) for high, low in zip(edges, [*edges[1:], 0], strict=True)]


def sum_octaves(coefficients: Array) -> tuple[Array, Array]:
    """(k,) sum of squares of the coefficients in each octave, and (k,) their number."""
    bands = split_octaves(len(coefficients))
    power = np.array([np.sum(coefficients[band] ** 2) for band in bands])
    return power, np.array([band.stop - band.start for band in bands])


def assess_unknowns(white: Array) -> tuple[Unknown, ...]:
    """All unknowns of (m,) whitened coefficients."""
    return _assess_excess(white), _assess_line(white), _assess_time_variation(white)


def _assess_excess(white: Array) -> Unknown:
    """Power that differs from the noise model, octave by octave."""
    parts = _average(_compute_log_marginals(*sum_octaves(white)))
    return Unknown("excess in the spectrum", "noise", _combine_parts(parts))


def _assess_line(white: Array) -> Unknown:
    """One periodic signal: two neighbouring coefficients that are too large, at any frequency
    (Eq. 10)."""
    variance = 1 + LINE_POWERS[:, np.newaxis]
    power = white[1:] ** 2 + white[:-1] ** 2
    logs = -np.log(variance) + power / 2 * (1 - 1 / variance)
    return Unknown("periodic signal", "time", float(_average(_average(logs))))


def _assess_time_variation(white: Array) -> Unknown:
    """Power that changes over the record, in each octave by itself; its mean is free (Eq. 11)."""
    bands = [
        band
        for band in split_octaves(len(white))
        if band.stop - band.start >= MIN_COEFFICIENTS * TIME_BLOCKS
    ]
    # the transform is orthonormal, so an octave's time series is white if its coefficients are
    parts = [_compute_time_log_ratio(idct(white[band], norm="ortho")) for band in bands]
    return Unknown("noise that changes with time", "time", _combine_parts(np.array(parts)))


def _compute_time_log_ratio(values: Array) -> float:
    """Log Bayes factor of blocks of time whose variances are drawn from one inverse gamma
    distribution."""
    blocks = np.array_split(values / np.sqrt(np.mean(values**2)), TIME_BLOCKS)
    power = np.array([np.sum(block**2) for block in blocks])
    count = np.array([len(block) for block in blocks])
    return float(_average(np.sum(_compute_log_marginals(power, count), axis=1)))


def _compute_log_marginals(power: Array, count: Array) -> Array:
    """(13, k) log Bayes factors of k unknown variances to variances of 1, for sums of `count`
    squares: in closed form for an inverse gamma prior of each shape and of equal scale (Eq. 9)."""
    shape, half = PRIOR_SHAPES[:, np.newaxis], count / 2
    return np.asarray(
        gammaln(shape + half)
        - gammaln(shape)
        + shape * np.log(shape)
        - (shape + half) * np.log(shape + power / 2)
        + power / 2
    )


def _average(logs: Array) -> Array:
    """Logarithm of the mean over the first axis."""
    return np.asarray(logsumexp(logs, axis=0) - np.log(len(logs)))


def _combine_parts(logs: Array) -> float:
    """Log Bayes factor of independent parts, each of which is white with probability 1/2."""
    return float(np.sum(np.logaddexp(0.0, logs) - np.log(2)))


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


def rank_explanations(
    problem: Problem, seed: int = 0, false_alarms: float = FALSE_ALARMS
) -> Ranking:
    """Compute the posterior probabilities of all explanations. Those of several parts are added
    only where those of one part raise the alarm, as at most the share `false_alarms` of records as
    believed does."""
    null = compute_posterior(problem, (), seed)
    singles = [compute_posterior(problem, (i,), seed) for i in range(problem.effects)]
    unknowns = compare_unknowns_beside(null)
    of_terms = [s.log_evidence - null.log_evidence for s in singles]
    of_unknowns = [u.log_ratio for u in unknowns]
    log_ratio = float(logsumexp([_log_mean(of_terms), _log_mean(of_unknowns)]) - np.log(2))
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


def _log_mean(logs: Sequence[float]) -> float:
    return float(logsumexp(logs) - np.log(len(logs)))


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
