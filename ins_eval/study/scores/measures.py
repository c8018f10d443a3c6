"""Statistics of flown and predicted errors: (..., r, m) of r triads in m missions.

A statistic that a sample can't tell is NaN: R2 where all triads are the same, as in a resample.
"""

import numpy as np
from numpy.typing import NDArray
from scipy.stats import rankdata

Array = NDArray[np.float64]


def r2(flown: Array, predicted: Array) -> Array:
    """1 less the mean square about predicted = flown over the variance; nothing is refitted."""
    return 1 - _ratio(_mean_square(flown - predicted), np.var(flown, axis=(-2, -1)))


def r2_components(flown: Array, predicted: Array) -> Array:
    """The same of errors north and east (..., r, m, 2), about zero."""
    missed = np.sum((flown - predicted) ** 2, axis=(-3, -2, -1))
    return 1 - _ratio(missed, np.sum(flown**2, axis=(-3, -2, -1)))


def median_ratio(flown: Array, predicted: Array) -> Array:
    """Median of flown over predicted."""
    return np.asarray(np.median(_ratio(flown, predicted), axis=(-2, -1)))


def optimism(flown: Array, predicted: Array) -> Array:
    """Root mean square of the flown over that of the predicted: above 1 is too good a promise."""
    return np.sqrt(_ratio(_mean_square(flown), _mean_square(predicted)))


def variance_removed(flown: Array, predicted: Array, reference: Array) -> Array:
    """Share of what a reference leaves unexplained that a prediction, as it stands, removes.

    The reference is refitted, scale and offset mission by mission, so that neither its bias nor the
    spread between missions counts for the prediction; a wide spread of devices, which the reference
    sees too, does not either.
    """
    apart = flown - flown.mean(axis=-2, keepdims=True)
    wave = reference - reference.mean(axis=-2, keepdims=True)
    power = np.sum(wave**2, axis=-2, keepdims=True)
    slope = np.sum(apart * wave, axis=-2, keepdims=True) / np.where(power > 0, power, 1.0)
    left = apart - slope * wave
    return 1 - _ratio(_mean_square(flown - predicted), _mean_square(left))


def miss(flown: Array, predicted: Array) -> Array:
    """Mean magnitude of the logarithm of flown over predicted: 0.7 is a factor of 2."""
    return np.asarray(np.mean(np.abs(np.log(_ratio(flown, predicted))), axis=(-2, -1)))


def advantage(flown: Array, predicted: Array, reference: Array) -> Array:
    """How much smaller a prediction's `miss` is than a reference's."""
    return np.asarray(miss(flown, reference) - miss(flown, predicted))


def width_ratio(low: Array, high: Array, other_low: Array, other_high: Array) -> Array:
    """Median width of intervals over the median width of others."""
    own, other = high - low, other_high - other_low
    return _ratio(np.median(own, axis=(-2, -1)), np.median(other, axis=(-2, -1)))


def unpredictable_share(unpredictable: Array, expected: Array) -> Array:
    """Root mean square of what can't be predicted over that of expected errors (..., r, m, 2)."""
    power = np.mean(np.sum(expected**2, axis=-1), axis=(-2, -1))
    return np.sqrt(_ratio(_mean_square(unpredictable), power))


def spearman(flown: Array, figure: Array) -> Array:
    """Rank correlation over gyros (..., r, m, 3), mean over missions."""
    return np.asarray(np.mean(_correlation(_ranks(flown), _ranks(figure)), axis=-1))


def _ranks(values: Array) -> Array:
    """(..., m, 3 r)"""
    gyros = np.moveaxis(values, -2, -3)
    return np.asarray(rankdata(gyros.reshape(*gyros.shape[:-2], -1), axis=-1))


def _correlation(a: Array, b: Array) -> Array:
    a, b = (x - x.mean(axis=-1, keepdims=True) for x in (a, b))
    power = np.sum(a**2, axis=-1) * np.sum(b**2, axis=-1)
    return _ratio(np.sum(a * b, axis=-1), np.sqrt(power))


def _ratio(over: Array, under: Array) -> Array:
    """NaN over nothing."""
    return np.divide(over, under, out=np.full(np.shape(over), np.nan), where=under > 0)


def _mean_square(values: Array) -> Array:
    return np.asarray(np.mean(values**2, axis=(-2, -1)))
