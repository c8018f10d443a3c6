"""Radial error of normal pairs against scipy's noncentral chi-square and against simulation."""

import numpy as np
import pytest
from scipy.stats import ncx2

from ins_eval.common.radial_error import radius_quantile

PROBABILITIES = (0.05, 0.5, 0.95)


@pytest.mark.parametrize("distance", [1e-3, 0.3, 2.0, 10.0, 1e4])
@pytest.mark.parametrize("probability", PROBABILITIES)
def test_round_pairs_are_noncentral_chi_square(distance: float, probability: float) -> None:
    mean = 3 * distance * np.array([0.6, -0.8])
    radius = float(radius_quantile(probability, mean, 9 * np.eye(2)))
    assert ncx2.cdf((radius / 3) ** 2, 2, distance**2) == pytest.approx(probability, abs=1e-10)


@pytest.mark.parametrize("thin", [1.0, 0.3, 0.03, 1e-4, 0.0])
@pytest.mark.parametrize("mean", [(0.0, 0.0), (1.0, 2.0), (5.0, 0.3), (0.3, 5.0)])
def test_quantiles_of_any_normal_pair(thin: float, mean: tuple[float, float]) -> None:
    """Against 200 000 draws, seed 1, within four of their sigmas."""
    n = 200_000
    turn = np.array([[0.6, -0.8], [0.8, 0.6]])
    centre, covariance = turn @ np.array(mean), turn @ np.diag([1.0, thin**2]) @ turn.T
    draws = np.random.default_rng(1).normal(size=(n, 2)) * [1.0, thin] + mean
    radii = np.hypot(*draws.T)
    for probability in PROBABILITIES:
        inside = np.mean(radii < radius_quantile(probability, centre, covariance))
        assert abs(inside - probability) < 4 * np.sqrt(probability * (1 - probability) / n)


def test_arrays_of_pairs_are_taken_element_by_element() -> None:
    random = np.random.default_rng(2)
    mean, root = random.normal(size=(3, 4, 2)), random.normal(size=(3, 4, 2, 2))
    covariance = root @ np.swapaxes(root, -1, -2)
    whole = radius_quantile(0.7, mean, covariance)
    assert whole.shape == (3, 4)
    for place in np.ndindex(3, 4):
        single = float(radius_quantile(0.7, mean[place], covariance[place]))
        assert whole[place] == pytest.approx(single, rel=1e-9)


def test_a_certain_error_has_its_own_length() -> None:
    assert radius_quantile(0.05, np.array([3.0, 4.0]), np.zeros((2, 2))) == 5.0


@pytest.mark.parametrize("probability", [0.0, 1.0, -0.1, float("nan")])
def test_a_probability_outside_0_and_1_is_refused(probability: float) -> None:
    with pytest.raises(ValueError, match="expected more than 0 and less than 1"):
        radius_quantile(probability, np.zeros(2), np.eye(2))
