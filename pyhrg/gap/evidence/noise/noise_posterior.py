"""Posterior density of the output angle's noise, and the noises that are added to the stated one.

The stated levels of white noise and angle random walk have log-normal priors (Eq. (13) of
docs/methods/evidence.md). The level of an added noise is integrated out by Laplace's method (Eq.
(12)).
"""

import math
from collections.abc import Sequence
from dataclasses import dataclass

from scipy.optimize import minimize_scalar

from pyhrg.gap.effects.catalogue import NoiseEffect
from pyhrg.gap.evidence.evidence import NOISE_ODDS
from pyhrg.gap.evidence.noise.noise_hypothesis import NORMAL_95, AddedNoise
from pyhrg.gap.evidence.noise.noise_levels import (
    Likelihood,
    are_equal,
    fit_level,
)
from pyhrg.gap.whitening.whitening import NoiseModel
from pyhrg.noise.coefficients import COEFFICIENT_NAMES

STATED_PARTS = ("angle_random_walk", "angle_white_noise")
"""Parts of the noise whose stated levels may be somewhat wrong."""
STATED_LEVEL_SIGMA = 0.03
"""Standard deviation of the logarithm of a stated level; a difference of this order is no gap.
Chosen."""
PASSES = 2
"""Number of times that each level is found given the others. Chosen."""
MAX_DEVIATION = 9.0
"""Largest deviation of a stated level, in units of `STATED_LEVEL_SIGMA`. Chosen: beyond any that
the prior lets happen."""
DEVIATION_PRECISION = 0.02
"""Precision of that deviation, in the same units. Chosen."""


@dataclass(frozen=True)
class NoisePosterior:
    """Posterior density of noises, given the likelihood of residuals of the output angle and the
    stated noise."""

    likelihood: Likelihood
    stated: NoiseModel

    def adjust_levels(self, added: Sequence[AddedNoise]) -> NoiseModel:
        """The stated levels at their most probable values, beside the added noises at theirs."""
        noise = self.set_levels(added)
        replaced = {a.effect.field for a in added}
        parts = [p for p in STATED_PARTS if p not in replaced and getattr(self.stated, p) > 0]
        for part in parts * PASSES:

            def misfit(x: float, part: str = part, noise: NoiseModel = noise) -> float:
                level = getattr(self.stated, part) * math.exp(STATED_LEVEL_SIGMA * x)
                return x**2 / 2 - self.likelihood(noise.at(part, level))

            bounds, options = (-MAX_DEVIATION, MAX_DEVIATION), {"xatol": DEVIATION_PRECISION}
            best = float(minimize_scalar(misfit, bounds=bounds, options=options).x)
            noise = noise.at(part, getattr(self.stated, part) * math.exp(STATED_LEVEL_SIGMA * best))
        return noise

    def set_levels(self, added: Sequence[AddedNoise]) -> NoiseModel:
        """The stated noise with the added noises at their levels."""
        noise = self.stated
        for a in added:
            noise = noise.at(a.effect.field, a.total)
        return noise

    def log_prior(self, noise: NoiseModel, added: Sequence[AddedNoise], part: str = "") -> float:
        """Log prior of the stated levels, without those that an added noise replaces (Eq. (13)),
        and without that of `part`."""
        total = 0.0
        replaced = {a.effect.field for a in added} | {part}
        for name in STATED_PARTS:
            stated = getattr(self.stated, name)
            if name not in replaced and stated > 0:
                total -= (math.log(getattr(noise, name) / stated) / STATED_LEVEL_SIGMA) ** 2 / 2
        return total

    def log_density(self, noise: NoiseModel, added: Sequence[AddedNoise], part: str = "") -> float:
        """Log likelihood plus log prior of the stated levels; arguments as of `log_prior`."""
        return self.likelihood(noise) + self.log_prior(noise, added, part)

    def fit_best(
        self, noise: NoiseModel, added: Sequence[AddedNoise], effects: Sequence[NoiseEffect]
    ) -> list[AddedNoise]:
        """Each effect that may be added to a noise, at its most probable level.

        Where the stated levels were adjusted, they may have been adjusted in an effect's stead.
        Each effect is therefore tried beside the unadjusted levels too.
        """
        base = self.log_density(noise, added)
        unadjusted = self.set_levels(added)
        bases = [noise] if are_equal(noise, unadjusted) else [noise, unadjusted]
        present = {a.effect for a in added}
        candidates = [e for e in effects if e.field in COEFFICIENT_NAMES and e not in present]
        return [
            max((self.fit_added(n, base, e, added) for n in bases), key=lambda a: a.log_odds)
            for e in candidates
        ]

    def refit_added(self, added: Sequence[AddedNoise]) -> list[AddedNoise]:
        """Added noises, each at its most probable level given the others, without those that the
        others make improbable."""
        kept = list(added)
        for effect in [a.effect for a in added] * PASSES:
            others = [a for a in kept if a.effect != effect]
            if len(others) == len(kept):
                continue
            base = self.log_density(self.adjust_levels(others), others)
            refitted = self.fit_added(self.adjust_levels(kept), base, effect, others)
            kept = [*others, refitted] if refitted.log_odds >= 0 else others
        return kept

    def fit_added(
        self, noise: NoiseModel, base: float, effect: NoiseEffect, added: Sequence[AddedNoise]
    ) -> AddedNoise:
        """An effect at its most probable level beside a noise, which holds other added noises;
        `base` is the log density without the effect."""
        part = effect.field
        stated = getattr(self.stated, part)

        def gain(logarithm: float) -> float:
            total = math.hypot(stated, math.exp(logarithm))
            return self.log_density(noise.at(part, total), added, part) - base

        level = fit_level(gain, effect.scale)
        low, total, high = (
            math.hypot(stated, math.exp(level.logarithm + s * NORMAL_95 * level.sigma))
            for s in (-1, 0, 1)
        )
        log_prior = level.log_prior(NOISE_ODDS)
        return AddedNoise(effect, total, (low, high), level.gain + log_prior, log_prior)
