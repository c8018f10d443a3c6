"""Variance of drawn noise against its closed form."""

import numpy as np
import pytest

from pyhrg.gap.whitening.whitening import NoiseModel, draw_noise

N, INTERVAL, DRAWS = 400, 2.0, 2000
TIME = N * INTERVAL


def estimate_last_variance(noise: NoiseModel) -> float:
    """Variance of the last reading over many draws."""
    generator = np.random.default_rng(5)
    return float(np.var([draw_noise(noise, N, INTERVAL, generator)[-1] for _ in range(DRAWS)]))


@pytest.mark.parametrize(
    ("noise", "variance"),
    [
        (NoiseModel(0.3), 0.09),
        (NoiseModel(0.0, angle_random_walk=0.1), 0.01 * TIME),
        (NoiseModel(0.0, rate_random_walk=1e-3), 1e-6 * TIME**3 / 3),
        (
            NoiseModel(0.0, lagged=2.0, lag=600.0),
            4.0 / 600 / 2 * (1 - np.exp(-2 * TIME / 600)),
        ),
        (NoiseModel(0.3, reading_noise=np.linspace(0.0, 0.4, N)), 0.25),
    ],
)
def test_the_variance_of_the_last_reading(noise: NoiseModel, variance: float) -> None:
    # the standard error of a variance from 2000 draws is 3.2 %
    assert estimate_last_variance(noise) == pytest.approx(variance, rel=0.12)
