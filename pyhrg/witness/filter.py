"""Recursive estimate of constant states from rows with white noise, robust to bursts.

A Kalman filter in Joseph's form (Bierman 1977) whose innovations are limited by Huber's function
(Huber 1981, section 7.3): a row beyond `HUBER` standard deviations counts as one of a noise that
puts it there.
"""

from dataclasses import dataclass

import numpy as np
from scipy.stats import chi2

from pyhrg.common.arrays import Array
from pyhrg.common.caches.compiled import compile_loop

HUBER = 3.0
"""Innovation beyond which a row loses weight, in standard deviations. Chosen: 0.3 % of normal
rows."""
WINDOW = 12
"""Number of rows whose innovations are added in the test of the model. Chosen: a minute of rows of
5 s."""


@dataclass(frozen=True)
class Filtered:
    """States after all rows, in units of their prior deviations.

    Attributes:
        mean: (p,).
        covariance: (p, p).
        weights: (n, channels) of the rows, 1 but for bursts.
        p_value: probability of innovations as far from white as these, if the model holds.
    """

    mean: Array
    covariance: Array
    weights: Array
    p_value: float


def filter_rows(
    design: Array, values: Array, noise: Array, prior: Array, scatter: Array | None = None
) -> Filtered:
    """The estimate from rows in their order.

    design: (n, channels, p) per unit of the states; values: (n, channels); noise: (channels,)
    standard deviations of white noise; prior: (p, p) covariance of the states, whose mean is zero;
    scatter: (channels,) standard deviations of rows, `noise` by default: more where noise that
    averages out faster than white noise adds to it. Bursts are judged by it.
    """
    weights, innovations = np.ones(values.shape), np.empty(values.shape)
    mean, covariance = np.zeros(len(prior)), prior.copy()
    spread = noise if scatter is None else scatter
    _filter_in_order(design, values, noise, spread, mean, covariance, weights, innovations)
    return Filtered(mean, covariance, weights, compute_whiteness(innovations))


@compile_loop
def _filter_in_order(
    design: Array,
    values: Array,
    noise: Array,
    scatter: Array,
    mean: Array,
    covariance: Array,
    weights: Array,
    innovations: Array,
) -> None:
    """Bring mean and covariance from the prior to the estimate; fill in weights and innovations."""
    states = len(mean)
    spread = np.empty(states)
    for row in range(len(values)):
        for channel in range(values.shape[1]):
            predicted, error = 0.0, values[row, channel]
            for i in range(states):
                spread[i] = 0.0
                for j in range(states):
                    spread[i] += covariance[i, j] * design[row, channel, j]
                predicted += design[row, channel, i] * spread[i]
                error -= design[row, channel, i] * mean[i]
            variance = noise[channel] ** 2
            size = abs(error) / np.sqrt(predicted + scatter[channel] ** 2)
            if size > HUBER:
                weights[row, channel] = HUBER / size
                variance = (error / HUBER) ** 2 - predicted
            total = predicted + variance
            innovations[row, channel] = error / np.sqrt(total)
            for i in range(states):
                gain = spread[i] / total
                mean[i] += gain * error
                for j in range(states):
                    other = spread[j] / total
                    joseph = gain * other * total - gain * spread[j] - spread[i] * other
                    covariance[i, j] += joseph


def compute_whiteness(innovations: Array) -> float:
    """Probability of sums over windows as large as these of innovations (n, channels), if they are
    white.

    Each sum is divided by the root of its sum of squares, so that a burst counts no more than a
    quiet window. The square of the quotient then has the mean 1 and a smaller variance than that of
    chi-square, which makes the test careful.
    """
    windows = len(innovations) // WINDOW
    if windows == 0:
        return 1.0
    parts = innovations[: windows * WINDOW].reshape(windows, WINDOW, -1)
    sums = parts.sum(axis=1) / np.sqrt(np.square(parts).sum(axis=1))
    return float(chi2.sf(np.square(sums).sum(), sums.size))
