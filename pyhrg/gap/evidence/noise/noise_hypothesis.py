"""A hypothesis on the noise of the output angle: what it has beyond the stated noise."""

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace

from pyhrg.common.units import ARCSEC, DEG_PER_H
from pyhrg.gap.effects.catalogue import NoiseEffect
from pyhrg.gap.evidence.evidence import UNNAMED_ODDS
from pyhrg.gap.evidence.noise.noise_levels import Likelihood, fit_level
from pyhrg.gap.whitening.whitening import CorrelatedNoise, NoiseModel

NORMAL_95 = 1.96
"""Half width of the 95 % interval of a normal distribution, in sigma."""
RATE_LAGS = (1.0, 10.0, 30.0, 100.0, 300.0, 1e3, 3e3, 1e4)
ANGLE_LAGS = (0.03, 3.0, 30.0, 300.0)
"""Correlation times that are tried for noise of the rate and of the angle, s; the shortest is white
in rows of 0.1 s or longer. Chosen."""
RATE_SCALE, ANGLE_SCALE = 0.1 * DEG_PER_H, 0.1 * ARCSEC
"""Typical levels, the centres of the priors. Chosen; the priors span six decades."""


@dataclass(frozen=True)
class UnnamedNoise:
    """A correlated noise that the catalogue lacks.

    log_prior: part of the log odds that it takes part which does not come from the records.
    """

    correlated: CorrelatedNoise
    log_prior: float

    @property
    def words(self) -> str:
        """What it is, in words."""
        what = "rate" if self.correlated.of_rate else "angle"
        return f"noise of the {what} that lasts {self.correlated.lag:g} s (output angle)"

    def add_to(self, noise: NoiseModel) -> NoiseModel:
        """Another noise with this one added."""
        return replace(noise, correlated=(self.correlated,))


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


def fit_unnamed_noise(
    likelihood: Likelihood, bases: Sequence[tuple[NoiseModel, float]]
) -> UnnamedNoise:
    """The most probable unnamed noise beside one of some noises with their log priors."""
    candidates = [
        _fit_lag(likelihood, noise, log_prior, of_rate, lag)
        for noise, log_prior in bases
        for of_rate, lags in ((True, RATE_LAGS), (False, ANGLE_LAGS))
        for lag in lags
    ]
    return max(candidates, key=lambda candidate: candidate[0])[1]


def _fit_lag(
    likelihood: Likelihood,
    base: NoiseModel,
    base_log_prior: float,
    of_rate: bool,
    lag: float,
) -> tuple[float, UnnamedNoise]:
    """Noise of this correlation time, s, at its most probable level, after its log likelihood plus
    log prior."""
    scale = RATE_SCALE if of_rate else ANGLE_SCALE

    def gain(logarithm: float) -> float:
        correlated = CorrelatedNoise(math.exp(logarithm), lag, of_rate)
        return likelihood(replace(base, correlated=(correlated,))) + base_log_prior

    level = fit_level(gain, scale)
    log_prior = level.log_prior(UNNAMED_ODDS / (len(RATE_LAGS) + len(ANGLE_LAGS)))
    correlated = CorrelatedNoise(math.exp(level.logarithm), lag, of_rate)
    return level.gain + log_prior, UnnamedNoise(correlated, log_prior)
