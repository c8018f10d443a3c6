"""Posterior probabilities of noises of the output angle, each with its own sets of effects.

A wandering residual may be noise, or a response that the catalogue lacks. Each noise is therefore
compared together with the sets of effects that go with it (docs/methods/evidence.md, Eq. (8)).
"""

import itertools
import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from operator import attrgetter

import numpy as np
from scipy.optimize import brentq
from scipy.special import ndtr, softmax

from pyhrg.common.arrays import Array
from pyhrg.gap.effects.catalogue import Effect, NoiseEffect
from pyhrg.gap.effects.linear_test import Group, LinearTest
from pyhrg.gap.evidence.evidence import EQUIVALENCE_LOG_ODDS
from pyhrg.gap.evidence.form_error import rank_with_forms, suggest_noises
from pyhrg.gap.evidence.hypothesis import Hypothesis, compute_sigma_along
from pyhrg.gap.evidence.noise.noise_hypothesis import NORMAL_95
from pyhrg.gap.evidence.noise.noise_levels import are_equal
from pyhrg.gap.evidence.residuals import select_distinct

EVIDENT_CHI2 = 1e4
"""Explained power, as chi-square, above which the effects are there whatever the noise is: the
noise is then not fitted to the residual with nothing removed. Chosen."""
_LOG_POSTERIOR = attrgetter("log_posterior")


@dataclass(frozen=True)
class Posterior:
    """Hypotheses, the most probable first, and their posterior probabilities, which add up to 1."""

    hypotheses: tuple[Hypothesis, ...]
    probabilities: tuple[float, ...]

    @property
    def best(self) -> Hypothesis:
        """The most probable hypothesis."""
        return self.hypotheses[0]

    def probability(self, *names: str) -> float:
        """Probability that one of the effects and noises of these names takes part."""
        return self._mean(h.probability(*names) for h in self.hypotheses)

    def compute_beyond(self, effect: Effect, tolerance: float) -> float:
        """Probability that a known parameter is off by more than a tolerance, SI."""
        return self._mean(h.compute_beyond(effect, tolerance) for h in self.hypotheses)

    @property
    def unknown_probability(self) -> float:
        """Probability that something outside the catalogue takes part."""
        return self._mean(h.unknown_probability for h in self.hypotheses)

    def list_unnamed(self) -> dict[str, float]:
        """What takes part outside the catalogue, in words, with probabilities."""
        tables = [h.unnamed for h in self.hypotheses]
        words = dict.fromkeys(word for table in tables for word in table)
        return {word: self._mean(table.get(word, 0.0) for table in tables) for word in words}

    def list_rivals(self) -> list[Hypothesis]:
        """Hypotheses about as probable as the best one that differ from it in one name."""
        best = self.best.names
        threshold = self.probabilities[0] * math.exp(-EQUIVALENCE_LOG_ODDS)
        others = zip(self.hypotheses[1:], self.probabilities[1:], strict=True)
        near = [h for h, probability in others if probability > threshold]
        return [
            h for h in near if best and h.names and len(best - h.names) == len(h.names - best) == 1
        ]

    def list_equivalents(self, name: str) -> tuple[str, ...]:
        """Names that rivals have in the place of this effect or noise of the best hypothesis."""
        rivals = [h.names or frozenset() for h in self.list_rivals()]
        best = self.best.names or frozenset()
        return tuple(other for names in rivals if name not in names for other in names - best)

    def compute_sigma(self, effect: Effect, size: Array, direction: Array) -> float:
        """Half the width, over 1.96, of the interval around a size along a unit vector that holds
        95 % of the effect's posterior: a mixture of normal ones, of each set and noise in which the
        effect takes part (docs/methods/verdict.md, Eq. 3a)."""
        estimates = [
            (p * q, value, covariance)
            for h, p in zip(self.hypotheses, self.probabilities, strict=True)
            for fit, q in zip(h.ranking.fits, h.ranking.probabilities, strict=True)
            for group, value, covariance in zip(
                fit.groups, fit.values, fit.covariances, strict=True
            )
            if group == effect
        ]
        weights = np.array([weight for weight, _, _ in estimates])
        offsets = np.array([(value - size) @ direction for _, value, _ in estimates])
        sigmas = np.array(
            [compute_sigma_along(direction, covariance) for _, _, covariance in estimates]
        )

        def miss(half_width: float) -> float:
            ends = [(side * half_width - offsets) / sigmas for side in (-1.0, 1.0)]
            outside = ndtr(ends[0]) + ndtr(-ends[1])
            return float(weights @ outside / weights.sum()) - 2 * ndtr(-NORMAL_95)

        highest = float((np.abs(offsets) + NORMAL_95 * sigmas).max())
        lowest = float((NORMAL_95 * sigmas).min()) * (1 - 1e-9)
        return float(brentq(miss, lowest, highest * (1 + 1e-9), rtol=1e-6)) / NORMAL_95

    def _mean(self, values: Iterable[float]) -> float:
        return min(1.0, sum(p * v for p, v in zip(self.probabilities, values, strict=True)))


def average_posteriors(posteriors: Sequence[Posterior]) -> Posterior:
    """The mean of posteriors of successive rounds; the best hypothesis is that of the last one.
    What comes and goes from round to round is then not certain."""
    *before, last = posteriors
    others = [pair for p in before for pair in zip(p.hypotheses, p.probabilities, strict=True)]
    pairs = [*zip(last.hypotheses, last.probabilities, strict=True), *others]
    hypotheses, probabilities = zip(*pairs, strict=True)
    return Posterior(hypotheses, tuple(p / len(posteriors) for p in probabilities))


def compare_noises(
    first: Hypothesis,
    parts: Sequence[LinearTest],
    noises: Sequence[NoiseEffect],
) -> Posterior:
    """Compare a hypothesis with others that have another noise of the output angle. The
    linearization error is negligible around its gyro.

    Noise is fitted to three residuals of the most probable hypothesis: with all its effects and
    terms removed, with its effects alone removed, and with nothing removed. Sets of effects are
    ranked again under each noise. The most probable hypothesis of each kind of noise is kept. This
    is repeated until the most probable hypothesis gives no new residual.
    """
    best = first
    by_kind, tried = {first.noise.kind: first}, set[tuple[Group, ...]]()
    while True:
        is_evident = best.ranking.best.explained >= EVIDENT_CHI2
        nothing = [] if is_evident else [best.known.estimate({})]
        choices = select_distinct(best.sizes, best.effect_sizes, *nothing)
        due = [removed for removed in choices if tuple(removed) not in tried]
        if not due:
            break
        tried.update(tuple(removed) for removed in due)
        suggested = [suggest_noises(best, removed, parts, noises) for removed in due]
        for noise in itertools.chain.from_iterable(suggested):
            known = by_kind.get(noise.kind)
            if known is None or not are_equal(known.noise.noise, noise.noise):
                rival = rank_with_forms(noise, parts, best)
                by_kind[noise.kind] = max(known or rival, rival, key=_LOG_POSTERIOR)
        best = max(by_kind.values(), key=_LOG_POSTERIOR)
    order = sorted(by_kind.values(), key=_LOG_POSTERIOR, reverse=True)
    probabilities = softmax([h.log_posterior for h in order])
    return Posterior(tuple(order), tuple(probabilities.tolist()))
