"""Distance between simulation and record in the output angle, and its noise floor."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.stats import chi2

from pyhrg.gap.replay.observations import ObservedTest
from pyhrg.gap.whitening.noise_draws import draw_noise
from pyhrg.gap.whitening.whitening import NoiseModel, whiten

Array = NDArray[np.float64]

RATE_WINDOW = 100.0
"""Time over which the rate residual is taken, s: the campaign format's."""
NOISE_DRAWS = 200
"""Number of noise draws that make the floor and its 95 % interval. Chosen."""
MAX_LAG = 10
"""Number of lags of the portmanteau test for whiteness, rows. Chosen."""


@dataclass(frozen=True)
class Spread:
    """Median of a figure over noise draws, and its 95 % interval."""

    value: float
    interval: tuple[float, float]


@dataclass(frozen=True)
class Distance:
    """Root mean square over tests of the angle residual, rad, and of the rate residual over 100 s,
    rad/s (docs/methods/verdict.md, Eq. (4))."""

    angle: float
    rate: float


@dataclass(frozen=True)
class Floor:
    """Noise floor: the distances that noise alone would leave of a perfect simulation."""

    angle: Spread
    rate: Spread


def measure_distance(tests: Sequence[ObservedTest], residuals: Sequence[Array]) -> Distance:
    """Distance of residuals of the output angle, (n,) rad in each test; NaN is left out."""
    rates = [_rates(t, r) for t, r in zip(tests, residuals, strict=True)]
    return Distance(_rms(np.concatenate(residuals)), _rms(np.concatenate(rates)))


def estimate_noise_floor(tests: Sequence[ObservedTest], noise: NoiseModel, seed: int) -> Floor:
    """Estimate the noise floor by draws of the noise.

    Args:
        tests: tests whose rows are compared.
        noise: noise of the output angle.
        seed: seed of the draws.
    """
    generator = np.random.default_rng(seed)
    distances = []
    for _ in range(NOISE_DRAWS):
        distance = measure_distance(tests, [_draw_angle(t, noise, generator) for t in tests])
        distances.append((distance.angle, distance.rate))
    angle, rate = np.array(distances).T
    return Floor(_spread(angle), _spread(rate))


def compute_whiteness(
    tests: Sequence[ObservedTest], residuals: Sequence[Array], noise: NoiseModel
) -> float:
    """p-value of the Ljung-Box test that whitened residuals are uncorrelated (docs/methods/
    verdict.md, Eq. (6); G. M. Ljung, G. E. P. Box, Biometrika 65 (1978)).

    Args:
        tests: the tests of the residuals.
        residuals: (n,) residual of the output angle in each test, rad; NaN is left out.
        noise: noise of the output angle.
    """
    statistic, degrees = 0.0, 0
    for test, residual in zip(tests, residuals, strict=True):
        rows = np.isfinite(residual)
        steps = np.diff(test.log.time[rows], prepend=0.0)
        own = noise.add_white(test.encoder_noise)
        white = whiten(residual[rows][:, None], steps, own).series[:, 0]
        n, power = len(white), float(white @ white)
        for lag in range(1, min(MAX_LAG, n - 1) + 1):
            correlation = float(white[lag:] @ white[:-lag]) / power
            statistic += n * (n + 2) * correlation**2 / (n - lag)
            degrees += 1
    return float(chi2.sf(statistic, degrees))


def _rates(test: ObservedTest, residual: Array) -> Array:
    rows = max(1, round(RATE_WINDOW / test.log.interval))
    ends = residual[::rows]
    return np.asarray(np.diff(ends) / (rows * test.log.interval))


def _rms(values: Array) -> float:
    known = values[np.isfinite(values)]
    return float(np.sqrt(np.mean(known**2))) if len(known) else float("nan")


def _draw_angle(test: ObservedTest, noise: NoiseModel, generator: np.random.Generator) -> Array:
    """(n,) output angle of noise alone, rad; NaN in rows that are not compared."""
    own = noise.add_white(test.encoder_noise)
    angle = draw_noise(own, len(test.log.time), test.log.interval, generator)
    return np.where(test.rows["gyro_angle"], angle, np.nan)


def _spread(values: Array) -> Spread:
    low, middle, high = np.quantile(values, (0.025, 0.5, 0.975))
    return Spread(float(middle), (float(low), float(high)))
