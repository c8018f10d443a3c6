"""Spectra of noises, and how far records of them part."""

from dataclasses import replace

import numpy as np
import pytest

from pyhrg.common.units import ARCSEC, DEG_PER_H, DEG_PER_SQRT_H, HOUR
from pyhrg.gap.evidence.noise.noise_levels import AngleRecord, log_likelihood
from pyhrg.gap.next_test.candidate_tests import SLOW
from pyhrg.gap.next_test.noise_divergence import divergence, spectrum
from pyhrg.gap.whitening.noise_draws import drawn
from pyhrg.gap.whitening.whitening import SlowNoise

BELIEVED = SlowNoise(0.036 * ARCSEC, 3e-4 * DEG_PER_SQRT_H)
WALKING = replace(BELIEVED, rate_walk=0.0008 * DEG_PER_H / HOUR**0.5)
FLICKERING = replace(BELIEVED, flicker=0.001 * DEG_PER_H)


@pytest.mark.parametrize("noise", [BELIEVED, WALKING, FLICKERING])
def test_spectrum_is_that_of_draws(noise: SlowNoise) -> None:
    """To four deviations of 60 periodograms; the slowest lags stay within a window's leakage."""
    n, draws = 2048, 60
    generator = np.random.default_rng(1)
    window = np.hanning(n)
    steps = [np.diff(drawn(noise, n + 1, SLOW, generator)) for _ in range(draws)]
    power = np.mean([np.abs(np.fft.rfft(s * window)) ** 2 for s in steps], axis=0)
    angular = 2 * np.pi * np.arange(1, n // 2 + 1) / n
    ratio = (power[1:] / (window**2).sum() / spectrum(noise, SLOW, angular))[4:-1]
    octaves = np.array_split(ratio, 16)
    for octave in octaves:
        assert octave.mean() == pytest.approx(1, abs=4 * np.sqrt(2 / (draws * len(octave))) + 0.02)


@pytest.mark.parametrize("interval", [SLOW, 1.0, 0.1])
@pytest.mark.parametrize("rival", [WALKING, replace(BELIEVED, walk=1.2 * BELIEVED.walk)])
def test_divergence_is_what_likelihoods_of_draws_differ_by(
    rival: SlowNoise, interval: float
) -> None:
    """In the mean over 200 records of 360 rows, to four of its deviations."""
    n = 360
    generator = np.random.default_rng(2)
    gained = []
    for _ in range(200):
        record = AngleRecord(drawn(BELIEVED, n, interval, generator), np.full(n, interval))
        own, other = (log_likelihood([record], noise) for noise in (BELIEVED, rival))
        gained.append(own - other)
    error = np.std(gained) / np.sqrt(len(gained))
    expected = divergence(BELIEVED, rival, n * interval, interval)
    assert np.mean(gained) == pytest.approx(expected, abs=4 * error + 0.5)
