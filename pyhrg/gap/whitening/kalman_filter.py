"""The compiled Kalman filter that whitens a channel: white noise of a reading over slow noise.

The state is angle, rate and m first-order lags (docs/methods/whitening.md, Eq. 2). Angle and rate
come first, so all arrays of states have m + 2 entries. Functions that run in every row are inlined:
calls would cost up to half of the time of one series.
"""

import numpy as np

from pyhrg.common.arrays import Array
from pyhrg.common.caches.compiled import compile_loop


@compile_loop
def compute_innovations(
    series: Array,
    steps: Array,
    white: Array,
    walks: Array,
    lags: Array,
    rates: Array,
    densities: Array,
    innovations: Array,
) -> float:
    """Log determinant of the covariance of (n, p) readings; fills in the normalised innovations
    (Eqs. 6 to 10).

    `steps` are (n,) times since the reading before, s; `white` are the (n,) variances of their
    white noise, `walks` the (n, 2) spectral densities that drive angle and rate. Each of m lags
    has a time constant, s, a spectral density that drives it, and a rate: 1 where it adds to the
    rate, 0 where it adds to the reading. A covariance that repeats to the bit is not computed
    again: with equal steps and variances the filter becomes stationary.
    """
    m = len(lags) + 2
    state, innovation = np.zeros((m, series.shape[1])), np.zeros(series.shape[1])
    reading, covariance = np.zeros(m), np.zeros((m, m))
    reading[0] = 1.0
    for j in range(m - 2):
        reading[j + 2] = 1.0 - rates[j]
        covariance[j + 2, j + 2] = rates[j] * densities[j] * lags[j] / 2
    decay, angle_gain, process_noise = np.ones(m), np.zeros(m), np.zeros((m, m))
    angle_gain[0] = 1.0
    before, angle_row = covariance.copy(), np.zeros(m)
    unscaled_gain, gain = np.zeros(m), np.zeros(m)
    deviation = logarithm = log_determinant = 0.0
    changes, last_step, last_white, last_walk = True, -1.0, -1.0, -1.0
    for i in range(len(series)):
        if white[i] != last_white:
            last_white, changes = white[i], True
        if steps[i] != last_step or walks[i, 0] != last_walk:
            last_step, last_walk, changes = steps[i], walks[i, 0], True
            _fill_transition(
                last_step, walks[i], lags, rates, densities, decay, angle_gain, process_noise
            )
        if changes:
            _predict_covariance(covariance, decay, angle_gain, process_noise, angle_row)
            variance = _fill_gain(covariance, reading, last_white, unscaled_gain, gain)
            deviation, logarithm = np.sqrt(variance), np.log(variance)
            changes = _update_covariance(covariance, before, unscaled_gain, variance)
        log_determinant += logarithm
        _predict_state(state, decay, angle_gain)
        for k in range(len(innovation)):
            innovation[k] = series[i, k] - state[0, k]
        for a in range(2, m):
            if reading[a] != 0.0:
                for k in range(len(innovation)):
                    innovation[k] -= reading[a] * state[a, k]
        for k in range(len(innovation)):
            innovations[i, k] = innovation[k] / deviation
        for a in range(m):
            if gain[a] != 0.0:
                for k in range(len(innovation)):
                    state[a, k] += gain[a] * innovation[k]
    return log_determinant


@compile_loop
def _fill_transition(
    step: float,
    walks: Array,
    lags: Array,
    rates: Array,
    densities: Array,
    decay: Array,
    angle_gain: Array,
    process_noise: Array,
) -> None:
    """Transition over a step and covariance of its process noise (Eqs. 4 and 5). Overwrites the
    (m,) part of each state that remains, what each adds to the angle, and the (m, m) covariance."""
    h = step
    angle_gain[1] = h
    process_noise[0, 0] = walks[0] * h + walks[1] * h**3 / 3
    process_noise[0, 1] = process_noise[1, 0] = walks[1] * h**2 / 2
    process_noise[1, 1] = walks[1] * h
    for j in range(len(lags)):
        stays = np.exp(-h / lags[j])
        decay[j + 2] = stays
        angle_gain[j + 2] = rates[j] * lags[j] * (1 - stays)
        t, q = lags[j], densities[j]
        process_noise[j + 2, j + 2] = q * t / 2 * (1 - stays**2)
        process_noise[0, j + 2] = process_noise[j + 2, 0] = (
            rates[j] * q * t * t / 2 * (1 - stays) ** 2
        )
        process_noise[0, 0] += (
            rates[j] * q * t * t * (h - 2 * t * (1 - stays) + t / 2 * (1 - stays**2))
        )


@compile_loop(inline="always")
def _predict_covariance(
    covariance: Array, decay: Array, angle_gain: Array, process_noise: Array, angle_row: Array
) -> None:
    """Propagate the covariance over a step, in place (Eq. 6); `angle_row` is (m,) work space."""
    m = len(decay)
    for b in range(m):
        angle_row[b] = 0.0
        for c in range(m):
            angle_row[b] += angle_gain[c] * covariance[c, b]
    covariance[0, 0] = process_noise[0, 0]
    for c in range(m):
        covariance[0, 0] += angle_row[c] * angle_gain[c]
    for b in range(1, m):
        covariance[0, b] = covariance[b, 0] = angle_row[b] * decay[b] + process_noise[0, b]
        for c in range(1, m):
            covariance[b, c] = covariance[b, c] * decay[b] * decay[c] + process_noise[b, c]


@compile_loop(inline="always")
def _fill_gain(
    covariance: Array, reading: Array, white: float, unscaled_gain: Array, gain: Array
) -> float:
    """Variance of the innovation (Eq. 7). Overwrites the gain, also before its division by it."""
    variance = white
    for a in range(len(gain)):
        unscaled_gain[a] = 0.0
        for b in range(len(gain)):
            unscaled_gain[a] += covariance[a, b] * reading[b]
        variance += reading[a] * unscaled_gain[a]
    for a in range(len(gain)):
        gain[a] = unscaled_gain[a] / variance
    return variance


@compile_loop(inline="always")
def _update_covariance(
    covariance: Array, before: Array, unscaled_gain: Array, variance: float
) -> bool:
    """Condition the covariance on a reading, in place (Eq. 8); whether it differs from `before`,
    which becomes its copy."""
    changes = False
    for a in range(len(before)):
        for b in range(len(before)):
            updated = covariance[a, b] - unscaled_gain[a] * unscaled_gain[b] / variance
            changes = changes or updated != before[a, b]
            before[a, b] = covariance[a, b] = updated
    return changes


@compile_loop(inline="always")
def _predict_state(state: Array, decay: Array, angle_gain: Array) -> None:
    """Propagate the (m, p) states over a step, in place (Eq. 6)."""
    for a in range(1, len(state)):
        if angle_gain[a] != 0.0:
            for k in range(state.shape[1]):
                state[0, k] += angle_gain[a] * state[a, k]
        if decay[a] != 1.0:
            for k in range(state.shape[1]):
                state[a, k] *= decay[a]
