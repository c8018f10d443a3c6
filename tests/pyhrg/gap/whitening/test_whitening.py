"""Innovations against a dense covariance by Cholesky, for every part of the noise."""

import numpy as np
import pytest
from numpy.typing import NDArray
from scipy.linalg import cho_solve, cholesky, solve_triangular

from pyhrg.gap.whitening.whitening import DECADES, Correlated, SlowNoise, whitened

Array = NDArray[np.float64]


def integrated_lag(t: Array, tau: float, power: float) -> Array:
    """Covariance of the integral, from 0, of a stationary lag."""
    one, other = np.meshgrid(t, t)
    low, high = np.minimum(one, other), np.maximum(one, other)
    decayed = 1 - np.exp(-low / tau) - np.exp(-high / tau) + np.exp(-(high - low) / tau)
    return np.asarray(power * (2 * tau * low - tau**2 * decayed))


def covariance(t: Array, noise: SlowNoise) -> Array:
    low, high = np.minimum.outer(t, t), np.maximum.outer(t, t)
    total = noise.white**2 * np.eye(len(t)) + noise.walk**2 * low
    total += noise.rate_walk**2 * low**2 * (3 * high - low) / 6
    apart = np.exp(-(high - low) / noise.lag) - np.exp(-(high + low) / noise.lag)
    total += noise.lagged**2 / noise.lag / 2 * apart
    if one := noise.correlated:
        apart = np.exp(-(high - low) / one.lag) - np.exp(-(high + low) / one.lag)
        lasting = integrated_lag(t, one.lag, 1.0) if one.of_rate else apart
        total += one.level**2 * lasting
    power = noise.flicker**2 * 2 * np.log(10) / np.pi / 2
    return np.asarray(total + sum(integrated_lag(t, tau, power) for tau in DECADES))


EVEN = np.arange(1.0, 121.0)
UNEVEN = np.cumsum(np.random.default_rng(3).choice([0.1, 1.0, 1.0, 7.0, 60.0], 120))
NOISES = [
    SlowNoise(0.3),
    SlowNoise(0.3, walk=0.2),
    SlowNoise(0.3, rate_walk=0.02),
    SlowNoise(0.3, flicker=0.1),
    SlowNoise(0.3, correlated=Correlated(0.1, 20.0, of_rate=True)),
    SlowNoise(0.3, correlated=Correlated(0.5, 20.0, of_rate=False)),
    SlowNoise(0.3, lagged=5.0, lag=40.0),
    SlowNoise(0.1, walk=0.2, rate_walk=1e-3, flicker=0.03, lagged=2.0, lag=600.0),
]


@pytest.mark.parametrize("times", [EVEN, UNEVEN], ids=["even", "uneven"])
@pytest.mark.parametrize("noise", NOISES, ids=str)
def test_the_likelihood_is_that_of_the_covariance(noise: SlowNoise, times: Array) -> None:
    series = np.random.default_rng(1).normal(size=(len(times), 2))
    found = whitened(series, np.diff(times, prepend=0.0), noise)
    dense = covariance(times, noise)
    factor = cholesky(dense, lower=True)
    assert found.log_determinant == pytest.approx(2 * np.log(np.diag(factor)).sum(), rel=1e-8)
    np.testing.assert_allclose(
        found.series, solve_triangular(factor, series, lower=True), rtol=1e-5, atol=1e-7
    )
    products = series.T @ cho_solve((factor, True), series)
    np.testing.assert_allclose(found.series.T @ found.series, products, rtol=1e-6)


@pytest.mark.parametrize("noise", NOISES, ids=str)
def test_what_is_left_out_is_as_a_part_of_the_covariance(noise: SlowNoise) -> None:
    generator = np.random.default_rng(2)
    series, shape = generator.normal(size=(len(UNEVEN), 2)), generator.normal(size=len(UNEVEN))
    found = whitened(series, np.diff(UNEVEN, prepend=0.0), noise, shape)
    factor = cholesky(covariance(UNEVEN, noise) + np.outer(shape, shape), lower=True)
    assert found.log_determinant == pytest.approx(2 * np.log(np.diag(factor)).sum(), rel=1e-8)
    products = series.T @ cho_solve((factor, True), series)
    np.testing.assert_allclose(found.series.T @ found.series, products, rtol=1e-6)


def test_nothing_left_out_changes_nothing() -> None:
    series, steps = np.random.default_rng(1).normal(size=(120, 2)), np.diff(EVEN, prepend=0.0)
    plain = whitened(series, steps, NOISES[1])
    found = whitened(series, steps, NOISES[1], np.zeros(120))
    np.testing.assert_array_equal(found.series, plain.series)
    assert found.log_determinant == plain.log_determinant


def test_the_sum_of_lags_is_flicker() -> None:
    """Allan deviation of the rate: 0.664 B on the floor, from 10 s to an hour, to 6 %."""
    noise = SlowNoise(1.0, flicker=0.1)
    ratios = []
    for tau in (10.0, 60.0, 600.0, 3600.0):
        power = noise.flicker**2 * 2 * np.log(10) / np.pi / 2
        t = np.array([tau, 2 * tau])
        angle = sum(integrated_lag(t, lag, power) for lag in DECADES)
        weights = np.array([-2.0, 1.0])
        ratios.append(np.sqrt(weights @ angle @ weights / 2) / tau / (0.664 * noise.flicker))
    np.testing.assert_allclose(ratios, 1, atol=0.06)
