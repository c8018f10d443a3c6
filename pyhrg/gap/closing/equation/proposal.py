"""Which candidate terms are proposed as an equation, with sizes, intervals and probabilities."""

import re
from collections.abc import Mapping
from dataclasses import dataclass, replace

import numpy as np
from scipy.special import softmax

from pyhrg.gap.closing.equation.expressions import COORDINATE_OF, Basis, express_term
from pyhrg.gap.closing.equation.places import Acting, find_acting
from pyhrg.gap.closing.equation.series import Series, estimate_causes
from pyhrg.gap.effects.candidate_terms import CandidateTerm
from pyhrg.gap.effects.design import list_rival_terms
from pyhrg.gap.evidence.evidence import Fit, find_equivalents
from pyhrg.gap.evidence.noise.noise_hypothesis import NORMAL_95
from pyhrg.gap.evidence.posterior import Posterior
from pyhrg.gap.findings.term import Formula, Term

MAX_FALSE_DISCOVERY_RATE = 0.05
"""A term is proposed if it is false with at most this probability. The expected share of false
terms among those proposed is then no larger (docs/methods/equation.md, Eq. 5)."""


@dataclass(frozen=True)
class Coefficient:
    """One coefficient of a term.

    name: in `diagnosis.json`, with its unit; variable: of the written class, in SI.
    unit: end of the name, empty for a ratio.
    factor: SI of the channel per unit of the name.
    """

    name: str
    variable: str
    unit: str
    basis: Basis
    factor: float


def list_coefficients(term: CandidateTerm) -> tuple[Coefficient, ...]:
    """Coefficients of a term in the order of its columns; none if it can't be written."""
    return tuple(_make_coefficient(find_acting(term), basis) for basis in express_term(term))


def _make_coefficient(acting: Acting, basis: Basis) -> Coefficient:
    per = f"per_{basis.per}" if basis.per else ""
    words = f"{acting.stem}_{basis.stem}"
    variable = re.sub("_(.)", lambda m: m[1].upper(), words)
    unit = "_".join(part for part in (acting.unit, per) if part)
    return Coefficient(f"{words}_{unit}".rstrip("_"), variable, unit, basis, acting.factor)


def as_candidate(term: Term) -> CandidateTerm:
    """The candidate term that a proposed one stands for, for its expressions."""
    return CandidateTerm(term.channel, term.coordinates[0], term.function)


def list_written(term: Term) -> tuple[Coefficient, ...]:
    """Coefficients of a proposed term, those of its function first."""
    first = as_candidate(term)
    functions = [first, *(replace(first, function=words) for words in term.beside)]
    return tuple(c for function in functions for c in list_coefficients(function))


def propose_terms(posterior: Posterior) -> tuple[Term, ...]:
    """Terms of the most probable set that are proposed, the most probable first, with the forms
    that the records show beside them; jumps, values for each power-on and noise are none."""
    terms = make_terms(posterior, estimate_causes(posterior.best))
    sure = [t for t in terms if 1 - t.discovery_probability <= MAX_FALSE_DISCOVERY_RATE]
    return tuple(sorted(sure, key=lambda term: -term.discovery_probability))


def make_terms(posterior: Posterior, causes: Mapping[CandidateTerm, Series]) -> list[Term]:
    """Terms of the most probable set that can be written as proposed terms, whatever their
    probability."""
    best = posterior.best.ranking.best
    return [
        _make_term(posterior, best, group, series)
        for group, series in causes.items()
        if list_coefficients(group)
    ]


def _make_term(posterior: Posterior, best: Fit, term: CandidateTerm, series: Series) -> Term:
    rivals = _rank_rivals(posterior, best, term)
    discovery = _compute_probability(posterior, term, *rivals)
    acting = find_acting(term)
    coefficients = [c for function in series for c in list_coefficients(function)]
    factors = np.array([c.basis.scale / c.factor for c in coefficients])
    values = np.concatenate([e.size for e in series.values()]) * factors
    sigmas = np.concatenate([e.sigma for e in series.values()]) * np.abs(factors)
    half = NORMAL_95 * sigmas
    names = [c.name for c in coefficients]
    ends = zip((values - half).tolist(), (values + half).tolist(), strict=True)
    variables = (name for c in coefficients for name in c.basis.uses)
    return Term(
        acting.place,
        tuple(dict.fromkeys([term.coordinate, *(COORDINATE_OF[name] for name in variables)])),
        Formula(
            f"{acting.place}: " + " + ".join(f"{c.name} {c.basis.text}" for c in coefficients),
            " + ".join(f"{c.variable}*{c.basis.modelica}" for c in coefficients),
        ),
        dict(zip(names, values.tolist(), strict=True)),
        dict(zip(names, ends, strict=True)),
        discovery * (1 - sum(rivals.values())),
        discovery,
        term.channel,
        term.function,
        {rival.words: discovery * share for rival, share in rivals.items()},
        beside=tuple(other.function for other in series if other != term),
    )


def _rank_rivals(
    posterior: Posterior, best: Fit, term: CandidateTerm
) -> dict[CandidateTerm, float]:
    """Rival forms: candidate terms of the same channel that explain about as much in the place of
    the term. The share of each in the probability of the class, the most probable first."""
    design = posterior.best.design
    fits = find_equivalents(design, best, term, list_rival_terms(design, term))
    order = sorted(fits, key=lambda g: (-fits[g].log_evidence, g.words))
    shares = softmax([best.log_evidence, *(fits[g].log_evidence for g in order)])[1:]
    return dict(zip(order, shares.tolist(), strict=True))


def _compute_probability(posterior: Posterior, *terms: CandidateTerm) -> float:
    """Posterior probability that one of these terms takes part."""
    pairs = zip(posterior.hypotheses, posterior.probabilities, strict=True)
    return min(1.0, sum(p * h.ranking.probability(*terms) for h, p in pairs))
