"""Series with slow noise made white: innovations of a Kalman filter, the same linear map for a
residual and for what might explain it.

R. E. Kalman, J. Basic Eng. 82 (1960); the likelihood by innovations: F. C. Schweppe, IEEE Trans.
Inf. Theory 11 (1965).
"""

from dataclasses import dataclass
from functools import cached_property

import numba
import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]

DECADES = tuple(10.0**e for e in (0.5, 1.5, 2.5, 3.5, 4.5))
"""Time constants of the lags whose sum is flicker noise, s."""


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
    """

    white: float
    walk: float = 0.0
    rate_walk: float = 0.0
    flicker: float = 0.0
    lagged: float = 0.0
    lag: float = 600.0

    @cached_property
    def states(self) -> "States":
        """The noise as a Markov process."""
        lags = [self.lag, *(DECADES if self.flicker else ())]
        rates = np.array([0.0] + [1.0] * (len(lags) - 1))
        # a lag driven by q has the density q t^2/(1 + (w t)^2); over decades of t with q = c/t they
        # add up to c pi/(2 ln 10 w): flicker B^2/w
        power = self.flicker**2 * 2 * np.log(10.0) / np.pi
        densities = [self.lagged**2 / self.lag**2, *(power / t for t in lags[1:])]
        return States(
            np.array(lags), rates, np.array(densities), np.array([self.walk**2, self.rate_walk**2])
        )


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


def whitened(series: Array, steps: Array, noise: SlowNoise) -> Whitened:
    """Innovations of series under a noise that starts at zero; flicker is as it ever was.

    Args:
        series: (n, p) residual and columns, any unit.
        steps: (n,) time from the reading before, the first from the start, s.
        noise: in the series' unit.
    """
    if not (noise.walk or noise.rate_walk or noise.flicker or noise.lagged):
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
    n, p = series.shape
    m = len(lags) + 2
    state = np.zeros((m, p))
    covariance = np.zeros((m, m))
    moved = np.zeros((m, m))
    reading = np.zeros(m)
    reading[0] = 1.0
    for j in range(m - 2):
        reading[j + 2] = 1.0 - rates[j]
        covariance[j + 2, j + 2] = rates[j] * densities[j] * lags[j] / 2
    transition = np.eye(m)
    added = np.zeros((m, m))
    last = -1.0
    logs = 0.0
    gain = np.zeros(m)
    before = np.zeros(m)
    for i in range(n):
        h = steps[i]
        if h != last:
            last = h
            transition[0, 1] = h
            added[0, 0] = walks[0] * h + walks[1] * h**3 / 3
            added[0, 1] = added[1, 0] = walks[1] * h**2 / 2
            added[1, 1] = walks[1] * h
            for j in range(m - 2):
                kept = np.exp(-h / lags[j])
                transition[j + 2, j + 2] = kept
                transition[0, j + 2] = rates[j] * lags[j] * (1 - kept)
                t, q = lags[j], densities[j]
                added[j + 2, j + 2] = q * t / 2 * (1 - kept**2)
                added[0, j + 2] = added[j + 2, 0] = rates[j] * q * t * t / 2 * (1 - kept) ** 2
                added[0, 0] += (
                    rates[j] * q * t * t * (h - 2 * t * (1 - kept) + t / 2 * (1 - kept**2))
                )
        for a in range(m):
            for b in range(m):
                total = 0.0
                for c in range(m):
                    total += transition[a, c] * covariance[c, b]
                moved[a, b] = total
        for a in range(m):
            for b in range(m):
                total = added[a, b]
                for c in range(m):
                    total += moved[a, c] * transition[b, c]
                covariance[a, b] = total
        for a in range(m):
            total = 0.0
            for b in range(m):
                total += covariance[a, b] * reading[b]
            gain[a] = total
        variance = white
        for a in range(m):
            variance += reading[a] * gain[a]
        deviation = np.sqrt(variance)
        logs += np.log(variance)
        for k in range(p):
            for a in range(m):
                total = 0.0
                for c in range(m):
                    if transition[a, c] != 0.0:
                        total += transition[a, c] * state[c, k]
                before[a] = total
            expected = 0.0
            for a in range(m):
                expected += reading[a] * before[a]
            miss = series[i, k] - expected
            out[i, k] = miss / deviation
            for a in range(m):
                state[a, k] = before[a] + gain[a] / variance * miss
        for a in range(m):
            for b in range(m):
                moved[a, b] = covariance[a, b] - gain[a] * gain[b] / variance
        for a in range(m):
            for b in range(m):
                covariance[a, b] = moved[a, b]
    return logs
