"""Bias instability of the filter and of the closed forms against the flicker that is simulated."""

import numpy as np
import pytest

from ins_eval.alignment.bias_instability import correlation_times, mean_variance
from pyhrg.common.arrays import Array
from pyhrg.noise.coefficients import compute_process_variance, half_integral_response

DURATION, INTERVAL = 300.0, 0.25
COUNT = round(DURATION / INTERVAL)
TIMES = INTERVAL * np.arange(1.0, COUNT + 1)
COEFFICIENT = 2.0


def simulated_covariance() -> Array:
    """(1200, 1200) covariance of the simulated flicker's integral at TIMES; exact, as the
    simulation is linear in white noise."""
    response = half_integral_response(COUNT)
    lag = np.subtract.outer(np.arange(COUNT), np.arange(COUNT))
    integral = INTERVAL * np.cumsum(np.where(lag >= 0, response[np.abs(lag)], 0.0), axis=0)
    return np.asarray(COEFFICIENT**2 * integral @ integral.T)


def modelled_covariance() -> Array:
    """(1200, 1200) covariance of the integral of the filter's Gauss-Markov processes at TIMES."""
    a, b = np.meshgrid(TIMES, TIMES)
    total = np.zeros_like(a)
    for t in correlation_times(DURATION):
        tails = 1 - np.exp(-a / t) - np.exp(-b / t) + np.exp(-np.abs(a - b) / t)
        total += t**2 * (2 * np.minimum(a, b) / t - tails)
    return compute_process_variance(COEFFICIENT) * total


def slope_weights() -> Array:
    """Weights of the integral at TIMES in its least-squares slope."""
    centred = TIMES - TIMES.mean()
    return np.asarray(centred / (centred @ centred))


def allan_variance(covariance: Array, cluster: float) -> float:
    """Mean over the record."""
    n = round(cluster / INTERVAL)
    ends = np.pad(covariance, ((1, 0), (1, 0)))[::n, ::n]
    seconds = np.diff(np.diff(ends, n=2, axis=0), n=2, axis=1)
    return float(np.mean(np.diag(seconds)) / (2 * cluster**2))


def test_the_mean_over_the_record() -> None:
    expected = mean_variance(COEFFICIENT)
    assert simulated_covariance()[-1, -1] / DURATION**2 == pytest.approx(expected, rel=0.005)
    assert modelled_covariance()[-1, -1] / DURATION**2 == pytest.approx(expected, rel=0.1)


def test_the_slope_of_the_integral() -> None:
    """The slope that the inertial-frame method takes for a tilt rate."""
    weights = slope_weights()
    expected = weights @ simulated_covariance() @ weights
    assert weights @ modelled_covariance() @ weights == pytest.approx(expected, rel=0.1)


def test_the_slope_of_the_bias() -> None:
    """The slope of accelerometer bias that fine alignment takes for a tilt rate."""
    mean_rate = np.diff(np.eye(COUNT), axis=0, prepend=0.0) / INTERVAL
    weights = slope_weights() @ mean_rate
    expected = weights @ simulated_covariance() @ weights
    assert weights @ modelled_covariance() @ weights == pytest.approx(expected, rel=0.15)


@pytest.mark.parametrize("cluster", [10.0, 30.0, 100.0])
def test_the_allan_variance(cluster: float) -> None:
    """At shorter times than the fastest process the model has less."""
    expected = allan_variance(simulated_covariance(), cluster)
    assert allan_variance(modelled_covariance(), cluster) == pytest.approx(expected, rel=0.15)
