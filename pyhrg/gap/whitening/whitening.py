"""Noise of one channel: its draws, and its whitening by a Kalman filter to normalised innovations.

The same linear map is applied to the residual and to every column that may explain it. The state
model, the filter and the likelihood are Eqs. 1 to 12 of docs/methods/whitening.md. Sources:
R. E. Kalman, J. Basic Eng. 82 (1960); F. C. Schweppe, IEEE Trans. Inf. Theory 11 (1965).
"""

from dataclasses import dataclass, field, replace
from functools import lru_cache
from typing import Any

import numpy as np
from scipy.signal import lfilter

from pyhrg.common.arrays import Array
from pyhrg.gap.whitening.kalman_filter import compute_innovations
from pyhrg.noise.coefficients import compute_process_variance

FLICKER_PROCESS_TIMES = tuple(10.0**e for e in (0.5, 1.5, 2.5, 3.5, 4.5))
"""Correlation times of the Gauss-Markov processes whose sum approximates flicker noise, s. Chosen:
one a decade. Their sum is flat to 6 % from 10 s to an hour (test_the_sum_of_lags_is_flicker)."""


@dataclass(frozen=True)
class CorrelatedNoise:
    """Exponentially correlated noise (Markov noise in IEEE Std 952).

    level: standard deviation; unit/s if it is a noise of the rate, else the series' unit.
    lag: correlation time, s.
    of_rate: True if it adds to the rate, False if it adds to the reading itself.
    """

    level: float
    lag: float
    of_rate: bool

    @property
    def kind(self) -> tuple[float, bool]:
        """All that identifies it except its level."""
        return self.lag, self.of_rate


@dataclass(frozen=True)
class NoiseModel:
    """Noise of one channel, as a sum of independent terms. Levels are in the channel's SI unit.

    angle_white_noise: standard deviation of the white noise of one reading, quantization included.
    angle_random_walk: coefficient N, unit/sqrt(s).
    rate_random_walk: coefficient K, unit/s/sqrt(s).
    bias_instability: coefficient B, unit/s (IEEE Std 952).
    lagged: root density of white noise behind a first-order lag, unit sqrt(s). A temperature log's
        noise reaches a channel in this form, through the resonator's thermal lag.
    lag: time constant of that lag, s.
    offset: standard deviation of a constant error behind a first-order lag.
    offset_lag: time constant of that lag, s; 0 of an error that is whole from the first reading on.
    correlated: further, exponentially correlated, terms.
    reading_noise: (n,) standard deviations of further white noise of each reading.
    white_growth, walk_growth: (n,) factors of the white noise of each reading, and of the angle
        random walk up to it.
    """

    angle_white_noise: float
    angle_random_walk: float = 0.0
    rate_random_walk: float = 0.0
    bias_instability: float = 0.0
    lagged: float = 0.0
    lag: float = 600.0
    offset: float = 0.0
    offset_lag: float = 0.0
    correlated: tuple[CorrelatedNoise, ...] = ()
    reading_noise: Array | None = field(default=None, compare=False)
    white_growth: Array | None = field(default=None, compare=False)
    walk_growth: Array | None = field(default=None, compare=False)

    def at(self, term: str, level: float) -> "NoiseModel":
        """This noise with one term, a field's name, at another level."""
        values: dict[str, Any] = {term: level}
        return replace(self, **values)

    def as_in(self, other: "NoiseModel") -> "NoiseModel":
        """This noise in the readings of another one."""
        return replace(
            self,
            reading_noise=other.reading_noise,
            white_growth=other.white_growth,
            walk_growth=other.walk_growth,
        )

    def compute_white_noise(self, n: int) -> Array:
        """(n,) standard deviation of each reading's white noise, of either kind."""
        growth = np.ones(n) if self.white_growth is None else self.white_growth
        own = self.angle_white_noise * growth
        return own if self.reading_noise is None else np.hypot(own, self.reading_noise)

    def shape_offset(self, time: Array) -> Array:
        """(n,) standard deviation of the constant error at times since power-on, s."""
        return self.offset * rise_behind_lag(time, self.offset_lag)

    def compute_walk_growth(self, n: int) -> Array:
        """(n,) factor of the angle random walk up to each reading."""
        return np.ones(n) if self.walk_growth is None else self.walk_growth

    @property
    @lru_cache(maxsize=64)  # noqa: B019 - noises are small
    def states(self) -> "MarkovStates":
        """The slow terms as a Markov process (docs/methods/whitening.md, Eqs. 2 and 3); the same
        object for noises that differ by the readings alone."""
        each = [(self.lag, 0.0, self.lagged**2 / self.lag**2)] if self.lagged else []
        if self.bias_instability:
            variance = compute_process_variance(self.bias_instability)
            each += [(time, 1.0, 2 * variance / time) for time in FLICKER_PROCESS_TIMES]
        each += [(c.lag, float(c.of_rate), 2 * c.level**2 / c.lag) for c in self.correlated]
        lags, rates, densities = np.array(each).reshape(-1, 3).T.copy()
        walks = np.array([self.angle_random_walk**2, self.rate_random_walk**2])
        return MarkovStates(lags, rates, densities, walks)


@dataclass(frozen=True)
class MarkovStates:
    """State model of slow noise: an angle and a rate that walk, and m first-order lags.

    lags: (m,) time constants, s.
    rates: (m,) 1 where a lag adds to the rate, 0 where it adds to the reading.
    densities: (m,) spectral density of the white noise that drives each lag,
        (unit/s)^2/s or unit^2/s.
    walks: (2,) spectral densities that drive the angle, unit^2/s, and the rate, (unit/s)^2/s.
    """

    lags: Array
    rates: Array
    densities: Array
    walks: Array


@dataclass(frozen=True)
class WhitenedSeries:
    """Innovations over their standard deviations.

    series: (n, p), dimensionless; white with variance 1 where the noise model holds.
    log_determinant: natural logarithm of the determinant of one series' noise covariance.
    """

    series: Array
    log_determinant: float


def rise_behind_lag(time: Array, lag: float) -> Array:
    """(n,) what a first-order lag, s, shows of a constant 1 at times since power-on, s."""
    return -np.expm1(-time / lag) if lag else np.ones(len(time))


def whiten(
    series: Array, steps: Array, noise: NoiseModel, unmodelled: Array | None = None
) -> WhitenedSeries:
    """Normalised innovations of each column of (n, p) series under one noise model.

    All slow terms start at zero with the first of the (n,) steps, s, except that flicker and
    correlated noise of the rate start in their stationary state. `unmodelled` are (n,) or (n, m)
    shapes that the simulation lacks: a multiple of each with standard deviation 1 counts as noise
    (docs/methods/whitening.md, Eqs. 11 and 12).
    """
    shapes = np.empty((len(series), 0)) if unmodelled is None else unmodelled
    if noise.offset:
        shapes = np.column_stack([shapes, noise.shape_offset(np.cumsum(steps))])
    if not shapes.any():
        return _whiten_by_filter(series, steps, noise)
    both = _whiten_by_filter(np.column_stack([series, shapes]), steps, noise)
    white, shapes = np.split(both.series, [series.shape[1]], axis=1)
    units, sizes, _ = np.linalg.svd(shapes, full_matrices=False)
    shrinking = 1 - 1 / np.sqrt(1 + sizes**2)
    white = white - units @ (shrinking[:, None] * (units.T @ white))
    return WhitenedSeries(white, both.log_determinant + float(np.log1p(sizes**2).sum()))


def _whiten_by_filter(series: Array, steps: Array, noise: NoiseModel) -> WhitenedSeries:
    white = noise.compute_white_noise(len(series))
    slow = noise.angle_random_walk, noise.rate_random_walk, noise.bias_instability
    if not (any(slow) or noise.lagged or noise.correlated):
        return WhitenedSeries(series / white[:, None], 2 * float(np.log(white).sum()))
    s = noise.states
    grown = s.walks[0] * noise.compute_walk_growth(len(series)) ** 2
    walks = np.column_stack([grown, np.full(len(series), s.walks[1])])
    innovations = np.empty_like(series)
    log_determinant = compute_innovations(
        np.ascontiguousarray(series), steps, white**2, walks, s.lags, s.rates, s.densities,
        innovations,
    )  # fmt: skip
    return WhitenedSeries(innovations, float(log_determinant))


def draw_noise(noise: NoiseModel, n: int, interval: float, generator: np.random.Generator) -> Array:
    """(n,) readings of one channel's noise, in its unit, `interval` seconds apart.

    Slow terms start at zero; flicker starts in its stationary state, as `whiten` assumes.
    """
    rate = np.zeros(n)
    if noise.rate_random_walk:
        rate += np.cumsum(generator.normal(0.0, noise.rate_random_walk * np.sqrt(interval), n))
    reading = np.zeros(n)
    states = noise.states
    for lag, is_rate, density in zip(states.lags, states.rates, states.densities, strict=True):
        if density:  # lags of the rate are stationary from the start, the others start at zero
            kept, power = np.exp(-interval / lag), density * lag / 2
            steps = generator.normal(0.0, np.sqrt(power * (1 - kept**2)), n)
            if is_rate:
                steps[0] = generator.normal(0.0, np.sqrt(power))
            lagging = rate if is_rate else reading
            lagging += np.asarray(lfilter([1.0], [1.0, -kept], steps))
    if noise.offset:
        reading += generator.normal() * noise.shape_offset(interval * np.arange(1.0, n + 1))
    walks = noise.angle_random_walk * noise.compute_walk_growth(n)
    steps = generator.normal(0.0, walks * np.sqrt(interval), n)
    walk = np.cumsum(rate * interval + steps)
    return np.asarray(reading + walk + generator.normal(0.0, noise.compute_white_noise(n)))
