"""Ensembles against covariance, and against the navigator's own spread."""

import numpy as np
import pytest
from scipy.stats import chi2

from ins_eval.common.sensor_errors import SensorErrors
from ins_eval.error_model.dynamics import COUNT
from ins_eval.error_model.effects import (
    BIASES,
    accelerometer_bias,
    gyro_bias,
)
from ins_eval.error_model.linear_model import linearize, propagate_covariance
from ins_eval.error_model.motion import sample_motion
from ins_eval.navigation.height import Clamped, Free
from tests.ins_eval.error_model.cases import Flight, weave
from tests.ins_eval.error_model.ensemble import draw_ensemble

NOISE = SensorErrors(angle_random_walk=3e-6, velocity_random_walk=3e-4)
INITIAL = np.diag([25.0, 25, 25, 1e-4, 1e-4, 1e-4, 1e-9, 1e-9, 1e-8, 0])


def within(spread: np.ndarray, covariance: np.ndarray) -> np.ndarray:
    """Whether variances of draws (members, k) of mean 0 lie in chi-square's 99.99 % interval."""
    members = len(spread)
    ratio = np.sum(spread**2, axis=0) / np.diagonal(covariance)
    return (chi2.ppf(5e-5, members) < ratio) & (ratio < chi2.ppf(1 - 5e-5, members))


@pytest.mark.parametrize("height", [Free(), Clamped(np.zeros(1))], ids=["free", "clamped"])
def test_spread_is_the_covariance(height: Free | Clamped) -> None:
    """n = 2000, seed 7, every variance in its 99.99 % interval, wandering biases included."""
    effects = (*BIASES, gyro_bias(300.0), accelerometer_bias(600.0))
    model = linearize(sample_motion(weave(45, 600), 0.0, 2.0, 300), height, effects, NOISE)
    sigmas = np.array([np.full(3, 2e-7), np.full(3, 1e-3), np.full(3, 5e-7), np.full(3, 1e-3)])
    result = draw_ensemble(model, INITIAL, sigmas, 2000, np.random.default_rng(7), keep_every=150)
    expected = propagate_covariance(model, INITIAL, sigmas)[::150]
    states = [0, 1, 3, 4, 6, 7, 8] + ([2, 5] if isinstance(height, Free) else [])
    for draws, covariance in zip(result, expected, strict=True):
        own = covariance[np.ix_(states, states)]
        assert np.all(within(draws[:, states], own))
        whole = np.einsum("ni,ij,nj->", draws[:, states], np.linalg.inv(own), draws[:, states])
        count = 2000 * len(states)
        assert chi2.ppf(5e-5, count) < whole < chi2.ppf(1 - 5e-5, count)


def test_without_wandering_it_would_not_be() -> None:
    """The control: biases taken as constant instead of wandering give another spread."""
    motion = sample_motion(weave(45, 600), 0.0, 2.0, 300)
    sigmas = np.full((1, 3), 2e-6)
    wandering, constant = (
        linearize(motion, Clamped(np.zeros(1)), (effect,), NOISE)
        for effect in (gyro_bias(60.0), gyro_bias())
    )
    result = draw_ensemble(wandering, INITIAL, sigmas, 2000, np.random.default_rng(7), 300)[-1]
    expected = propagate_covariance(constant, INITIAL, sigmas)[-1]
    assert not np.any(within(result[:, 6:8], expected[6:8, 6:8]))


def test_spread_is_the_navigators() -> None:
    """The navigator itself flown 60 times with drawn errors, 20 min, seed 11; chi-square of the
    horizontal position and heading in its 99.99 % interval, n = 60."""
    flight = Flight.of(weave(45, 1200), 1200, 0.1)
    height = Clamped(flight.heights)
    sigmas = np.array([np.full(3, 2e-7), np.full(3, 1e-3)])
    model = linearize(sample_motion(flight.trajectory, 0.0, 1.0, 1200), height, noise=NOISE)
    expected = propagate_covariance(model, INITIAL * _clamped(), sigmas)[-1]
    generator = np.random.default_rng(11)
    ends = []
    for _ in range(60):
        start = generator.standard_normal(9) * np.sqrt(np.diagonal(INITIAL * _clamped()))[:9]
        walks = np.repeat([NOISE.angle_random_walk, NOISE.velocity_random_walk], 3)
        noise = generator.standard_normal((12_000, 6)) * walks / np.sqrt(0.1)
        sensors = noise + generator.standard_normal(6) * sigmas.ravel()
        ends.append(flight.errors(height, start, sensors)[-1, [0, 1, 8]])
    own = expected[np.ix_([0, 1, 8], [0, 1, 8])]
    whole = np.einsum("ni,ij,nj->", ends, np.linalg.inv(own), ends)
    assert np.all(within(np.array(ends), own))
    assert chi2.ppf(5e-5, 180) < whole < chi2.ppf(1 - 5e-5, 180)


def _clamped() -> np.ndarray:
    """Leaves out errors of height, which the navigator's reference does not have here."""
    keep = np.ones(COUNT)
    keep[[2, 5]] = 0.0
    return keep
