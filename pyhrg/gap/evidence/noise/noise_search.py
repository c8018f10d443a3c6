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
from pyhrg.gap.evidence.noise.noise_levels import log_likelihood
from pyhrg.gap.evidence.noise.noise_posterior import NoisePosterior
from pyhrg.gap.evidence.residuals import Residual
from pyhrg.gap.whitening.whitening import NoiseModel
from pyhrg.noise.coefficients import COEFFICIENT_NAMES


def fit_rival_noises(
    residuals: Sequence[Residual], stated: NoiseModel, noises: Sequence[NoiseEffect]
) -> list[NoiseHypothesis]:
    """The most probable noise, from the residual of the output angle in each test: noises of the
    catalogue beyond the stated noise, or an unnamed one with or without them. After one with an
    unnamed noise, that of the catalogue's noises alone."""
    plain = _assemble(residuals, stated, _find_named(residuals, stated, noises), None)
    bases = [(plain.noise, plain.log_prior)] + ([(stated, 0.0)] if plain.added else [])
    unnamed = fit_unnamed_noise(residuals, bases)
    named = _find_named(residuals, unnamed.add_to(stated), noises)
    rival = _assemble(residuals, stated, named, unnamed)
    log_odds = _log_posterior(residuals, rival) - _log_posterior(residuals, plain)
    if log_odds <= 0:
        return [plain]
    return [replace(rival, unnamed=replace(unnamed, log_odds=log_odds)), plain]


def _log_posterior(residuals: Sequence[Residual], hypothesis: NoiseHypothesis) -> float:
    return log_likelihood(residuals, hypothesis.noise) + hypothesis.log_prior


def _find_named(
    residuals: Sequence[Residual], stated: NoiseModel, noises: Sequence[NoiseEffect]
) -> tuple[AddedNoise, ...]:
    """Noises of the catalogue, added one by one while the odds are for the best of them."""
    posterior = NoisePosterior(residuals, stated)
    added: list[AddedNoise] = []
    for _ in COEFFICIENT_NAMES:
        candidates = posterior.fit_best(posterior.adjust_levels(added), added, noises)
        best = max(candidates, key=lambda a: a.log_odds, default=None)
        if best is None or best.log_odds < 0:
            break
        added = posterior.refit_added([*added, best])
    return tuple(added)


def drop_each_noise(
    hypothesis: NoiseHypothesis, residuals: Sequence[Residual], stated: NoiseModel
) -> list[NoiseHypothesis]:
    """Hypotheses without one of the noises of one fitted to these residuals, one for each noise."""
    named, unnamed = hypothesis.added, hypothesis.unnamed
    fewer = [(tuple(a for a in named if a is not dropped), unnamed) for dropped in named]
    fewer += [(named, None)] if unnamed else []
    return [_assemble(residuals, stated, *kept) for kept in fewer]


def _assemble(
    residuals: Sequence[Residual],
    stated: NoiseModel,
    added: tuple[AddedNoise, ...],
    unnamed: UnnamedNoise | None,
) -> NoiseHypothesis:
    """A hypothesis of these noises, with the stated levels adjusted beside them."""
    posterior = NoisePosterior(residuals, unnamed.add_to(stated) if unnamed else stated)
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
    posterior = NoisePosterior(residuals, stated)
    added = []
    for noise in hypothesis.added:
        others = [a for a in hypothesis.added if a != noise]
        candidates = posterior.fit_best(posterior.adjust_levels(others), others, noises)
        log_odds = {a.effect: a.log_odds for a in candidates}
        threshold = log_odds.pop(noise.effect) - EQUIVALENCE_LOG_ODDS
        names = tuple(e.name for e, odds in log_odds.items() if odds > threshold)
        added.append(replace(noise, equivalents=names))
    return replace(hypothesis, added=tuple(added))
