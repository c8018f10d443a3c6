"""Spectra of noises, and divergence of noises, against draws."""

from dataclasses import replace

import numpy as np
import pytest

from pyhrg.common.units import ARCSEC, DEG_PER_H, DEG_PER_SQRT_H, HOUR
from pyhrg.gap.evidence.noise.noise_levels import compute_log_likelihood
from pyhrg.gap.evidence.residuals import Residual
from pyhrg.gap.next_test.candidate_tests import LONG_ROWS
from pyhrg.gap.next_test.noise_divergence import compute_divergence, compute_increment_spectrum
from pyhrg.gap.whitening.whitening import NoiseModel, draw_noise

BELIEVED = NoiseModel(0.036 * ARCSEC, 3e-4 * DEG_PER_SQRT_H)
WALKING = replace(BELIEVED, rate_random_walk=0.0008 * DEG_PER_H / HOUR**0.5)
FLICKERING = replace(BELIEVED, bias_instability=0.001 * DEG_PER_H)


@pytest.mark.parametrize("noise", [BELIEVED, WALKING, FLICKERING])
def test_spectrum_is_that_of_draws(noise: NoiseModel) -> None:
    """Within four standard errors of 60 periodograms; the slowest lags within leakage."""
    n, draws = 2048, 60
    generator = np.random.default_rng(1)
    window = np.hanning(n)
    steps = [np.diff(draw_noise(noise, n + 1, LONG_ROWS, generator)) for _ in range(draws)]
    power = np.mean([np.abs(np.fft.rfft(s * window)) ** 2 for s in steps], axis=0)
    angular = 2 * np.pi * np.arange(1, n // 2 + 1) / n
    ratio = (power[1:] / (window**2).sum() / compute_increment_spectrum(noise, LONG_ROWS, angular))[
        4:-1
    ]
    octaves = np.array_split(ratio, 16)
    for octave in octaves:
        assert octave.mean() == pytest.approx(1, abs=4 * np.sqrt(2 / (draws * len(octave))) + 0.02)


@pytest.mark.parametrize("interval", [LONG_ROWS, 1.0, 0.1])
@pytest.mark.parametrize(
    "rival", [WALKING, replace(BELIEVED, angle_random_walk=1.2 * BELIEVED.angle_random_walk)]
)
def test_divergence_is_the_mean_log_likelihood_ratio_of_draws(
    rival: NoiseModel, interval: float
) -> None:
    """Mean over 200 records of 360 rows, within four standard errors."""
    n = 360
    generator = np.random.default_rng(2)
    gained = []
    for _ in range(200):
        record = Residual(
            "",
            "gyro_angle",
            draw_noise(BELIEVED, n, interval, generator),
            np.full(n, interval),
            interval,
            BELIEVED,
        )
        own, other = (compute_log_likelihood([record], noise) for noise in (BELIEVED, rival))
        gained.append(own - other)
    error = np.std(gained) / np.sqrt(len(gained))
    expected = compute_divergence(BELIEVED, rival, n * interval, interval)
    assert np.mean(gained) == pytest.approx(expected, abs=4 * error + 0.5)
