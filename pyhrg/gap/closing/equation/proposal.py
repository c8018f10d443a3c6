"""Which candidate terms are proposed as an equation, with sizes, intervals and probabilities."""

import re
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from pyhrg.gap.closing.equation.forms import Basis, express_term
from pyhrg.gap.closing.equation.places import Acting, find_acting
from pyhrg.gap.effects.candidate_terms import CandidateTerm
from pyhrg.gap.evidence.evidence import Fit
from pyhrg.gap.evidence.noise.noise_hypothesis import NORMAL_95
from pyhrg.gap.evidence.posterior import Posterior
from pyhrg.gap.findings.term import Formula, Term

MAX_FALSE_DISCOVERY_RATE = 0.05
"""Expected share of false terms among the proposed ones, at most: the requirement's bound."""
MIN_RIVAL_PROBABILITY = 1e-3
"""Probability below which a rival form is not listed. Chosen."""


@dataclass(frozen=True)
class Coefficient:
    """One coefficient of a term.

    name: in `diagnosis.json`, with its unit; variable: of the written class, in SI.
    factor: SI of the channel per unit of the name.
    """

    name: str
    variable: str
    basis: Basis
    factor: float


def list_coefficients(term: CandidateTerm) -> tuple[Coefficient, ...]:
    """Coefficients of a term in the order of its columns; none if it can't be written."""
    acting = find_acting(term)
    return tuple(_make_coefficient(acting, basis) for basis in express_term(term))


def _make_coefficient(acting: Acting, basis: Basis) -> Coefficient:
    prefix = acting.variable.removeprefix("added")
    shown = {"Rate": "bias", "Angle": "readout"}.get(prefix, acting.place)
    shown = "frequency" if prefix == "Frequency" else shown
    unit = acting.unit + (f"_per_{basis.per}" if basis.per else "")
    words = f"{shown}_{basis.stem}"
    variable = re.sub("_(.)", lambda m: m[1].upper(), words)
    return Coefficient(f"{words}_{unit}", variable, basis, acting.factor)


def as_candidate(term: Term) -> CandidateTerm:
    """The candidate term that a proposed one stands for, for its expressions."""
    return CandidateTerm(term.channel, term.coordinates[0], term.function)


def select_discoveries(probabilities: Sequence[float]) -> list[int]:
    """Indices of the largest set of terms, the most probable first, whose mean probability of being
    false is at most `MAX_FALSE_DISCOVERY_RATE` (docs/methods/equation.md, Eq. 5)."""
    order = sorted(range(len(probabilities)), key=lambda i: -probabilities[i])
    false = np.cumsum([1 - probabilities[i] for i in order])
    # the mean of an ascending series ascends, so that the sets that are good come first
    return [i for n, i in enumerate(order, 1) if false[n - 1] <= n * MAX_FALSE_DISCOVERY_RATE]


def propose_terms(posterior: Posterior) -> tuple[Term, ...]:
    """Terms of the most probable set that are proposed, the most probable first; jumps, values for
    each power-on and noise are none."""
    best = posterior.best.ranking.best
    written = [g for g in best.groups if isinstance(g, CandidateTerm) and list_coefficients(g)]
    terms = make_terms(posterior, written)
    chosen = select_discoveries([term.discovery_probability for term in terms])
    return tuple(terms[i] for i in chosen)


def make_terms(posterior: Posterior, groups: Sequence[CandidateTerm]) -> list[Term]:
    """Candidate terms of the most probable set as proposed terms, whatever their probability."""
    best = posterior.best.ranking.best
    return [_make_term(posterior, best, group) for group in groups]


def _make_term(posterior: Posterior, best: Fit, term: CandidateTerm) -> Term:
    acting, coefficients = find_acting(term), list_coefficients(term)
    index = best.groups.index(term)
    factors = np.array([c.basis.scale / c.factor for c in coefficients])
    values = best.values[index] * factors
    half = NORMAL_95 * np.sqrt(np.diag(best.covariances[index])) * np.abs(factors)
    names = [c.name for c in coefficients]
    ends = zip((values - half).tolist(), (values + half).tolist(), strict=True)
    rivals = _list_rivals(posterior, best, term)
    probabilities = {r.words: _probability(posterior, r) for r in rivals}
    return Term(
        acting.place,
        (term.coordinate,),
        Formula(
            f"{acting.place}: " + " + ".join(f"{c.name} {c.basis.text}" for c in coefficients),
            " + ".join(f"{c.variable}*{c.basis.modelica}" for c in coefficients),
        ),
        dict(zip(names, values.tolist(), strict=True)),
        dict(zip(names, ends, strict=True)),
        _probability(posterior, term),
        _probability(posterior, term, *rivals),
        term.channel,
        term.function,
        {w: p for w, p in probabilities.items() if p >= MIN_RIVAL_PROBABILITY},
    )


def _list_rivals(posterior: Posterior, best: Fit, term: CandidateTerm) -> list[CandidateTerm]:
    """Other forms of the same coordinate and channel that some set has, and not the best one."""
    groups = {g for h in posterior.hypotheses for g in h.ranking.groups}
    same = [
        g
        for g in groups
        if isinstance(g, CandidateTerm)
        and (g.channel, g.coordinate) == (term.channel, term.coordinate)
        and g not in best.groups
    ]
    return sorted(same, key=lambda g: (-_probability(posterior, g), g.words))


def _probability(posterior: Posterior, *terms: CandidateTerm) -> float:
    """Posterior probability that one of these terms takes part."""
    pairs = zip(posterior.hypotheses, posterior.probabilities, strict=True)
    return min(1.0, sum(p * h.ranking.probability(*terms) for h, p in pairs))
