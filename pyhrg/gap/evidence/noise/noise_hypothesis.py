"""A hypothesis on the noise of the output angle: what it has beyond the stated noise."""

from dataclasses import dataclass

from pyhrg.gap.effects.catalogue import NoiseEffect
from pyhrg.gap.evidence.noise.unnamed_noise import UnnamedNoise
from pyhrg.gap.whitening.whitening import NoiseModel

NORMAL_95 = 1.96
"""Half width of the 95 % interval of a normal distribution, in sigma."""


@dataclass(frozen=True)
class AddedNoise:
    """A noise of the catalogue beyond its stated level.

    total: level, stated part included, SI.
    interval: 95 % interval of the total, SI.
    log_odds: log odds that it takes part.
    log_prior: part of these odds that does not come from the records.
    equivalents: noises that would be about as probable in its place.
    """

    effect: NoiseEffect
    total: float
    interval: tuple[float, float]
    log_odds: float
    log_prior: float
    equivalents: tuple[str, ...] = ()


@dataclass(frozen=True)
class NoiseHypothesis:
    """Noise of the output angle.

    noise: all of it.
    added: noises of the catalogue beyond their stated levels.
    log_prior: log prior of everything that differs from the stated noise.
    unnamed: a noise that the catalogue lacks.
    """

    noise: NoiseModel
    added: tuple[AddedNoise, ...]
    log_prior: float = 0.0
    unnamed: UnnamedNoise | None = None

    @property
    def kind(self) -> tuple[frozenset[str], tuple[float, bool] | None]:
        """Which noises take part, whatever their levels."""
        correlated = self.unnamed.correlated.kind if self.unnamed else None
        return frozenset(a.effect.name for a in self.added), correlated
