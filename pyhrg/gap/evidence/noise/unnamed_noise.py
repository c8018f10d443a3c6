"""Noise of the output angle that the catalogue lacks: correlated over a time that nobody states."""

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace

from pyhrg.common.units import ARCSEC, DEG_PER_H
from pyhrg.gap.evidence.noise.noise_levels import AngleResidual, fit_level, log_likelihood
from pyhrg.gap.evidence.prior_odds import UNNAMED_ODDS
from pyhrg.gap.whitening.whitening import CorrelatedNoise, NoiseModel

RATE_LAGS = (1.0, 10.0, 30.0, 100.0, 300.0, 1e3, 3e3, 1e4)
ANGLE_LAGS = (0.03, 3.0, 30.0, 300.0)
"""Correlation times that are tried for noise of the rate and of the angle, s; the shortest is white
in rows of 0.1 s or longer. Chosen."""
RATE_SCALE, ANGLE_SCALE = 0.1 * DEG_PER_H, 0.1 * ARCSEC
"""Typical levels, the centres of the priors. Chosen; the priors span six decades."""


@dataclass(frozen=True)
class UnnamedNoise:
    """A correlated noise that the catalogue lacks.

    log_odds: log odds that it takes part, against noises of the catalogue alone.
    log_prior: part of these odds that does not come from the records.
    """

    correlated: CorrelatedNoise
    log_odds: float
    log_prior: float

    @property
    def words(self) -> str:
        """What it is, in words."""
        what = "rate" if self.correlated.of_rate else "angle"
        return f"noise of the {what} that lasts {self.correlated.lag:g} s (gyro_angle)"

    def add_to(self, noise: NoiseModel) -> NoiseModel:
        """Another noise with this one added."""
        return replace(noise, correlated=self.correlated)


def fit_unnamed_noise(
    residuals: Sequence[AngleResidual], bases: Sequence[tuple[NoiseModel, float]]
) -> UnnamedNoise:
    """The most probable unnamed noise; its log odds are log likelihood plus log prior.

    Args:
        residuals: residual of the output angle in each test.
        bases: noises to which it may be added, with their log priors.
    """
    candidates = [
        _fit_lag(residuals, noise, log_prior, of_rate, lag)
        for noise, log_prior in bases
        for of_rate, lags in ((True, RATE_LAGS), (False, ANGLE_LAGS))
        for lag in lags
    ]
    return max(candidates, key=lambda noise: noise.log_odds)


def _fit_lag(
    residuals: Sequence[AngleResidual],
    base: NoiseModel,
    base_log_prior: float,
    of_rate: bool,
    lag: float,
) -> UnnamedNoise:
    """Noise of this correlation time, s, at its most probable level."""
    scale = RATE_SCALE if of_rate else ANGLE_SCALE

    def gain(logarithm: float) -> float:
        correlated = CorrelatedNoise(math.exp(logarithm), lag, of_rate)
        return log_likelihood(residuals, replace(base, correlated=correlated)) + base_log_prior

    level = fit_level(gain, scale)
    log_prior = level.log_prior(UNNAMED_ODDS / (len(RATE_LAGS) + len(ANGLE_LAGS)))
    correlated = CorrelatedNoise(math.exp(level.logarithm), lag, of_rate)
    return UnnamedNoise(correlated, level.gain + log_prior, log_prior)
