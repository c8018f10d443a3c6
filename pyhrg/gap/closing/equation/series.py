"""A cause as it is written: its terms, and the forms that the records show beside them.

A form is a multiple of its term's harmonic, or a Chebyshev polynomial of its term's function, which
is written in powers of this function (docs/methods/equation.md, Eq. 1a).
"""

import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.polynomial import chebyshev

from pyhrg.common.arrays import Array
from pyhrg.gap.closing.equation.forms import express_term
from pyhrg.gap.effects.candidate_terms import CandidateTerm
from pyhrg.gap.effects.form import Form
from pyhrg.gap.evidence.form_error import NEGLIGIBLE_CHI2
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
        for group, size, covariance in zip(
            best.groups, best.values, best.covariances, strict=True
        )
        if isinstance(group, CandidateTerm)
    }


def estimate_causes(hypothesis: Hypothesis) -> dict[CandidateTerm, Series]:
    """Each term of the most probable set, with the forms beside it that change the records by a
    chi-square of at least `NEGLIGIBLE_CHI2`. Forms that several terms have belong to the first."""
    series = estimate_terms(hypothesis)
    for family in dict.fromkeys(term.family for term in hypothesis.forms.terms):
        leaders = [term for term in hypothesis.forms.terms if term.family == family]
        series |= _estimate_cause(hypothesis, leaders)
    return series


def _estimate_cause(
    hypothesis: Hypothesis, leaders: Sequence[CandidateTerm]
) -> dict[CandidateTerm, Series]:
    best, known = hypothesis.ranking.best, hypothesis.known
    forms = [
        form
        for form, chi2 in known.measure_forms(best.sizes).items()
        if chi2 >= NEGLIGIBLE_CHI2 and form.family == leaders[0].family and list(expand_form(form))
    ]
    if not forms:
        return {}
    values, covariance = known.estimate_jointly(best.groups, [*leaders, *forms])
    rows: dict[CandidateTerm, Array] = {}
    owners = {leader: leader for leader in leaders}
    start = 0
    for group in (*leaders, *forms):
        count = len(known.whole.columns[group])
        own = np.eye(len(values))[start : start + count]
        start += count
        leader = group.term if isinstance(group, Form) and group.term in leaders else leaders[0]
        parts = expand_form(group) if isinstance(group, Form) else ((group, 1.0),)
        for term, factor in parts:
            rows[term] = rows.get(term, 0.0) + factor * own
            owners.setdefault(term, leader)
    estimates = {
        term: Estimate(row @ values, np.sqrt(np.diag(row @ covariance @ row.T)))
        for term, row in rows.items()
    }
    return {
        leader: {term: e for term, e in estimates.items() if owners[term] == leader}
        for leader in leaders
    }


def expand_form(form: Form) -> Iterator[tuple[CandidateTerm, float]]:
    """Terms, and their sizes for a size of 1 of a form; none if it can't be written."""
    if form.degree == 1:
        if express_term(form.term):
            yield form.term, 1 / form.largest
    elif form.size == 1:
        place, colon, function = form.function.rpartition(": ")
        powers = chebyshev.cheb2poly(np.eye(form.degree + 1)[form.degree])
        for power in (p for p in range(1, form.degree + 1) if powers[p]):
            words = function if power == 1 else f"power {power} of {function}"
            term = replace(form.term, function=place + colon + words)
            yield term, float(powers[power]) / form.largest**power
    elif form.harmonic:
        multiple = form.degree * form.harmonic
        words = re.sub(r"harmonic \d+", f"harmonic {multiple}", form.function)
        yield CandidateTerm(form.channel, form.coordinate, words, multiple), 1 / form.largest
