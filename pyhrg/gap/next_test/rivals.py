"""Hypotheses that survive the tests made so far."""

from collections.abc import Sequence
from dataclasses import dataclass, replace

from pyhrg.device.declarations import format_effect
from pyhrg.gap.effects.catalogue import Effect
from pyhrg.gap.effects.design import Design, list_rival_terms
from pyhrg.gap.effects.linear_test import Group
from pyhrg.gap.evidence.attribution import Attribution
from pyhrg.gap.evidence.equivalence.hidden_effects import find_hidden_effects
from pyhrg.gap.evidence.evidence import Fit, find_equivalents
from pyhrg.gap.evidence.hypothesis import Hypothesis
from pyhrg.gap.whitening.campaign_noise import CampaignNoise

MAX_RIVALS = 4
"""Number of rivals that are considered beside the most probable hypothesis. Chosen."""


@dataclass(frozen=True)
class Rival:
    """A fitted set of effects and candidate terms under a noise.

    noise: noise of all channels.
    noises: names of the noises of the output angle beyond their stated levels.
    design: normal equations of the tests made so far, whitened with the noise.
    held: effect of the set whose size is not fitted; None where all are.
    """

    fit: Fit
    noise: CampaignNoise
    noises: tuple[str, ...]
    design: Design
    held: Effect | None = None

    @property
    def words(self) -> list[str]:
        """What takes part, in words."""
        groups = (
            format_effect(g.name) if isinstance(g, Effect) else g.words for g in self.fit.groups
        )
        return [*groups, *map(format_effect, self.noises)]


def find_rivals(attribution: Attribution, effects: Sequence[Effect]) -> list[Rival]:
    """The most probable hypothesis first, then its rivals.

    A rival is about as probable, and has another effect, term or noise in the place of one. A
    hypothesis that has only one more or one less is no rival, but for effects that the tests can't
    see beside the set (`find_hidden_effects`).
    """
    best, ranking = attribution.ranking.best, attribution.ranking
    near = ranking.list_near()
    for group in best.groups:
        candidates: Sequence[Group] = (
            effects if isinstance(group, Effect) else list_rival_terms(attribution.design, group)
        )
        near += find_equivalents(attribution.design, best, group, candidates).values()
    own = set(best.groups)
    others = {
        frozenset(fit.groups): fit
        for fit in near
        if not own <= set(fit.groups) and not set(fit.groups) <= own
    }
    hypothesis = attribution.posterior.best
    hidden = find_hidden_effects(attribution.design, best, effects)
    swapped = [h for h in attribution.posterior.list_rivals() if set(h.ranking.best.groups) != own]
    return [
        make_rival(hypothesis, best),
        *[make_rival(h, h.ranking.best) for h in swapped],
        *[make_rival(hypothesis, fit) for fit in others.values()],
        *[replace(make_rival(hypothesis, h.fit), held=h.effect) for h in hidden],
    ][: MAX_RIVALS + 1]


def make_rival(hypothesis: Hypothesis, fit: Fit) -> Rival:
    """A fitted set under the noise of a hypothesis."""
    noises = tuple(added.effect.name for added in hypothesis.noise.added)
    return Rival(fit, hypothesis.channel_noise, noises, hypothesis.known.whole)
