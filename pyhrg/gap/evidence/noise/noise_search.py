"""Search for the noises of the output angle beyond the stated one."""

from collections.abc import Sequence
from dataclasses import replace

from pyhrg.gap.effects.catalogue import NOISES, NoiseEffect
from pyhrg.gap.evidence.evidence import EQUIVALENCE_LOG_ODDS
from pyhrg.gap.evidence.noise.noise_hypothesis import (
    AddedNoise,
    NoiseHypothesis,
    UnnamedNoise,
    fit_unnamed_noise,
)
from pyhrg.gap.evidence.noise.noise_levels import build_likelihood
from pyhrg.gap.evidence.noise.noise_posterior import NoisePosterior
from pyhrg.gap.evidence.residuals import Residual
from pyhrg.gap.whitening.whitening import NoiseModel
from pyhrg.noise.coefficients import COEFFICIENT_NAMES


def fit_rival_noises(
    residuals: Sequence[Residual], stated: NoiseModel, noises: Sequence[NoiseEffect]
) -> list[NoiseHypothesis]:
    """The most probable noise, from the residual of the output angle in each test: noises of the
    catalogue beyond the stated noise, or an unnamed one with or without them. Then the same without
    each of its noises; and after one with an unnamed noise that of the catalogue's noises alone,
    and without each of several."""
    likelihood = build_likelihood(residuals)
    posterior = NoisePosterior(likelihood, stated)
    plain = _assemble(posterior, _find_named(posterior, noises))
    bases = [(plain.noise, plain.log_prior)] + ([(stated, 0.0)] if plain.added else [])
    unnamed = fit_unnamed_noise(likelihood, bases)
    beside = NoisePosterior(likelihood, unnamed.add_to(stated))
    rival = _assemble(beside, _find_named(beside, noises), unnamed)
    log_odds = likelihood(rival.noise) + rival.log_prior
    log_odds -= likelihood(plain.noise) + plain.log_prior
    if log_odds <= 0:
        return [plain, *_drop_each(posterior, plain.added)]
    fewer = _drop_each(beside, rival.added, unnamed)
    named = [plain, *(_drop_each(posterior, plain.added) if len(plain.added) > 1 else ())]
    return [rival, *fewer, _assemble(posterior, rival.added), *named]


def _find_named(posterior: NoisePosterior, noises: Sequence[NoiseEffect]) -> tuple[AddedNoise, ...]:
    """Noises of the catalogue, added one by one while the odds are for the best of them."""
    added: list[AddedNoise] = []
    for _ in COEFFICIENT_NAMES:
        candidates = posterior.fit_best(posterior.adjust_levels(added), added, noises)
        best = max(candidates, key=lambda a: a.log_odds, default=None)
        if best is None or best.log_odds < 0:
            break
        added = posterior.refit_added([*added, best])
    return tuple(added)


def _drop_each(
    posterior: NoisePosterior, added: tuple[AddedNoise, ...], unnamed: UnnamedNoise | None = None
) -> list[NoiseHypothesis]:
    """Hypotheses without one of the added noises, one for each."""
    fewer = [tuple(a for a in added if a is not dropped) for dropped in added]
    return [_assemble(posterior, kept, unnamed) for kept in fewer]


def _assemble(
    posterior: NoisePosterior,
    added: tuple[AddedNoise, ...],
    unnamed: UnnamedNoise | None = None,
) -> NoiseHypothesis:
    """A hypothesis of these noises, with the stated levels adjusted beside them. An unnamed one is
    part of the posterior's stated noise."""
    noise = posterior.adjust_levels(added)
    log_prior = sum(a.log_prior for a in added) + posterior.log_prior(noise, added)
    return NoiseHypothesis(
        noise, added, log_prior + (unnamed.log_prior if unnamed else 0.0), unnamed
    )


def find_noise_equivalents(
    hypothesis: NoiseHypothesis,
    residuals: Sequence[Residual],
    stated: NoiseModel,
    noises: Sequence[NoiseEffect] = NOISES,
) -> NoiseHypothesis:
    """The hypothesis, which was fitted to these residuals, with the equivalents of each added noise
    filled in."""
    if hypothesis.unnamed:
        stated = hypothesis.unnamed.add_to(stated)
    posterior = NoisePosterior(build_likelihood(residuals), stated)
    added = []
    for noise in hypothesis.added:
        others = [a for a in hypothesis.added if a != noise]
        candidates = posterior.fit_best(posterior.adjust_levels(others), others, noises)
        log_odds = {a.effect: a.log_odds for a in candidates}
        threshold = log_odds.pop(noise.effect) - EQUIVALENCE_LOG_ODDS
        names = tuple(e.name for e, odds in log_odds.items() if odds > threshold)
        added.append(replace(noise, equivalents=names))
    return replace(hypothesis, added=tuple(added))
