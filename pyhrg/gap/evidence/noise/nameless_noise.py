"""Noise of the output angle that the catalogue doesn't have: it lasts, nobody knows how long."""

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace

from pyhrg.common.units import ARCSEC, DEG_PER_H
from pyhrg.gap.evidence.noise.noise_levels import AngleRecord, level_found, log_likelihood
from pyhrg.gap.whitening.whitening import Correlated, SlowNoise

ODDS = 0.05
"""Prior odds of one."""
RATE_LAGS = (1.0, 10.0, 30.0, 100.0, 300.0, 1e3, 3e3, 1e4)
ANGLE_LAGS = (0.03, 3.0, 30.0, 300.0)
"""Over which it may be correlated, s; the shortest is white."""
RATE_SCALE, ANGLE_SCALE = 0.1 * DEG_PER_H, 0.1 * ARCSEC
"""Sizes that are nothing special."""


@dataclass(frozen=True)
class Nameless:
    """A noise that the catalogue doesn't have.

    correlated: what it is.
    log_odds: that it takes part, rather than named ones alone.
    log_prior: of that, what doesn't come from the records.
    """

    correlated: Correlated
    log_odds: float
    log_prior: float

    @property
    def words(self) -> str:
        """What it is, for people."""
        what = "rate" if self.correlated.of_rate else "angle"
        return f"noise of the {what} that lasts {self.correlated.lag:g} s (gyro_angle)"

    def beside(self, noise: SlowNoise) -> SlowNoise:
        """Another noise, with this one."""
        return replace(noise, correlated=self.correlated)


def likeliest(
    records: Sequence[AngleRecord], beside: Sequence[tuple[SlowNoise, float]]
) -> Nameless:
    """The likeliest; its odds are the logarithm of likelihood and prior.

    Args:
        records: of all tests.
        beside: other noises that it may stand beside, with the logarithms of their priors.
    """
    found = [
        _lasting(records, noise, log_prior, of_rate, lag)
        for noise, log_prior in beside
        for of_rate, lags in ((True, RATE_LAGS), (False, ANGLE_LAGS))
        for lag in lags
    ]
    return max(found, key=lambda one: one.log_odds)


def _lasting(
    records: Sequence[AngleRecord], noise: SlowNoise, log_prior: float, of_rate: bool, lag: float
) -> Nameless:
    """Noise that lasts so long, at its likeliest level."""
    scale = RATE_SCALE if of_rate else ANGLE_SCALE

    def gain(logarithm: float) -> float:
        correlated = Correlated(math.exp(logarithm), lag, of_rate)
        return log_likelihood(records, replace(noise, correlated=correlated)) + log_prior

    level = level_found(gain, scale)
    own = level.log_prior(ODDS / (len(RATE_LAGS) + len(ANGLE_LAGS)))
    return Nameless(Correlated(math.exp(level.logarithm), lag, of_rate), level.gain + own, own)
