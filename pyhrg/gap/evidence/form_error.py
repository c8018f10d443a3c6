"""What candidate terms may miss because a cause without a name has another form than they have.

Under each noise, sets are ranked again beside the forms that the terms of the most probable set may
have in truth (docs/methods/evidence.md, Eq. 10a).
"""

import math
from collections.abc import Sequence
from typing import TypeGuard

from pyhrg.common.arrays import Array
from pyhrg.gap.effects.candidate_terms import CandidateTerm, Family
from pyhrg.gap.effects.catalogue import Effect, NoiseEffect
from pyhrg.gap.effects.design import Sizes, build_design, measure_power, select_groups
from pyhrg.gap.effects.form import Form, find_forms
from pyhrg.gap.effects.jump import Jump
from pyhrg.gap.effects.known_parameters import KnownParameters
from pyhrg.gap.effects.linear_test import Group, LinearTest
from pyhrg.gap.evidence.evidence import Fit, fit
from pyhrg.gap.evidence.hypothesis import FormError, Hypothesis, rank_under_noise
from pyhrg.gap.evidence.noise.noise_hypothesis import NoiseHypothesis
from pyhrg.gap.evidence.noise.noise_search import fit_rival_noises
from pyhrg.gap.evidence.residuals import compute_residuals
from pyhrg.gap.evidence.search import MAX_GROUPS, list_prior_log_odds
from pyhrg.gap.whitening.channel_noise import build_angle_noise

FORM_ERROR = 0.03
"""Standard deviation of each form's size, over the magnitude of the cause. Chosen."""
MAX_ROUNDS = 6
"""Rankings after which the most probable hypothesis is kept. Chosen."""
MAX_LEADERS = 6
"""Number of single terms whose forms are tried. Chosen."""
NEGLIGIBLE_CHI2 = 1.0
"""Error, as chi-square, that counts as zero: the power of a row's noise. Chosen."""


def rank_with_forms(
    noise: NoiseHypothesis, parts: Sequence[LinearTest], start: Hypothesis
) -> Hypothesis:
    """Rank sets under a noise beside the forms of the causes for which terms stand. The search
    starts from a hypothesis."""
    known = start.ranking.best.groups
    first = rank_under_noise(noise, parts, start=known, forms=start.forms)
    return _settle_forms({first.forms.terms: first}, first, first.ranking.best, parts)


def rank_anew(
    noise: NoiseHypothesis,
    parts: Sequence[LinearTest],
    noises: Sequence[NoiseEffect],
) -> Hypothesis:
    """`rank_with_forms` without a hypothesis to start from.

    Where more noise is more probable than a swarm, sets are ranked under that. Where the most
    probable set has terms, the search also starts from the single term that explains most beside
    its own forms: a swarm of effects and terms may explain about as much as one cause.
    """
    first = rank_under_noise(noise, parts)
    if _is_swarm(first.ranking.best):
        removed = dict[Group, Array](first.effect_sizes.items())
        noise, *_ = suggest_noises(first, removed, parts, noises)
        rival = rank_under_noise(noise, parts)
        first = max(first, rival, key=lambda h: h.log_posterior)
    ranked = {first.forms.terms: first}
    rivals = [_settle_forms(ranked, first, first.ranking.best, parts)]
    if any(map(_is_term, first.ranking.best.groups)):
        single = _fit_single_cause(first, parts)
        rivals.append(_settle_forms(ranked, first, single, parts))
    return max(rivals, key=lambda h: h.log_posterior)


def suggest_noises(
    hypothesis: Hypothesis,
    removed: Sizes,
    parts: Sequence[LinearTest],
    noises: Sequence[NoiseEffect],
) -> list[NoiseHypothesis]:
    """Noises that the residual without these groups of a hypothesis suggests (`fit_rival_noises`),
    the most probable first. The known parameters were estimated under the hypothesis' noise, so
    that the residual alone does not decide between these."""
    noise, error = hypothesis.channel_noise, hypothesis.design.model_error
    residuals = compute_residuals(parts, removed, noise, ("gyro_angle",), error)
    return fit_rival_noises(residuals, build_angle_noise(parts[0].nominal), noises)


def _is_swarm(best: Fit) -> bool:
    """Whether a set is full: its terms stand for no cause."""
    return len(best.groups) == MAX_GROUPS


def _is_term(group: Group) -> TypeGuard[CandidateTerm]:
    return (
        isinstance(group, CandidateTerm)
        and not isinstance(group, Jump)
        and not group.is_of_each_power_on
    )


def _fit_single_cause(first: Hypothesis, parts: Sequence[LinearTest]) -> Fit:
    """The single term that explains most beside its own forms, of those that do so alone."""
    design = first.design
    fits = (fit(design, [group]) for group in design.groups if _is_term(group))
    seen = sorted((f for f in fits if f), key=lambda f: -f.explained)[:MAX_LEADERS]
    errors = [_allow_forms(f, first, parts) for f in seen]
    forms = {form: None for error in errors for form in error.sigmas}
    error = first.known.whole.model_error
    whole = build_design(parts, first.channel_noise, error, forms=tuple(forms))

    def score(fitted: Fit, error: FormError) -> float:
        known = first.known.tolerances.items()
        tolerances: dict[Effect | Form, float] = {g: s for g, s in known if isinstance(g, Effect)}
        tolerances.update(error.sigmas.items())
        own = select_groups(whole, [*dict.fromkeys((*tolerances, *fitted.groups, *error.terms))])
        marginal = KnownParameters(own, tolerances, error.terms).marginal
        alone = fit(marginal, fitted.groups)
        return marginal.log_likelihood + alone.log_evidence if alone else -math.inf

    return max(zip(seen, errors, strict=True), key=lambda pair: score(*pair))[0]


def _settle_forms(
    ranked: dict[tuple[CandidateTerm, ...], Hypothesis],
    first: Hypothesis,
    best: Fit,
    parts: Sequence[LinearTest],
) -> Hypothesis:
    """Rank sets again beside the forms of the causes for which the terms of a set stand, then of
    the most probable set without the terms that forms make needless, until these terms stay. Forms
    of one more cause are allowed at a time, the strongest first: what one term misses may look like
    many others. Where sets come back, the most probable hypothesis is kept. A swarm has no forms.
    `ranked` are hypotheses by the terms that have forms; new ones are added."""
    if _is_swarm(best):
        return first
    hypothesis = first
    for _ in range(MAX_ROUNDS):
        forms = _allow_forms(best, hypothesis, parts)
        if forms.terms == hypothesis.forms.terms:
            return hypothesis
        if forms.terms in ranked:
            break
        hypothesis = rank_under_noise(first.noise, parts, start=best.groups, forms=forms)
        ranked[forms.terms], best = hypothesis, _drop_needless(hypothesis)
    whole = [h for h in ranked.values() if set(h.forms.terms) <= set(h.ranking.best.groups)]
    return max(whole, key=lambda h: h.log_posterior, default=hypothesis)


def _drop_needless(hypothesis: Hypothesis) -> Fit:
    """The most probable set without those terms that are less probable beside the forms than
    without, the worst first; one term stays."""
    design, best = hypothesis.design, hypothesis.ranking.best
    prior = dict(zip(design.groups, list_prior_log_odds(design.groups), strict=True))

    def score(fitted: Fit) -> float:
        return fitted.log_evidence + sum(prior[group] for group in fitted.groups)

    while True:
        terms = [group for group in hypothesis.forms.terms if group in best.groups]
        rivals = [fit(design, [g for g in best.groups if g != term]) for term in terms]
        fewer = max((f for f in rivals if f), key=score, default=best)
        if len(terms) < 2 or score(fewer) <= score(best):
            return best
        best = fewer


def _allow_forms(best: Fit, hypothesis: Hypothesis, parts: Sequence[LinearTest]) -> FormError:
    """Forms of the causes for which large terms of a set stand: of those that the hypothesis has,
    and of the strongest other one."""
    by_family: dict[Family, dict[CandidateTerm, Array]] = {}
    for term, size in list_large_terms(best, hypothesis).items():
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


def list_large_terms(best: Fit, hypothesis: Hypothesis) -> dict[CandidateTerm, Array]:
    """Size of each term of a set whose form error is not negligible."""
    design = hypothesis.exact.whole
    return {
        term: size
        for term, size in best.sizes.items()
        if _is_term(term)
        if FORM_ERROR**2 * measure_power(design, {term: size}) > NEGLIGIBLE_CHI2
    }
