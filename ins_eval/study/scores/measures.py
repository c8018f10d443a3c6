"""Statistics of flown and predicted errors (..., r, m) of r triads in m missions (Eqs. 11 to 14).

A statistic that is not defined for a sample is NaN, such as R2 of a resample whose triads are all
the same.
"""

import numpy as np
from scipy.stats import rankdata

from pyhrg.common.arrays import Array


def compute_r2(flown: Array, predicted: Array) -> Array:
    """(...,) coefficient of determination of predicted = flown, without refit (Eq. 11)."""
    return 1 - _divide(_compute_mean_square(flown - predicted), np.var(flown, axis=(-2, -1)))


def compute_component_r2(flown: Array, predicted: Array) -> Array:
    """(...,) R2 of errors north and east (..., r, m, 2), about zero (Eq. 12)."""
    residual = np.sum((flown - predicted) ** 2, axis=(-3, -2, -1))
    return 1 - _divide(residual, np.sum(flown**2, axis=(-3, -2, -1)))


def compute_power_share(flown: Array, part: Array) -> Array:
    """(...,) mean square of `part` over that of the flown errors (..., r, m, 2)."""
    power, whole = (np.sum(each**2, axis=(-3, -2, -1)) for each in (part, flown))
    return _divide(power, whole)


def compute_r2_gain(flown: Array, predicted: Array, reference: Array) -> Array:
    """(...,) R2 of predictions less that of others for the same flights (Eq. 11)."""
    return compute_r2(flown, predicted) - compute_r2(flown, reference)


def compute_interval_score(
    flown: Array, low: Array, median: Array, high: Array, inside: float
) -> Array:
    """(...,) mean weighted interval score of errors (..., r, m): a proper score, in their unit.

    It approximates the continuous ranked probability score by a median and one central interval
    (Bracher et al. 2021, doi 10.1371/journal.pcbi.1008618, Eq. 1 to 3 with K = 1); smaller is
    better.

    Args:
        inside: probability of the interval from `low` to `high`.
    """
    outside = 1 - inside
    missed = np.maximum(low - flown, 0) + np.maximum(flown - high, 0)
    interval = high - low + 2 / outside * missed
    score = (np.abs(flown - median) / 2 + outside / 2 * interval) / 1.5
    return np.asarray(score.mean(axis=(-2, -1)))


def compute_skill(
    flown: Array,
    low: Array,
    median: Array,
    high: Array,
    reference_low: Array,
    reference_median: Array,
    reference_high: Array,
    inside: float,
) -> Array:
    """(...,) 1 less the interval score of predictions over that of a reference (Eq. 15a)."""
    own = compute_interval_score(flown, low, median, high, inside)
    reference = compute_interval_score(
        flown, reference_low, reference_median, reference_high, inside
    )
    return 1 - _divide(own, reference)


def compute_median_ratio(flown: Array, predicted: Array) -> Array:
    """(...,) median of flown over predicted (Eq. 13)."""
    return np.asarray(np.median(_divide(flown, predicted), axis=(-2, -1)))


def compute_spearman(flown: Array, figure: Array) -> Array:
    """(...,) Spearman's rank correlation over gyros (..., r, m, 3), mean over missions (Eq. 14)."""
    return np.asarray(np.mean(_correlate(_rank_gyros(flown), _rank_gyros(figure)), axis=-1))


def compute_flight_spearman(flown: Array, figure: Array) -> Array:
    """(...,) Spearman's rank correlation over triads (..., r, m), mean over missions."""
    ranked = (np.swapaxes(rankdata(each, axis=-2), -1, -2) for each in (flown, figure))
    return np.asarray(np.mean(_correlate(*ranked), axis=-1))


def compute_flight_spearman_gain(flown: Array, figure: Array, reference: Array) -> Array:
    """(...,) `compute_flight_spearman` of a bench figure less that of another one."""
    return compute_flight_spearman(flown, figure) - compute_flight_spearman(flown, reference)


def _rank_gyros(values: Array) -> Array:
    """(..., m, 3 r) ranks of all gyros in each mission."""
    gyros = np.moveaxis(values, -2, -3)
    return np.asarray(rankdata(gyros.reshape(*gyros.shape[:-2], -1), axis=-1))


def _correlate(a: Array, b: Array) -> Array:
    a, b = (x - x.mean(axis=-1, keepdims=True) for x in (a, b))
    power = np.sum(a**2, axis=-1) * np.sum(b**2, axis=-1)
    return _divide(np.sum(a * b, axis=-1), np.sqrt(power))


def _divide(over: Array, under: Array) -> Array:
    """Quotient; NaN where the divisor is not positive."""
    return np.divide(over, under, out=np.full(np.shape(over), np.nan), where=under > 0)


def _compute_mean_square(values: Array) -> Array:
    return np.asarray(np.mean(values**2, axis=(-2, -1)))
