"""What candidate terms may miss because a cause without a name has another form than they have.

Under each noise, sets are ranked again beside the forms that the terms of the most probable set may
have in truth (docs/methods/evidence.md, Eq. 10a).
"""

from collections.abc import Sequence

from pyhrg.common.arrays import Array
from pyhrg.device.device import Device
from pyhrg.gap.effects.candidate_terms import CandidateTerm
from pyhrg.gap.effects.design import LinearTest, measure_power
from pyhrg.gap.effects.form import Form, find_forms
from pyhrg.gap.effects.jump import Jump
from pyhrg.gap.evidence.hypothesis import Hypothesis, rank_under_noise
from pyhrg.gap.evidence.noise.noise_hypothesis import NoiseHypothesis

FORM_ERROR = 0.03
"""Standard deviation of each form's size, over the magnitude of the cause. Chosen."""
NEGLIGIBLE_CHI2 = 1.0
"""Error, as chi-square, that counts as zero: the power of a row's noise. Chosen."""


def rank_with_forms(
    noise: NoiseHypothesis,
    nominal: Device,
    parts: Sequence[LinearTest],
    start: Hypothesis | None = None,
) -> Hypothesis:
    """Rank sets under a noise beside the forms of the most probable set's terms, until these terms
    stay. Where they come back instead, the most probable hypothesis is kept. The search may start
    from a hypothesis."""
    ranked: dict[frozenset[CandidateTerm], Hypothesis] = {}
    terms = frozenset(list_large_terms(start) if start else ())
    forms, known = (start.forms, start.ranking.best.groups) if start else ({}, ())
    while terms not in ranked:
        hypothesis = rank_under_noise(noise, nominal, parts, start=known, forms=forms)
        ranked[terms] = hypothesis
        terms, known = frozenset(list_large_terms(hypothesis)), hypothesis.ranking.best.groups
        forms = _allow_forms(hypothesis, parts)
    if ranked[terms] is hypothesis:
        return hypothesis
    return max(ranked.values(), key=lambda h: h.log_posterior)


def _allow_forms(hypothesis: Hypothesis, parts: Sequence[LinearTest]) -> dict[Form, float]:
    """Forms of the causes for which large terms stand, with the standard deviations of their
    sizes."""
    by_family: dict[tuple[str, str, str], dict[CandidateTerm, Array]] = {}
    for term, size in list_large_terms(hypothesis).items():
        by_family.setdefault(term.family, {})[term] = size
    tests = [part.where for part in parts]
    return {
        form: FORM_ERROR * magnitude
        for sizes in by_family.values()
        for form, magnitude in find_forms(sizes, tests).items()
    }


def list_large_terms(hypothesis: Hypothesis) -> dict[CandidateTerm, Array]:
    """Size of each term of the most probable set whose form error is not negligible."""
    design = hypothesis.exact.whole
    return {
        term: size
        for term, size in hypothesis.ranking.best.sizes.items()
        if isinstance(term, CandidateTerm) and not isinstance(term, Jump)
        if not term.is_of_each_power_on
        if FORM_ERROR**2 * measure_power(design, term, size) > NEGLIGIBLE_CHI2
    }
