"""Noise of the output angle and sets of effects, weighed together.

What wanders may be noise, or something that nobody has a name for: each noise is given the sets
that go with it, and the likelier of them is taken.
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from pyhrg.device import Device
from pyhrg.gap.catalogue import Effect
from pyhrg.gap.channel_noise import ChannelNoise, angle_noise, believed_noise
from pyhrg.gap.design import Design, Evidence, design, tempered
from pyhrg.gap.evidence import Fit
from pyhrg.gap.noise_search import AngleRecord, NoiseFound, alike, noise_found
from pyhrg.gap.remainder import Taken, remainders
from pyhrg.gap.search import Ranked, ranked

Array = NDArray[np.float64]

FIDELITY = 1e-8
"""Share of a response's power that a simulation gets wrong: simulators of one physics that were
written apart agree to 1e-4."""
PLAIN = 1e4
"""Power that is explained, in deviations of the noise squared, which no noise would let be."""


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


def ranked_under(
    noise: NoiseFound, believed: Device, parts: Sequence[Evidence], share: float = FIDELITY
) -> Hypothesis:
    """Sets under one noise.

    Args:
        noise: of the output angle.
        believed: the gyro before the diagnosis.
        parts: of each test.
        share: of the response's power that simulation and linear equations get wrong.
    """
    tests, residuals = [p.test for p in parts], [p.residual for p in parts]
    channels = replace(believed_noise(believed, tests, residuals), angle=noise.noise)
    exact = design(parts, channels)
    rough = tempered(exact, share)
    return Hypothesis(noise, channels, tempered(exact, FIDELITY), ranked(rough))


def weighed(first: Hypothesis, believed: Device, parts: Sequence[Evidence]) -> Hypothesis:
    """The likeliest of a hypothesis and those with the noise that is left when all that it found is
    taken out, or only what has a name, or, where it might be noise, nothing.

    Args:
        first: around a gyro so close that what is left is no leftover of a linear search.
        believed: the gyro before the diagnosis.
        parts: of each test.
    """
    best, tried = first, [first.noise.noise]
    found = first.ranked.best
    nothing: list[Taken] = [{}] if found.explained < PLAIN else []
    for taken in _unlike(_every(found), _named(found), *nothing):
        left = angles_left(parts, taken, first.channel_noise, believed)
        noise = noise_found(left, angle_noise(believed))
        if not any(alike(noise.noise, one) for one in tried):
            tried.append(noise.noise)
            rival = ranked_under(noise, believed, parts)
            best = max(best, rival, key=lambda hypothesis: hypothesis.log_posterior)
    return best


def _unlike(*taken: Taken) -> list[Taken]:
    return list({tuple(one): one for one in taken}.values())


def _every(found: Fit) -> Taken:
    return dict(zip(found.groups, found.values, strict=True))


def _named(found: Fit) -> Taken:
    return {group: value for group, value in _every(found).items() if isinstance(group, Effect)}


def angles_left(
    parts: Sequence[Evidence], taken: Taken, noise: ChannelNoise, believed: Device
) -> list[AngleRecord]:
    """Output angles without what is taken out."""
    left = remainders(parts, taken, noise, believed, ("gyro_angle",))
    return [AngleRecord(r.values, r.steps) for r in left]
