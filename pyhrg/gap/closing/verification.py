"""How far apart simulation and record are in the output angle, and what noise alone would leave."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.stats import chi2

from pyhrg.gap.replay.observations import Observed
from pyhrg.gap.whitening.noise_draws import drawn
from pyhrg.gap.whitening.whitening import SlowNoise, whitened

Array = NDArray[np.float64]

WINDOW = 100.0
"""Over which a rate residual is taken, s."""
DRAWS = 200
"""Of noise, for what it leaves."""
LAGS = 10
"""Of the correlation by which whiteness is judged."""


@dataclass(frozen=True)
class Spread:
    """A figure, and its 95 % interval where it is drawn."""

    value: float
    interval: tuple[float, float]


@dataclass(frozen=True)
class Distance:
    """Root mean squares over some tests: angle in rad, rate over 100 s in rad/s."""

    angle: float
    rate: float


@dataclass(frozen=True)
class Floor:
    """The same of noise alone, median of draws and 95 % interval."""

    angle: Spread
    rate: Spread


def distance(tests: Sequence[Observed], residuals: Sequence[Array]) -> Distance:
    """Of residuals of the output angle, (n,) rad each; NaN is left out."""
    rates = [_rates(t, r) for t, r in zip(tests, residuals, strict=True)]
    return Distance(_rms(np.concatenate(residuals)), _rms(np.concatenate(rates)))


def floor(tests: Sequence[Observed], noise: SlowNoise, seed: int) -> Floor:
    """What noise leaves of a perfect simulation, by draws of it.

    Args:
        tests: whose rows count.
        noise: of the output angle.
        seed: of the draws.
    """
    generator = np.random.default_rng(seed)
    drawn = []
    for _ in range(DRAWS):
        angles = [_drawn(t, noise, generator) for t in tests]
        found = distance(tests, angles)
        drawn.append((found.angle, found.rate))
    angle, rate = np.array(drawn).T
    return Floor(_spread(angle), _spread(rate))


def whiteness(tests: Sequence[Observed], residuals: Sequence[Array], noise: SlowNoise) -> float:
    """p-value that whitened residuals have no correlation over `LAGS` rows (G. M. Ljung,
    G. E. P. Box, Biometrika 65 (1978)).

    Args:
        tests: as their rows count.
        residuals: (n,) of the output angle, rad.
        noise: of the output angle.
    """
    statistic, degrees = 0.0, 0
    for test, residual in zip(tests, residuals, strict=True):
        rows = np.isfinite(residual)
        steps = np.diff(test.log.time[rows], prepend=0.0)
        own = noise.louder(test.encoder)
        white = whitened(residual[rows][:, None], steps, own).series[:, 0]
        n, power = len(white), float(white @ white)
        for lag in range(1, min(LAGS, n - 1) + 1):
            correlation = float(white[lag:] @ white[:-lag]) / power
            statistic += n * (n + 2) * correlation**2 / (n - lag)
            degrees += 1
    return float(chi2.sf(statistic, degrees))


def _rates(test: Observed, residual: Array) -> Array:
    rows = max(1, round(WINDOW / test.log.interval))
    ends = residual[::rows]
    return np.asarray(np.diff(ends) / (rows * test.log.interval))


def _rms(values: Array) -> float:
    known = values[np.isfinite(values)]
    return float(np.sqrt(np.mean(known**2))) if len(known) else float("nan")


def _drawn(test: Observed, noise: SlowNoise, generator: np.random.Generator) -> Array:
    """(n,) angles of noise alone, rad."""
    own = noise.louder(test.encoder)
    angle = drawn(own, len(test.log.time), test.log.interval, generator)
    return np.where(test.rows["gyro_angle"], angle, np.nan)


def _spread(values: Array) -> Spread:
    low, middle, high = np.quantile(values, (0.025, 0.5, 0.975))
    return Spread(float(middle), (float(low), float(high)))
