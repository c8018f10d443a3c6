"""Noises of the output angle with their sets of effects, weighed together.

What wanders may be noise, or something that nobody has a name for: each noise is given the sets
that go with it. The likeliest is taken, and is as probable as the others let it be.
"""

import math
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass, replace
from operator import attrgetter

from scipy.special import softmax

from pyhrg.device.device import Device
from pyhrg.gap.effects.catalogue import NoiseEffect
from pyhrg.gap.effects.design import Group, LinearTest
from pyhrg.gap.evidence.equivalents import ALIKE
from pyhrg.gap.evidence.hypothesis import Hypothesis, angles_left, ranked_under
from pyhrg.gap.evidence.noise.noise_levels import alike
from pyhrg.gap.evidence.noise.noise_search import NoiseFound, doubted, noise_found
from pyhrg.gap.evidence.residuals import Taken, unlike
from pyhrg.gap.whitening.channel_noise import angle_noise

PLAIN = 1e4
"""Power that is explained, in deviations of the noise squared, which no noise would let be."""
_LOG_POSTERIOR = attrgetter("log_posterior")


@dataclass(frozen=True)
class Weighed:
    """Hypotheses, the likeliest first, and their probabilities, which add up to 1."""

    hypotheses: tuple[Hypothesis, ...]
    probabilities: tuple[float, ...]

    @property
    def best(self) -> Hypothesis:
        """The likeliest."""
        return self.hypotheses[0]

    def anew(self, hypothesis: Hypothesis) -> "Weighed":
        """With the likeliest as it has been ranked since."""
        return replace(self, hypotheses=(hypothesis, *self.hypotheses[1:]))

    def with_noises(self, change: Callable[[Hypothesis], NoiseFound]) -> "Weighed":
        """With what is said of each one's noise."""
        return replace(
            self, hypotheses=tuple(replace(one, noise=change(one)) for one in self.hypotheses)
        )

    def probability(self, *names: str) -> float:
        """That one of the effects and noises of these names takes part."""
        return self._mean(one.probability(*names) for one in self.hypotheses)

    @property
    def unknown_probability(self) -> float:
        """That something outside the catalogue takes part."""
        return self._mean(one.unknown_probability for one in self.hypotheses)

    def unnamed(self) -> dict[str, float]:
        """What takes part outside the catalogue, in words, with probabilities."""
        each = [one.unnamed for one in self.hypotheses]
        words = dict.fromkeys(word for one in each for word in one)
        return {word: self._mean(one.get(word, 0.0) for one in each) for word in words}

    def rivals(self) -> list[Hypothesis]:
        """Next to as probable as the likeliest, with one name in the place of another."""
        mine, least = self.best.names, self.probabilities[0] * math.exp(-ALIKE)
        others = zip(self.hypotheses[1:], self.probabilities[1:], strict=True)
        near = [one for one, probability in others if probability > least]
        return [one for one in near if mine and one.names and _is_swapped(mine, one.names)]

    def stand_ins(self, name: str) -> tuple[str, ...]:
        """What stands in a rival's place of an effect or a noise of this name."""
        rivals = [one.names or frozenset() for one in self.rivals()]
        mine = self.best.names or frozenset()
        return tuple(other for names in rivals if name not in names for other in names - mine)

    def _mean(self, values: Iterable[float]) -> float:
        return min(1.0, sum(p * v for p, v in zip(self.probabilities, values, strict=True)))


def _is_swapped(one: frozenset[str], other: frozenset[str]) -> bool:
    return len(one - other) == len(other - one) == 1


def weighed(
    first: Hypothesis,
    believed: Device,
    parts: Sequence[LinearTest],
    noises: Sequence[NoiseEffect],
) -> Weighed:
    """A hypothesis beside those with the noise that is left when all that the likeliest found is
    taken out, or only what has a name, or, where it might be noise, nothing; of each kind of noise
    the likeliest. Done when nothing else is left of the likeliest.

    Args:
        first: around a gyro so close that what is left is no leftover of a linear search.
        believed: the gyro before the diagnosis.
        parts: of each test.
        noises: of the catalogue.
    """
    best = first
    by_kind, looked_at = {first.noise.kind: first}, set[tuple[Group, ...]]()
    while due := [taken for taken in _to_be_taken(best) if tuple(taken) not in looked_at]:
        looked_at.update(tuple(taken) for taken in due)
        left = [noise for taken in due for noise in _left(parts, taken, best, believed, noises)]
        for noise in left:
            known = by_kind.get(noise.kind)
            if known is None or not alike(known.noise.noise, noise.noise):
                rival = ranked_under(noise, believed, parts)
                by_kind[noise.kind] = max(known or rival, rival, key=_LOG_POSTERIOR)
        best = max(by_kind.values(), key=_LOG_POSTERIOR)
    order = sorted(by_kind.values(), key=_LOG_POSTERIOR, reverse=True)
    shares = softmax([one.log_posterior for one in order])
    return Weighed(tuple(order), tuple(shares.tolist()))


def _to_be_taken(hypothesis: Hypothesis) -> list[Taken]:
    found = hypothesis.ranked.best
    nothing: list[Taken] = [{}] if found.explained < PLAIN else []
    return unlike(found.sizes, found.named, *nothing)


def _left(
    parts: Sequence[LinearTest],
    taken: Taken,
    best: Hypothesis,
    believed: Device,
    noises: Sequence[NoiseEffect],
) -> list[NoiseFound]:
    """Noise when this is taken out, and the same with one that may not be there left out."""
    left = angles_left(parts, taken, best.channel_noise, believed)
    stated = angle_noise(believed)
    found = noise_found(left, stated, noises)
    return [found, *doubted(found, left, stated)]
