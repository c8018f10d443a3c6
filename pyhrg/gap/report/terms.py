"""Proposed terms: formula, place, size, what they remove, and the nearest known mechanisms."""

import html

from pyhrg.common.pages.markup import make_paragraph
from pyhrg.common.pages.svg import format_interval, format_number
from pyhrg.gap.closing.equation.proposal import Coefficient, as_candidate, list_coefficients
from pyhrg.gap.diagnose import CampaignDiagnosis
from pyhrg.gap.findings.term import Term
from pyhrg.gap.report.mechanisms import find_nearest
from pyhrg.gap.report.words import (
    PLACES,
    build_table,
    format_percent,
    format_term_unit,
    join_words,
)

NO_TERM = (
    "No term is proposed. closed.mo and closed.fmu hold the identified gyro with its causes alone."
)
MAX_RIVALS = 4
"""Most rival forms that the page names (chosen)."""
INTRODUCTION = (
    "What has no name gets an equation. closed.mo adds these terms to the identified gyro, and "
    "closed.fmu is that class, built. A coordinate in a formula is a pure number: a quantity over "
    "the unit that stands in the coefficient's unit. The numbers of mechanisms are those of "
    "HRG.UsersGuide.Mechanisms."
)


def build_terms(result: CampaignDiagnosis) -> str:
    """A part for each proposed term."""
    terms = result.diagnosis.terms
    if not terms:
        return make_paragraph(NO_TERM)
    return make_paragraph(INTRODUCTION) + "".join(_build_term(term) for term in terms)


def describe_term(term: Term) -> str:
    """Place, function and coefficients of a term in a sentence."""
    values = [
        f"{c.basis.text}: {_format_value(term, c)} {format_term_unit(c.unit)}".strip()
        for c in list_coefficients(as_candidate(term))
    ]
    return f"{name_term(term)}, without a name; {join_words(values)}"


def name_term(term: Term) -> str:
    """Place and function of a term."""
    return f"{PLACES[term.place]}: {term.function.rpartition(': ')[2]}"


def _format_value(term: Term, coefficient: Coefficient) -> str:
    name = coefficient.name
    return format_interval(term.parameters[name], *term.interval_95[name])


def describe_class(term: Term) -> str:
    """The probability of a term's form, and of what these tests can't tell from it."""
    stated = f"this form {format_percent(term.probability)}"
    if not term.rivals:
        return f"{stated}, no other form explains as much"
    others = [f"{words} {format_percent(p)}" for words, p in term.rivals.items()]
    count = f"{len(others)} other form{'s' if len(others) > 1 else ''}"
    if len(others) > MAX_RIVALS:
        others[MAX_RIVALS:] = [f"{len(others) - MAX_RIVALS} more (diagnosis.json)"]
    return (
        f"{stated}; together with {count} that these tests can't tell from it "
        f"{format_percent(term.discovery_probability)}: {join_words(others)}"
    )


def _build_term(term: Term) -> str:
    rows = [
        (c.variable, _format_value(term, c), format_term_unit(c.unit))
        for c in list_coefficients(as_candidate(term))
    ]
    shrink = (
        "on the held-out tests its channel has no excess over the noise floor"
        if term.shrink_percent is None
        else f"it removes {format_number(term.shrink_percent)} % of the excess over the noise "
        "floor that named causes leave on the held-out tests, in its channel"
    )
    nearest = "".join(
        f"<li>{html.escape(f'{m.name} ({m.number}; {m.source}). To tell: {m.test}.')}</li>"
        for m in find_nearest(term)
    )
    return (
        f"<h3>{html.escape(name_term(term))}</h3>"
        f"<p><code>{html.escape(term.formula.modelica)}</code></p>"
        + build_table("Coefficients", ("Coefficient", "Value (95 % interval)", "Unit"), rows)
        + make_paragraph(f"Probability: {describe_class(term)}. Held-out tests: {shrink}.")
        + (f"<p>Nearest known mechanisms:</p><ul>{nearest}</ul>" if nearest else "")
    )
