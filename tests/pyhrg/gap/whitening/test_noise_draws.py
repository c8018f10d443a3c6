"""Draws of a noise against its variance in closed form."""

import numpy as np
import pytest

from pyhrg.gap.whitening.noise_draws import drawn
from pyhrg.gap.whitening.whitening import SlowNoise

N, INTERVAL, DRAWS = 400, 2.0, 2000
TIME = N * INTERVAL


def last(noise: SlowNoise) -> float:
    """Variance of the last reading."""
    generator = np.random.default_rng(5)
    return float(np.var([drawn(noise, N, INTERVAL, generator)[-1] for _ in range(DRAWS)]))


@pytest.mark.parametrize(
    ("noise", "variance"),
    [
        (SlowNoise(0.3), 0.09),
        (SlowNoise(0.0, walk=0.1), 0.01 * TIME),
        (SlowNoise(0.0, rate_walk=1e-3), 1e-6 * TIME**3 / 3),
        (
            SlowNoise(0.0, lagged=2.0, lag=600.0),
            4.0 / 600 / 2 * (1 - np.exp(-2 * TIME / 600)),
        ),
    ],
)
def test_the_last_reading_scatters_as_it_should(noise: SlowNoise, variance: float) -> None:
    # a variance of 2000 draws is known to 3.2 %
    assert last(noise) == pytest.approx(variance, rel=0.12)
