"""Sets of effects, ranked under a noise of the output angle."""

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from pyhrg.device.device import Device
from pyhrg.gap.effects.candidate_terms import Element
from pyhrg.gap.effects.catalogue import Effect
from pyhrg.gap.effects.design import Design, LinearTest, Where, design, response_power, tempered
from pyhrg.gap.evidence.feasibility import Possible
from pyhrg.gap.evidence.jump_search import jumps
from pyhrg.gap.evidence.noise.noise_levels import AngleRecord
from pyhrg.gap.evidence.noise.noise_search import NoiseFound
from pyhrg.gap.evidence.residuals import Taken, remainders, unlike
from pyhrg.gap.evidence.search import Ranked, ranked
from pyhrg.gap.evidence.step_search import steps
from pyhrg.gap.whitening.channel_noise import ChannelNoise, believed_noise

Array = NDArray[np.float64]

FIDELITY = 1e-10
"""Share of the power of a response in one channel of one test that a simulation gets wrong:
simulators of one physics that were written apart agree to 1e-5."""


@dataclass(frozen=True)
class Hypothesis:
    """Sets ranked under a noise of the output angle.

    channel_noise: of all channels.
    design: whitened with it.
    """

    noise: NoiseFound
    channel_noise: ChannelNoise
    design: Design
    ranked: Ranked

    @property
    def log_posterior(self) -> float:
        """Of noise and sets together, but for a constant."""
        return self.design.log_likelihood + self.ranked.log_evidence + self.noise.log_prior

    @property
    def names(self) -> frozenset[str] | None:
        """Effects and noises of the most probable set; None where something has no name."""
        best = self.ranked.best
        if self.noise.nameless or len(best.named) < len(best.groups):
            return None
        return self._with_noises(best.named)

    @property
    def every_name(self) -> frozenset[str]:
        """Effects of all sets, and noises."""
        return self._with_noises(g for g in self.ranked.groups if isinstance(g, Effect))

    def _with_noises(self, effects: Iterable[Effect]) -> frozenset[str]:
        names = [effect.name for effect in effects]
        return frozenset([*names, *(added.effect.name for added in self.noise.added)])

    def probability(self, *names: str) -> float:
        """That one of the effects and noises of these names takes part, beside this noise."""
        if any(added.effect.name in names for added in self.noise.added):
            return 1.0
        own = [g for g in self.ranked.groups if isinstance(g, Effect) and g.name in names]
        return self.ranked.probability(*own)

    @property
    def unnamed(self) -> dict[str, float]:
        """What takes part outside the catalogue, in words, with probabilities."""
        elements = [g for g in self.ranked.groups if isinstance(g, Element)]
        found = dict.fromkeys((g.words for g in elements), 0.0)
        for element in elements:
            found[element.words] += self.ranked.probability(element)
        return found | ({self.noise.nameless.words: 1.0} if self.noise.nameless else {})

    @property
    def unknown_probability(self) -> float:
        """That something outside the catalogue takes part."""
        return 1.0 if self.noise.nameless else self.ranked.unknown_probability


def ranked_under(
    noise: NoiseFound, believed: Device, parts: Sequence[LinearTest], leftover: float = 0.0
) -> Hypothesis:
    """Sets under one noise; with jumps, and of sizes that a gyro can have, unless what is left may
    be a linear search's.

    Args:
        noise: of the output angle.
        believed: the gyro before the diagnosis.
        parts: of each test.
        leftover: power that linear equations may get wrong, in deviations of the believed noise
            squared.
    """
    as_believed = noise_as_believed(believed, parts)
    wrong = allowed(response_power(parts, as_believed))
    channels = replace(as_believed, angle=noise.noise)
    exact = design(parts, channels)
    near = tempered(exact, wrong)
    if leftover:
        far = tempered(exact, {where: leftover + power for where, power in wrong.items()})
        return Hypothesis(noise, channels, near, ranked(far))
    possible = Possible(believed, parts[0].secants)
    found = ranked(near, possible)
    taken = unlike(found.best.sizes, found.best.named)
    left = [remainders(parts, one, channels, believed, ("gyro_angle",)) for one in taken]
    if jumped := {jump for each in left for jump in (*jumps(each), *steps(each))}:
        exact = design(parts, channels, sorted(jumped, key=lambda jump: jump.words))
        near = tempered(exact, wrong)
        found = ranked(near, possible)
    return Hypothesis(noise, channels, near, found)


def noise_as_believed(believed: Device, parts: Sequence[LinearTest]) -> ChannelNoise:
    """Of all channels, before any noise is found."""
    return believed_noise(believed, [p.test for p in parts], [p.residual for p in parts])


def allowed(response: Mapping[Where, float]) -> dict[Where, float]:
    """Power that a simulation may get wrong of that of a response."""
    return {where: FIDELITY * power for where, power in response.items()}


def angles_left(
    parts: Sequence[LinearTest], taken: Taken, noise: ChannelNoise, believed: Device
) -> list[AngleRecord]:
    """Output angles without what is taken out."""
    left = remainders(parts, taken, noise, believed, ("gyro_angle",))
    return [
        AngleRecord(r.values, r.steps, part.test.encoder)
        for r, part in zip(left, parts, strict=True)
    ]
