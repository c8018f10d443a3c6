"""Hypotheses that survive the tests made so far: each a set of effects and elements, and a noise of
the output angle."""

import math
from collections.abc import Sequence
from dataclasses import dataclass

from pyhrg.gap.effects.catalogue import Effect
from pyhrg.gap.effects.design import Design
from pyhrg.gap.evidence.attribution import Attribution
from pyhrg.gap.evidence.equivalents import ALIKE, equivalents
from pyhrg.gap.evidence.evidence import Fit
from pyhrg.gap.evidence.hypothesis import Hypothesis
from pyhrg.gap.whitening.channel_noise import ChannelNoise

MOST = 4
"""That are looked at beside the most probable."""


@dataclass(frozen=True)
class Rival:
    """A hypothesis.

    noise: of all channels.
    noises: names of those of the output angle that are beyond belief.
    design: of the tests made so far, whitened with the noise.
    """

    fit: Fit
    noise: ChannelNoise
    noises: tuple[str, ...]
    design: Design

    @property
    def words(self) -> list[str]:
        """What takes part."""
        groups = (g.name if isinstance(g, Effect) else g.words for g in self.fit.groups)
        return [*groups, *self.noises]


def rivals(found: Attribution, effects: Sequence[Effect]) -> list[Rival]:
    """The most probable hypothesis, and those as likely in which something else stands in the place
    of an effect or element, or an effect of a noise's or the other way round; one more or less is
    no rival.

    Args:
        found: what the tests say.
        effects: of the catalogue.
    """
    best, ranked = found.ranked.best, found.ranked
    least = ranked.probabilities[0] * math.exp(-ALIKE)
    near = [f for f, p in zip(ranked.fits, ranked.probabilities, strict=True) if p > least]
    for group in best.groups:
        if isinstance(group, Effect):
            near += equivalents(found.design, best, group, effects).values()
    own = set(best.groups)
    others = {
        frozenset(fit.groups): fit
        for fit in near
        if not own <= set(fit.groups) and not set(fit.groups) <= own
    }
    likeliest = found.weighed.best
    swapped = [h for h in found.weighed.rivals() if set(h.ranked.best.groups) != own]
    return [
        rival(likeliest, best),
        *[rival(h, h.ranked.best) for h in swapped],
        *[rival(likeliest, fit) for fit in others.values()],
    ][: MOST + 1]


def rival(hypothesis: Hypothesis, fit: Fit) -> Rival:
    """One set under the noise of a hypothesis."""
    noises = tuple(added.effect.name for added in hypothesis.noise.added)
    return Rival(fit, hypothesis.channel_noise, noises, hypothesis.design)
