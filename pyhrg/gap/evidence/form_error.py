"""What candidate terms may miss because a cause without a name has another form than they have.

Under each noise, sets are ranked again beside the forms that the terms of the most probable set may
have in truth (docs/methods/evidence.md, Eq. 10a).
"""

from collections.abc import Sequence

from pyhrg.common.arrays import Array
from pyhrg.device.device import Device
from pyhrg.gap.effects.candidate_terms import CandidateTerm, Family
from pyhrg.gap.effects.design import measure_power
from pyhrg.gap.effects.form import find_forms
from pyhrg.gap.effects.jump import Jump
from pyhrg.gap.effects.linear_test import LinearTest
from pyhrg.gap.evidence.hypothesis import NO_ERROR, FormError, Hypothesis, rank_under_noise
from pyhrg.gap.evidence.noise.noise_hypothesis import NoiseHypothesis

FORM_ERROR = 0.03
"""Standard deviation of each form's size, over the magnitude of the cause. Chosen."""
MAX_ROUNDS = 6
"""Rankings after which the most probable hypothesis is kept. Chosen."""
NEGLIGIBLE_CHI2 = 1.0
"""Error, as chi-square, that counts as zero: the power of a row's noise. Chosen."""


def rank_with_forms(
    noise: NoiseHypothesis,
    nominal: Device,
    parts: Sequence[LinearTest],
    start: Hypothesis | None = None,
) -> Hypothesis:
    """Rank sets under a noise beside the forms of the causes for which the terms of the most
    probable set stand, until these terms stay. Forms of one more cause are allowed at a time, the
    strongest first: what one term misses may look like many others. Where sets come back, the most
    probable hypothesis is kept of those that have all terms whose forms they have. The search may
    start from a hypothesis."""
    ranked: dict[tuple[CandidateTerm, ...], Hypothesis] = {}
    forms, known = (start.forms, start.ranking.best.groups) if start else (NO_ERROR, ())
    for _ in range(MAX_ROUNDS):
        hypothesis = rank_under_noise(noise, nominal, parts, start=known, forms=forms)
        ranked[forms.terms] = hypothesis
        known, before = hypothesis.ranking.best.groups, forms.terms
        forms = _allow_forms(hypothesis, parts)
        if forms.terms == before:
            return hypothesis
        if forms.terms in ranked:
            break
    whole = [h for h in ranked.values() if set(h.forms.terms) <= set(h.ranking.best.groups)]
    return max(whole, key=lambda h: h.log_posterior, default=hypothesis)


def _allow_forms(hypothesis: Hypothesis, parts: Sequence[LinearTest]) -> FormError:
    """Forms of the causes for which large terms stand: of those that had them before, and of the
    strongest other one."""
    by_family: dict[Family, dict[CandidateTerm, Array]] = {}
    for term, size in list_large_terms(hypothesis).items():
        by_family.setdefault(term.family, {})[term] = size
    powers = {
        family: measure_power(hypothesis.exact.whole, sizes) for family, sizes in by_family.items()
    }
    allowed = {term.family for term in hypothesis.forms.terms}
    new = sorted(powers.keys() - allowed, key=lambda family: -powers[family])[:1]
    kept = [sizes for family, sizes in by_family.items() if family in (*allowed, *new)]
    tests = [part.where for part in parts]
    sigmas = {
        form: FORM_ERROR * magnitude
        for sizes in kept
        for form, magnitude in find_forms(sizes, tests).items()
    }
    terms = sorted((term for sizes in kept for term in sizes), key=lambda term: term.words)
    return FormError(sigmas, tuple(terms))


def list_large_terms(hypothesis: Hypothesis) -> dict[CandidateTerm, Array]:
    """Size of each term of the most probable set whose form error is not negligible."""
    design = hypothesis.exact.whole
    return {
        term: size
        for term, size in hypothesis.ranking.best.sizes.items()
        if isinstance(term, CandidateTerm) and not isinstance(term, Jump)
        if not term.is_of_each_power_on
        if FORM_ERROR**2 * measure_power(design, {term: size}) > NEGLIGIBLE_CHI2
    }
