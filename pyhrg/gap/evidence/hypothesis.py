"""A hypothesis: a noise of the output angle, and the sets of effects ranked under it."""

import math
from collections.abc import Callable, Collection, Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from pyhrg.common.arrays import Array
from pyhrg.device.device import Device
from pyhrg.gap.effects.candidate_terms import CandidateTerm
from pyhrg.gap.effects.catalogue import Effect
from pyhrg.gap.effects.design import (
    Design,
    TestChannel,
    build_design,
    compute_model_error,
    discount_model_error,
)
from pyhrg.gap.effects.form import Form
from pyhrg.gap.effects.jump import Jump
from pyhrg.gap.effects.known_parameters import KnownParameters
from pyhrg.gap.effects.linear_test import Group, LinearTest
from pyhrg.gap.evidence.evidence import NO_GROUPS, Fit
from pyhrg.gap.evidence.jump_search import find_jumps, find_steps
from pyhrg.gap.evidence.noise.noise_hypothesis import NORMAL_95, NoiseHypothesis
from pyhrg.gap.evidence.residuals import compute_residuals, select_distinct
from pyhrg.gap.evidence.search import Ranking, is_unnamed, rank_sets
from pyhrg.gap.replay.observations import CHANNELS
from pyhrg.gap.soundness.fault import compute_beyond_probability
from pyhrg.gap.whitening.campaign_noise import CampaignNoise
from pyhrg.gap.whitening.channel_noise import estimate_campaign_noise


@dataclass(frozen=True)
class FormError:
    """Forms that causes may have for which terms stand, with the standard deviations of their
    sizes, and these terms (Eq. (10a))."""

    sigmas: Mapping[Form, float]
    terms: tuple[CandidateTerm, ...]


NO_ERROR = FormError({}, ())
SIGNIFICANT_SIGMA = 3.0
"""Departure of a known parameter, in its standard deviation, above which it counts as off. Chosen:
with 15 parameters that are right, one campaign in 25 has a false departure."""


@dataclass(frozen=True)
class Hypothesis:
    """A noise of the output angle, and the sets of effects ranked under it.

    channel_noise: noise of all channels.
    known: normal equations, whitened with it, and what is known within a tolerance: parameters, and
        the forms of terms.
    exact: the same without the linearization error, which measures distances.
    forms: of the terms of the most probable set.
    """

    noise: NoiseHypothesis
    channel_noise: CampaignNoise
    known: KnownParameters
    ranking: Ranking
    exact: KnownParameters
    forms: FormError = NO_ERROR

    @property
    def design(self) -> Design:
        """Normal equations of effects and candidate terms, known parameters integrated out."""
        return self.exact.marginal

    @cached_property
    def known_sizes(self) -> dict[Effect, Array]:
        """(d,) departure of each known parameter beside the most probable set, SI."""
        return self.known.estimate(self.ranking.best.sizes)

    @property
    def sizes(self) -> dict[Group, Array]:
        """Sizes of the most probable set, and departures of the known parameters and of the terms'
        forms beside it."""
        return self.known.complete(self.ranking.best.sizes)

    @property
    def effect_sizes(self) -> dict[Effect, Array]:
        """Sizes of all parameters of gyro, bench and record: `sizes` without candidate terms."""
        return {**self.ranking.best.named, **self.known_sizes}

    def put_effects(self, nominal: Device) -> Device:
        """The nominal device with all these parameters in their sizes."""
        return _put(nominal, self.effect_sizes)

    def identify_device(self, nominal: Device) -> Device:
        """The nominal device with the named effects, and the known parameters that are off."""
        off = {effect: size for effect, (size, _) in self.departures.items()}
        return _put(nominal, {**self.ranking.best.named, **off})

    @cached_property
    def departures(self) -> dict[Effect, tuple[Array, Array]]:
        """(d,) departure and (d, d) covariance of each known parameter that is significantly off,
        SI."""
        covariances = self.known.compute_covariances(self.ranking.best.groups)
        departures = {e: (size, covariances[e]) for e, size in self.known_sizes.items()}
        return {
            effect: (size, covariance)
            for effect, (size, covariance) in departures.items()
            if np.linalg.norm(size) > SIGNIFICANT_SIGMA * compute_sigma_along(size, covariance)
        }

    def compute_beyond(self, effect: Effect, tolerance: float) -> float:
        """Probability, given this noise, that a known parameter is off by more than a tolerance,
        SI: normal along its departure (docs/methods/verdict.md, Eq. 9)."""
        if effect not in self.departures:
            return 0.0
        size, covariance = self.departures[effect]
        sigma = compute_sigma_along(size, covariance)
        return compute_beyond_probability(float(np.linalg.norm(size)), tolerance, sigma)

    @property
    def log_posterior(self) -> float:
        """Log posterior probability of the noise, up to a constant, summed over sets (Eq. (8))."""
        return self.design.log_likelihood + self.ranking.log_evidence + self.noise.log_prior

    @property
    def names(self) -> frozenset[str] | None:
        """Effects and noises of the most probable set; None where it holds candidate terms or an
        unnamed noise."""
        best = self.ranking.best
        if self.noise.unnamed or len(best.named) < len(best.groups):
            return None
        return self._with_noise_names(best.named)

    @property
    def every_name(self) -> frozenset[str]:
        """Effects of all sets, and noises."""
        return self._with_noise_names(g for g in self.ranking.groups if isinstance(g, Effect))

    def _with_noise_names(self, effects: Iterable[Effect]) -> frozenset[str]:
        names = [effect.name for effect in effects]
        return frozenset([*names, *(added.effect.name for added in self.noise.added)])

    def probability(self, *names: str) -> float:
        """Probability, given this noise, that one of the named effects and noises takes part."""
        if any(added.effect.name in names for added in self.noise.added):
            return 1.0
        own = [g for g in self.ranking.groups if isinstance(g, Effect) and g.name in names]
        return self.ranking.probability(*own)

    @property
    def unnamed(self) -> dict[str, float]:
        """What takes part outside the catalogue, in words, with probabilities given this noise."""
        terms = [g for g in self.ranking.groups if is_unnamed(g)]
        probabilities = dict.fromkeys((term.words for term in terms), 0.0)
        for term in terms:
            probabilities[term.words] += self.ranking.probability(term)
        noise = {self.noise.unnamed.words: 1.0} if self.noise.unnamed else {}
        return probabilities | noise

    @property
    def unknown_probability(self) -> float:
        """Probability, given this noise, that something outside the catalogue takes part."""
        return 1.0 if self.noise.unnamed else self.ranking.unknown_probability


def _put(nominal: Device, sizes: Mapping[Effect, Array]) -> Device:
    device = nominal
    for effect, size in sizes.items():
        device = effect.put(device, effect.vector(nominal) + size)
    return device


def compute_sigma_along(size: Array, covariance: Array) -> float:
    """Standard deviation of a vector along its own direction."""
    along = size / (float(np.linalg.norm(size)) or 1.0)
    return math.sqrt(float(along @ covariance @ along)) or math.ulp(0.0)


def rank_under_noise(
    noise: NoiseHypothesis,
    parts: Sequence[LinearTest],
    start: Collection[Group] = (),
    forms: FormError = NO_ERROR,
) -> Hypothesis:
    """Rank sets of effects and candidate terms under one noise of the output angle, where the
    linearization error is negligible.

    Jumps and steps that stand out of the residual are ranked too, and infeasible sizes are refused.
    The search may start from the set that is the most probable under another noise.
    """
    channel_noise, model_error = _estimate_errors(noise, parts)
    tolerances = _list_tolerances(parts)
    tolerances.update(forms.sigmas.items())
    is_feasible = make_feasibility_check(parts[0].nominal, parts[0].sensitivities)

    def rank(start: Collection[Group], jumps: Sequence[Jump] = ()) -> Hypothesis:
        whole = build_design(parts, channel_noise, model_error, jumps, tuple(forms.sigmas))
        known = KnownParameters(whole, tolerances, forms.terms)
        ranking = rank_sets(known.marginal, is_feasible, start, forms.terms)
        return Hypothesis(noise, channel_noise, known, ranking, known, forms)

    hypothesis = rank(start)
    removed = select_distinct(hypothesis.sizes, hypothesis.effect_sizes)
    residuals = [compute_residuals(parts, r, channel_noise, ("gyro_angle",)) for r in removed]
    quantum = parts[0].nominal.quantization_step
    jumps = {jump for r in residuals for jump in (*find_jumps(r), *find_steps(r, quantum))}
    if not jumps:
        return hypothesis
    return rank(hypothesis.ranking.best.groups, sorted(jumps, key=lambda jump: jump.words))


def rank_roughly(
    noise: NoiseHypothesis,
    parts: Sequence[LinearTest],
    linearization_error: float,
) -> Hypothesis:
    """Rank sets under one noise of the output angle, where the linear model may get this chi-square
    wrong in each channel of each test (Eq. (10)): it counts as noise."""
    channel_noise, model_error = _estimate_errors(noise, parts)
    error = {where: linearization_error + power for where, power in model_error.items()}
    whole = build_design(parts, channel_noise, model_error)
    tolerances = _list_tolerances(parts)
    rough = KnownParameters(discount_model_error(whole, error), tolerances)
    exact = KnownParameters(whole, tolerances)
    return Hypothesis(noise, channel_noise, rough, rank_sets(rough.marginal), exact)


def _estimate_errors(
    noise: NoiseHypothesis, parts: Sequence[LinearTest]
) -> tuple[CampaignNoise, dict[TestChannel, float]]:
    """Noise of all channels under a noise of the output angle; and the chi-square that the
    simulation may get wrong in each channel of each test, with what is left unexplained there."""
    nominal_noise = estimate_nominal_noise(parts)
    model_error = compute_model_error(parts, nominal_noise)
    for part in parts:
        for channel, power in part.test.unexplained.items():
            model_error[part.test.test.id, channel] += power
    return replace(nominal_noise, angle=noise.noise), model_error


def suppose_nothing(parts: Sequence[LinearTest]) -> Hypothesis:
    """The hypothesis that nothing takes part, not even within its tolerance, and the noise is the
    stated one."""
    channel_noise = estimate_nominal_noise(parts)
    known = KnownParameters(build_design(parts, channel_noise), {})
    ranking = Ranking((NO_GROUPS,), (1.0,), 0.0)
    noise = NoiseHypothesis(channel_noise.angle, ())
    return Hypothesis(noise, channel_noise, known, ranking, known)


def _list_tolerances(parts: Sequence[LinearTest]) -> dict[Effect | Form, float]:
    """Tolerance of each known parameter, SI."""
    known = [effect for effect in parts[0].sensitivities if effect.family != "gyro"]
    return {effect: effect.tolerance_of(parts[0].nominal) for effect in known}


def make_feasibility_check(nominal: Device, effects: Collection[Effect]) -> Callable[[Fit], bool]:
    """A check whether every effect of a fit, whose sizes count from the nominal gyro, is within the
    bounds of its parameters, or outside by less than its 95 % interval."""
    bounds = {e: (e.vector(nominal), *e.bounds) for e in effects}

    def is_possible(effect: Effect, size: Array, covariance: Array) -> bool:
        vector, low, high = bounds[effect]
        total = vector + size
        if effect.periods:
            excess = math.hypot(*total) - high
        else:
            excess = max(low - float(total[0]), float(total[0]) - high)
        return excess <= 0 or excess <= NORMAL_95 * compute_sigma_along(size, covariance)

    def is_feasible(fit: Fit) -> bool:
        groups = zip(fit.groups, fit.values, fit.covariances, strict=True)
        return all(is_possible(g, v, c) for g, v, c in groups if isinstance(g, Effect))

    return is_feasible


def estimate_nominal_noise(parts: Sequence[LinearTest]) -> CampaignNoise:
    """Noise of all channels, that of the output angle as the nominal gyro states it; others from
    the residuals of the simulated device."""
    tests = [p.test for p in parts]
    residuals = [{n: getattr(p.test.log, n) - p.simulated[n] for n in CHANNELS} for p in parts]
    return estimate_campaign_noise(
        parts[0].nominal, tests, residuals, parts[0].device.thermometer_lag
    )
