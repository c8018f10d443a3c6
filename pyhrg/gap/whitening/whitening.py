"""Series with slow noise made white: innovations of a Kalman filter, the same linear map for a
residual and for what might explain it.

R. E. Kalman, J. Basic Eng. 82 (1960); the likelihood by innovations: F. C. Schweppe, IEEE Trans.
Inf. Theory 11 (1965).
"""

import math
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any

import numba
import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]

DECADES = tuple(10.0**e for e in (0.5, 1.5, 2.5, 3.5, 4.5))
"""Time constants of the lags whose sum is flicker noise, s."""


@dataclass(frozen=True)
class Correlated:
    """Exponentially correlated noise (IEEE Std 952: Markov noise).

    level: standard deviation, unit/s of a rate, unit of a reading.
    lag: over which it is correlated, s.
    of_rate: whether it adds to the rate, or to the reading itself.
    """

    level: float
    lag: float
    of_rate: bool

    @property
    def kind(self) -> tuple[float, bool]:
        """What it is, whatever its level."""
        return self.lag, self.of_rate


@dataclass(frozen=True)
class SlowNoise:
    """White noise of a reading, and what walks beneath it. SI, each a field's unit.

    white: standard deviation of one reading.
    walk: angle random walk [N], unit/sqrt(s).
    rate_walk: rate random walk [K], unit/s/sqrt(s).
    flicker: bias instability [B] (IEEE Std 952), unit/s.
    lagged: density of white noise behind a first-order lag, unit/sqrt(s): the noise of a
        temperature log in what follows the resonator's temperature.
    lag: its time constant, s.
    correlated: beside all that.
    """

    white: float
    walk: float = 0.0
    rate_walk: float = 0.0
    flicker: float = 0.0
    lagged: float = 0.0
    lag: float = 600.0
    correlated: Correlated | None = None

    def at(self, part: str, level: float) -> "SlowNoise":
        """With a part at another level."""
        values: dict[str, Any] = {part: level}
        return replace(self, **values)

    def louder(self, white: float) -> "SlowNoise":
        """With this much more white noise of a reading."""
        return self.at("white", math.hypot(self.white, white)) if white else self

    @cached_property
    def states(self) -> "States":
        """The noise as a Markov process."""
        lags = [self.lag, *(DECADES if self.flicker else ())]
        rates = np.array([0.0] + [1.0] * (len(lags) - 1))
        # a lag driven by q has the density q t^2/(1 + (w t)^2); over decades of t with q = c/t they
        # add up to c pi/(2 ln 10 w): flicker B^2/w
        power = self.flicker**2 * 2 * np.log(10.0) / np.pi
        densities = [self.lagged**2 / self.lag**2, *(power / t for t in lags[1:])]
        if one := self.correlated:
            lags.append(one.lag)
            rates = np.append(rates, float(one.of_rate))
            densities.append(2 * one.level**2 / one.lag)
        return States(
            np.array(lags), rates, np.array(densities), np.array([self.walk**2, self.rate_walk**2])
        )

    @property
    def is_white(self) -> bool:
        """Whether nothing lasts from reading to reading."""
        return not (self.walk or self.rate_walk or self.flicker or self.lagged or self.correlated)


@dataclass(frozen=True)
class States:
    """Beneath a reading: an angle that walks, a rate that walks, and lags.

    lags: (m,) time constants, s.
    rates: (m,) 1 where a lag adds to the rate, 0 where it adds to the reading itself.
    densities: (m,) of the white noise that drives each lag, unit^2/s or (unit/s)^2/s.
    walks: (2,) of angle and of rate.
    """

    lags: Array
    rates: Array
    densities: Array
    walks: Array


@dataclass(frozen=True)
class Whitened:
    """Innovations over their standard deviations.

    series: (n, p).
    log_determinant: of the covariance of a series.
    """

    series: Array
    log_determinant: float


def whitened(
    series: Array, steps: Array, noise: SlowNoise, left_out: Array | None = None
) -> Whitened:
    """Innovations of series under a noise that starts at zero; flicker is as it ever was.

    Args:
        series: (n, p) residual and columns, any unit.
        steps: (n,) time from the reading before, the first from the start, s.
        noise: in the series' unit.
        left_out: (n,) by the simulation: a multiple of it, of standard deviation 1, is in the
            record beside the noise.
    """
    if left_out is None or not left_out.any():
        return _innovative(series, steps, noise)
    both = _innovative(np.column_stack([series, left_out]), steps, noise)
    shape = both.series[:, -1]
    power = float(shape @ shape)
    taken = (1 - 1 / np.sqrt(1 + power)) / power
    white = both.series[:, :-1] - taken * np.outer(shape, shape @ both.series[:, :-1])
    return Whitened(white, both.log_determinant + float(np.log1p(power)))


def _innovative(series: Array, steps: Array, noise: SlowNoise) -> Whitened:
    if noise.is_white:
        return Whitened(series / noise.white, 2 * len(series) * float(np.log(noise.white)))
    s = noise.states
    out = np.empty_like(series)
    logs = _innovations(
        np.ascontiguousarray(series), steps, noise.white**2, s.walks, s.lags, s.rates, s.densities,
        out,
    )  # fmt: skip
    return Whitened(out, float(logs))


@numba.njit(cache=True)
def _innovations(
    series: Array,
    steps: Array,
    white: float,
    walks: Array,
    lags: Array,
    rates: Array,
    densities: Array,
    out: Array,
) -> float:
    """Of angle, rate and lags: a step keeps a part of each, and adds some of each to the angle. A
    covariance that equals the last one to the bit is not computed again."""
    n, p = series.shape
    m = len(lags) + 2
    state = np.zeros((m, p))
    covariance = np.zeros((m, m))
    reading = np.zeros(m)
    reading[0] = 1.0
    for j in range(m - 2):
        reading[j + 2] = 1.0 - rates[j]
        covariance[j + 2, j + 2] = rates[j] * densities[j] * lags[j] / 2
    kept = np.ones(m)
    turns = np.zeros(m)
    turns[0] = 1.0
    added = np.zeros((m, m))
    before = covariance.copy()
    variance = deviation = logarithm = 0.0
    changes = True
    last = -1.0
    logs = 0.0
    gain = np.zeros(m)
    angle = np.zeros(m)
    miss = np.zeros(p)
    for i in range(n):
        h = steps[i]
        if h != last:
            last = h
            changes = True
            _fill(h, walks, lags, rates, densities, kept, turns, added)
        if changes:
            for b in range(m):
                angle[b] = 0.0
                for c in range(m):
                    angle[b] += turns[c] * covariance[c, b]
            covariance[0, 0] = added[0, 0]
            for c in range(m):
                covariance[0, 0] += angle[c] * turns[c]
            for b in range(1, m):
                covariance[0, b] = covariance[b, 0] = angle[b] * kept[b] + added[0, b]
                for c in range(1, m):
                    covariance[b, c] = covariance[b, c] * kept[b] * kept[c] + added[b, c]
            variance = white
            for a in range(m):
                gain[a] = 0.0
                for b in range(m):
                    gain[a] += covariance[a, b] * reading[b]
                variance += reading[a] * gain[a]
            deviation = np.sqrt(variance)
            logarithm = np.log(variance)
            changes = False
            for a in range(m):
                for b in range(m):
                    left = covariance[a, b] - gain[a] * gain[b] / variance
                    changes = changes or left != before[a, b]
                    before[a, b] = covariance[a, b] = left
        logs += logarithm
        for a in range(1, m):
            if turns[a] != 0.0:
                for k in range(p):
                    state[0, k] += turns[a] * state[a, k]
            if kept[a] != 1.0:
                for k in range(p):
                    state[a, k] *= kept[a]
        for k in range(p):
            miss[k] = series[i, k] - state[0, k]
        for a in range(2, m):
            if reading[a] != 0.0:
                for k in range(p):
                    miss[k] -= reading[a] * state[a, k]
        for k in range(p):
            out[i, k] = miss[k] / deviation
        for a in range(m):
            share = gain[a] / variance
            if share != 0.0:
                for k in range(p):
                    state[a, k] += share * miss[k]
    return logs


@numba.njit(cache=True)
def _fill(
    h: float,
    walks: Array,
    lags: Array,
    rates: Array,
    densities: Array,
    kept: Array,
    turns: Array,
    added: Array,
) -> None:
    """What a step keeps of each state, adds of each to the angle, and adds to the covariance."""
    turns[1] = h
    added[0, 0] = walks[0] * h + walks[1] * h**3 / 3
    added[0, 1] = added[1, 0] = walks[1] * h**2 / 2
    added[1, 1] = walks[1] * h
    for j in range(len(lags)):
        stays = np.exp(-h / lags[j])
        kept[j + 2] = stays
        turns[j + 2] = rates[j] * lags[j] * (1 - stays)
        t, q = lags[j], densities[j]
        added[j + 2, j + 2] = q * t / 2 * (1 - stays**2)
        added[0, j + 2] = added[j + 2, 0] = rates[j] * q * t * t / 2 * (1 - stays) ** 2
        added[0, 0] += rates[j] * q * t * t * (h - 2 * t * (1 - stays) + t / 2 * (1 - stays**2))
