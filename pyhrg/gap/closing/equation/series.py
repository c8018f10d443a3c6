"""A cause as it is written: its terms, and the forms that the records show beside them.

A form is a multiple of its term's harmonic, or a Chebyshev polynomial of its term's function, which
is written in powers of this function (docs/methods/equation.md, Eq. 1a).
"""

import math
import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np

from pyhrg.common.arrays import Array
from pyhrg.gap.closing.equation.expressions import express_second, express_term
from pyhrg.gap.effects.candidate_terms import CandidateTerm
from pyhrg.gap.effects.catalogue import Effect
from pyhrg.gap.effects.design import select_groups
from pyhrg.gap.effects.form import Form
from pyhrg.gap.effects.known_parameters import KnownParameters
from pyhrg.gap.evidence.evidence import fit
from pyhrg.gap.evidence.hypothesis import Hypothesis


@dataclass(frozen=True)
class Estimate:
    """(d,) size of a term as it is written, and the standard deviation of its components."""

    size: Array
    sigma: Array


Series = Mapping[CandidateTerm, Estimate]
"""A term, first, and the functions beside it."""


def estimate_terms(hypothesis: Hypothesis) -> dict[CandidateTerm, Series]:
    """Each term of the most probable set alone, as the search has it."""
    best = hypothesis.ranking.best
    return {
        group: {group: Estimate(size, np.sqrt(np.diag(covariance)))}
        for group, size, covariance in zip(best.groups, best.values, best.covariances, strict=True)
        if isinstance(group, CandidateTerm)
    }


def estimate_causes(hypothesis: Hypothesis) -> dict[CandidateTerm, Series]:
    """Each term of the most probable set, with the forms beside it that the records show. A form
    that several terms have belongs to the first."""
    series, terms = estimate_terms(hypothesis), hypothesis.forms.terms
    for family in dict.fromkeys(term.family for term in terms):
        series |= _estimate_cause(hypothesis, [term for term in terms if term.family == family])
    return series


def _estimate_cause(
    hypothesis: Hypothesis, leaders: Sequence[CandidateTerm]
) -> dict[CandidateTerm, Series]:
    known, forms = _select_forms(hypothesis, leaders)
    if not forms:
        return {}
    groups = [*leaders, *forms]
    values, covariance = known.estimate_jointly(hypothesis.ranking.best.groups, groups)
    rows: dict[CandidateTerm, Array] = {}
    owners = {leader: leader for leader in leaders}
    units = iter(np.eye(len(values)))
    for group in groups:
        own = np.array([next(units) for _ in known.whole.columns[group]])
        origin = group.term if isinstance(group, Form) else group
        parts = expand_form(group) if isinstance(group, Form) else ((group, 1.0),)
        for term, factor in parts:
            rows[term] = rows.get(term, 0.0) + factor * own
            owners.setdefault(term, origin if origin in leaders else leaders[0])
    estimates = {
        term: Estimate(row @ values, np.sqrt(np.diag(row @ covariance @ row.T)))
        for term, row in rows.items()
    }
    return {
        leader: {term: e for term, e in estimates.items() if owners[term] == leader}
        for leader in leaders
    }


def _select_forms(
    hypothesis: Hypothesis, leaders: Sequence[CandidateTerm]
) -> tuple[KnownParameters, list[Form]]:
    """Forms of a cause that can be written, added one by one while the most probable set grows more
    probable with the best of them, each with odds of one over their number; and what is known with
    these alone."""
    known, best = hypothesis.known, hypothesis.ranking.best.groups
    own = {effect: known.tolerances[effect] for effect in known.effects if effect not in best}
    forms = [form for form in hypothesis.forms.sigmas if form in known.whole.groups]
    free = [f for f in forms if f.family == leaders[0].family and any(expand_form(f))]
    groups = [*dict.fromkeys((*own, *best, *leaders, *free))]
    whole = select_groups(known.whole, groups)

    def restrict(chosen: Sequence[Form]) -> KnownParameters:
        tolerances: dict[Effect | Form, float] = dict(own.items())
        tolerances.update((form, hypothesis.forms.sigmas[form]) for form in chosen)
        return KnownParameters(whole, tolerances, tuple(leaders))

    def score(chosen: Sequence[Form]) -> float:
        marginal = restrict(chosen).marginal
        fitted = fit(marginal, best)
        return marginal.log_likelihood + fitted.log_evidence if fitted else -math.inf

    chosen, reached = list[Form](), score(())
    log_odds = -math.log(len(free)) if free else 0.0
    while free:
        rivals = {form: score([*chosen, form]) for form in free}
        form = max(free, key=lambda f: rivals[f])
        if rivals[form] + log_odds <= reached:
            break
        free.remove(form)
        chosen, reached = [*chosen, form], rivals[form]
    return restrict(chosen), chosen


def expand_form(form: Form) -> Iterator[tuple[CandidateTerm, float]]:
    """Terms, and their sizes for a size of 1 of a form; none if it can't be written."""
    if form.is_multiple:
        multiple = form.degree * (form.harmonic or 0)
        words = re.sub(r"harmonic \d+", f"harmonic {multiple}", form.function)
        yield CandidateTerm(form.channel, form.coordinate, words, multiple), 1 / form.largest
    elif express_term(form.term):
        for power, weight in enumerate(form.polynomial, 1):
            if weight:
                size = float(weight) / form.largest / form.reach ** (power - 1)
                yield replace(form.term, function=_raise_words(form, power)), size


def _raise_words(form: Form, power: int) -> str:
    """A form's function with a power of what is bent, up to the largest value of this that the
    tests have, in the unit of its basis function."""
    if power == 1:
        return form.function
    before, separator, function = form.function.rpartition(", times " if form.second else ": ")
    (basis,) = (express_second(form.term),) if form.second else express_term(form.term)
    return f"{before}{separator}power {power} of {function} to {form.reach / basis.scale:.6g}"
