"""Radial errors against distributions of scipy's and simulation."""

import numpy as np
import pytest
from scipy.stats import ncx2, rice

from ins_eval.common.radial_error import mean_radius, radius_at, share_within

SHARES = (0.05, 0.5, 0.95)


@pytest.mark.parametrize("distance", [1e-3, 0.3, 2.0, 10.0, 1e4])
@pytest.mark.parametrize("share", SHARES)
def test_round_pairs_are_noncentral_chi_square(distance: float, share: float) -> None:
    mean = 3 * distance * np.array([0.6, -0.8])
    radius = float(radius_at(share, mean, 9 * np.eye(2)))
    assert ncx2.cdf((radius / 3) ** 2, 2, distance**2) == pytest.approx(share, abs=1e-10)


@pytest.mark.parametrize("distance", [0.3, 2.0, 10.0])
def test_mean_of_round_pairs_is_rices(distance: float) -> None:
    found = mean_radius(np.array([0.0, distance]), np.eye(2))
    assert found == pytest.approx(rice.mean(distance), rel=1e-10)


@pytest.mark.parametrize("thin", [1.0, 0.3, 0.03, 1e-4, 0.0])
@pytest.mark.parametrize("mean", [(0.0, 0.0), (1.0, 2.0), (5.0, 0.3), (0.3, 5.0)])
def test_any_pair(thin: float, mean: tuple[float, float]) -> None:
    """Against 200 000 draws, seed 1, within four of their sigmas."""
    n = 200_000
    turn = np.array([[0.6, -0.8], [0.8, 0.6]])
    centre, covariance = turn @ np.array(mean), turn @ np.diag([1.0, thin**2]) @ turn.T
    draws = np.random.default_rng(1).normal(size=(n, 2)) * [1.0, thin] + mean
    radii = np.hypot(*draws.T)
    for share in SHARES:
        inside = np.mean(radii < radius_at(share, centre, covariance))
        assert abs(inside - share) < 4 * np.sqrt(share * (1 - share) / n)
    scatter = np.std(radii) / np.sqrt(n)
    assert abs(mean_radius(centre, covariance) - np.mean(radii)) < 4 * scatter


def test_arrays_are_taken_pair_by_pair() -> None:
    random = np.random.default_rng(2)
    mean, root = random.normal(size=(3, 4, 2)), random.normal(size=(3, 4, 2, 2))
    covariance = root @ np.swapaxes(root, -1, -2)
    whole = radius_at(0.7, mean, covariance)
    assert whole.shape == (3, 4)
    assert whole[2, 1] == pytest.approx(float(radius_at(0.7, mean[2, 1], covariance[2, 1])))
    np.testing.assert_allclose(share_within(whole, mean, covariance), 0.7, rtol=1e-9)


def test_a_sure_error_has_its_own_length() -> None:
    assert radius_at(0.05, np.array([3.0, 4.0]), np.zeros((2, 2))) == 5.0
    assert mean_radius(np.array([3.0, 4.0]), np.zeros((2, 2))) == 5.0


@pytest.mark.parametrize("share", [0.0, 1.0, -0.1, float("nan")])
def test_no_such_share(share: float) -> None:
    with pytest.raises(ValueError, match="expected more than 0 and less than 1"):
        radius_at(share, np.zeros(2), np.eye(2))
