"""Likelihood of many models at once: against the house's, and against dense covariances."""

import numpy as np

from pyhrg.gap.static_record.fit.likelihood import (
    compute_log_likelihoods,
    estimate_columns,
    transform_record,
    whiten_coefficients,
)
from pyhrg.noise.likelihood import compute_misfit, compute_spectrum
from tests.pyhrg.noises import noisy_angle

N = 600
TIME = np.linspace(-(N - 1) / 2, (N - 1) / 2, N)
STRENGTHS = np.array([[1.0, 0.1, 0.0, 0.0], [0.5, 0.2, 1e-3, 1e-6], [2.0, 0.0, 0.0, 1e-5]])


def test_free_columns_as_in_the_restricted_likelihood() -> None:
    """Line and parabola in any size: minus half the misfit, but for a constant."""
    angle = noisy_angle(N, (1, 0.3, 0, 0.001, 1e-4), np.random.default_rng(1))
    data = transform_record(angle, [TIME**2], {})
    found = compute_log_likelihoods(data, STRENGTHS, np.zeros((3, 0)))
    expected = [-0.5 * compute_misfit([compute_spectrum(angle)], s).value for s in STRENGTHS]
    np.testing.assert_allclose(np.diff(found), np.diff(expected), rtol=1e-9)


def test_random_columns_are_covariance() -> None:
    """White noise, a column of given variance: dense Gaussian density of what has no line."""
    generator = np.random.default_rng(2)
    angle = generator.standard_normal(N) + 2e-4 * TIME**2
    data = transform_record(angle, [], {"ramp": TIME**2})
    basis = np.linalg.svd(np.column_stack([np.ones(N), TIME]))[0][:, 2:]
    column = basis.T @ TIME**2
    column /= np.linalg.norm(column)
    expected = []
    for variance in (0.0, 4.0, 100.0):
        covariance = np.eye(N - 2) + variance * np.outer(column, column)
        rest = basis.T @ angle
        size = rest @ np.linalg.solve(covariance, rest)
        expected.append(-0.5 * (np.linalg.slogdet(covariance)[1] + size))
    strengths = np.tile([1.0, 0.0, 0.0, 0.0], (3, 1))
    found = compute_log_likelihoods(data, strengths, np.array([[0.0], [4.0], [100.0]]))
    np.testing.assert_allclose(np.diff(found), np.diff(expected), rtol=1e-8)


def test_a_ramp_is_estimated() -> None:
    angle = np.random.default_rng(3).standard_normal(N) + 0.5 * 1e-3 * TIME**2
    data = transform_record(angle, [], {"ramp": TIME**2 / 2})
    mean, covariance = estimate_columns(data, STRENGTHS[:1], np.array([[1e12]]))
    ramp, sigma = mean[0, 0] / data.lengths[0], np.sqrt(covariance[0, 0, 0]) / data.lengths[0]
    assert abs(ramp - 1e-3) < 3 * sigma < 3e-4


def test_the_right_model_whitens() -> None:
    angle = noisy_angle(20000, (1, 0.3, 0, 0, 0), np.random.default_rng(4))
    white = whiten_coefficients(
        transform_record(angle, [], {}), np.array([1.0, 0.09, 0.0, 0.0]), np.zeros(0)
    )
    assert abs(np.mean(white**2) - 1) < 3 * np.sqrt(2 / 20000)


def test_a_column_that_is_a_line_is_left_out() -> None:
    angle = np.random.default_rng(5).standard_normal(N)
    assert transform_record(angle, [], {"line": TIME + 3.0}).names == ()
