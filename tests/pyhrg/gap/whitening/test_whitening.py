"""Innovations against a dense covariance by Cholesky, for every part of the noise."""

import numpy as np
import pytest
from scipy.linalg import cho_solve, cholesky, solve_triangular

from pyhrg.common.arrays import Array
from pyhrg.gap.whitening.whitening import (
    FLICKER_PROCESS_TIMES,
    CorrelatedNoise,
    NoiseModel,
    whiten,
)


def integrated_lag(t: Array, tau: float, power: float) -> Array:
    """Covariance of the integral from 0 of stationary noise behind a lag."""
    first, second = np.meshgrid(t, t)
    low, high = np.minimum(first, second), np.maximum(first, second)
    decayed = 1 - np.exp(-low / tau) - np.exp(-high / tau) + np.exp(-(high - low) / tau)
    return np.asarray(power * (2 * tau * low - tau**2 * decayed))


def covariance(t: Array, noise: NoiseModel) -> Array:
    low, high = np.minimum.outer(t, t), np.maximum.outer(t, t)
    read = 0.0 if noise.reading_noise is None else noise.reading_noise
    white, walk = (1.0 if g is None else g for g in (noise.white_growth, noise.walk_growth))
    total = np.diag((np.full(len(t), noise.angle_white_noise) * white) ** 2 + read**2)
    walked = noise.angle_random_walk**2 * np.cumsum(walk**2 * np.diff(t, prepend=0.0))
    total += np.minimum.outer(walked, walked)
    total += noise.rate_random_walk**2 * low**2 * (3 * high - low) / 6
    apart = np.exp(-(high - low) / noise.lag) - np.exp(-(high + low) / noise.lag)
    total += noise.lagged**2 / noise.lag / 2 * apart
    for term in noise.correlated:
        apart = np.exp(-(high - low) / term.lag) - np.exp(-(high + low) / term.lag)
        added = integrated_lag(t, term.lag, 1.0) if term.of_rate else apart
        total += term.level**2 * added
    power = noise.bias_instability**2 * 2 * np.log(10) / np.pi / 2
    return np.asarray(total + sum(integrated_lag(t, tau, power) for tau in FLICKER_PROCESS_TIMES))


EVEN = np.arange(1.0, 121.0)
UNEVEN = np.cumsum(np.random.default_rng(3).choice([0.1, 1.0, 1.0, 7.0, 60.0], 120))
NOISES = [
    NoiseModel(0.3),
    NoiseModel(0.3, angle_random_walk=0.2),
    NoiseModel(0.3, rate_random_walk=0.02),
    NoiseModel(0.3, bias_instability=0.1),
    NoiseModel(0.3, correlated=(CorrelatedNoise(0.1, 20.0, of_rate=True),)),
    NoiseModel(
        0.3,
        correlated=(
            CorrelatedNoise(0.5, 20.0, of_rate=False),
            CorrelatedNoise(0.2, 5.0, of_rate=False),
        ),
    ),
    NoiseModel(0.3, lagged=5.0, lag=40.0),
    NoiseModel(
        0.1,
        angle_random_walk=0.2,
        rate_random_walk=1e-3,
        bias_instability=0.03,
        lagged=2.0,
        lag=600.0,
    ),
]
TURNING = np.repeat([0.0, 0.5, 0.0, 2.0], 30)
"""Noise of readings, equal over many rows."""
NOISES += [NoiseModel(0.3, walk, reading_noise=TURNING) for walk in (0.0, 0.2)]
DECAYING = np.repeat([0.0, 1.0, 2.5], [30, 30, 60])
"""Growth of a noise as an amplitude decays; at first there is none."""
NOISES.append(NoiseModel(0.3, 0.2, 0.02, white_growth=1 + DECAYING, walk_growth=DECAYING))


@pytest.mark.parametrize("times", [EVEN, UNEVEN], ids=["even", "uneven"])
@pytest.mark.parametrize("noise", NOISES, ids=str)
def test_the_filter_agrees_with_the_dense_covariance(noise: NoiseModel, times: Array) -> None:
    series = np.random.default_rng(1).normal(size=(len(times), 2))
    white = whiten(series, np.diff(times, prepend=0.0), noise)
    dense = covariance(times, noise)
    factor = cholesky(dense, lower=True)
    assert white.log_determinant == pytest.approx(2 * np.log(np.diag(factor)).sum(), rel=1e-8)
    np.testing.assert_allclose(
        white.series, solve_triangular(factor, series, lower=True), rtol=1e-5, atol=1e-7
    )
    products = series.T @ cho_solve((factor, True), series)
    np.testing.assert_allclose(white.series.T @ white.series, products, rtol=1e-6)


@pytest.mark.parametrize("noise", NOISES, ids=str)
def test_unmodelled_terms_add_to_the_covariance(noise: NoiseModel) -> None:
    generator = np.random.default_rng(2)
    series, shapes = generator.normal(size=(2, len(UNEVEN), 2))
    shapes = np.column_stack([shapes, np.zeros(len(UNEVEN))])
    white = whiten(series, np.diff(UNEVEN, prepend=0.0), noise, shapes)
    factor = cholesky(covariance(UNEVEN, noise) + shapes @ shapes.T, lower=True)
    assert white.log_determinant == pytest.approx(2 * np.log(np.diag(factor)).sum(), rel=1e-8)
    products = series.T @ cho_solve((factor, True), series)
    np.testing.assert_allclose(white.series.T @ white.series, products, rtol=1e-6)


def test_an_unmodelled_term_of_zero_changes_nothing() -> None:
    series, steps = np.random.default_rng(1).normal(size=(120, 2)), np.diff(EVEN, prepend=0.0)
    plain = whiten(series, steps, NOISES[1])
    white = whiten(series, steps, NOISES[1], np.zeros(120))
    np.testing.assert_array_equal(white.series, plain.series)
    assert white.log_determinant == plain.log_determinant


def test_the_sum_of_lags_is_flicker() -> None:
    """Its Allan deviation is 0.664 B from 10 s to an hour, to 6 %."""
    noise = NoiseModel(1.0, bias_instability=0.1)
    ratios = []
    for tau in (10.0, 60.0, 600.0, 3600.0):
        power = noise.bias_instability**2 * 2 * np.log(10) / np.pi / 2
        t = np.array([tau, 2 * tau])
        angle = sum(integrated_lag(t, lag, power) for lag in FLICKER_PROCESS_TIMES)
        weights = np.array([-2.0, 1.0])
        ratios.append(
            np.sqrt(weights @ angle @ weights / 2) / tau / (0.664 * noise.bias_instability)
        )
    np.testing.assert_allclose(ratios, 1, atol=0.06)
