"""Noise mechanisms against their closed forms; numbers as in `test_mechanisms`."""

import math

import numpy as np
import pytest

from pyhrg.common.units import DEG
from pyhrg.fmu import GyroFmu
from tests.driving import advance, drive


def test_18_rotation_noise_is_a_random_walk(fmu: GyroFmu) -> None:
    """400 means of 0.5 s, N = V s, within 3.5 sigma."""
    rate, noise = 10 * DEG, 1e-4
    with fmu.power_on({"noise.virtualRotation": noise}, seed=4, start_angle=0.1) as gyro:
        gyro.command("virtualRotation", rate)
        advance(gyro, 0.0, 5.0)
        means = np.diff(drive(gyro, np.zeros(401), 0.5)) / 0.5
    expected = rate * noise / math.sqrt(0.5)
    assert np.std(means, ddof=1) == pytest.approx(expected, rel=3.5 / math.sqrt(800))


def test_20_random_walk_grows_as_the_amplitude_falls(fmu: GyroFmu) -> None:
    """N ~ 1/a: 400 means of 1 s at half amplitude."""
    parameters = {"noise.angleRandomWalk": 1e-6, "startAmplitude": 0.5}
    with fmu.power_on(parameters, seed=5, start_angle=0.1) as gyro:
        gyro.command("amplitudeSetpoint", 0.5)
        advance(gyro, 0.0, 5.0)
        means = np.diff(drive(gyro, np.zeros(401), 1.0))
    assert np.std(means, ddof=1) == pytest.approx(2e-6, rel=3.5 / math.sqrt(800))


def test_22_rate_random_walk(fmu: GyroFmu) -> None:
    """Means of 1 s walk by K each second: 300 differences, within 3.5 sigma; the mean of a second
    smooths the walk within it, variance 2/3."""
    with fmu.power_on({"noise.rateRandomWalk": 1e-6}, seed=6, start_angle=0.1) as gyro:
        advance(gyro, 0.0, 5.0)
        means = np.diff(drive(gyro, np.zeros(302), 1.0))
    steps = np.diff(means)
    expected = 1e-6 * math.sqrt(2 / 3)
    assert np.std(steps, ddof=1) == pytest.approx(expected, rel=3.5 / math.sqrt(600) * 1.3)


def test_22_flicker_has_a_flat_allan_deviation(fmu: GyroFmu) -> None:
    """0.664 B at 0.3 to 10 s, within 25 % (2000 s of record)."""
    b = 1e-6
    with fmu.power_on({"noise.biasInstability": b}, seed=7, start_angle=0.1) as gyro:
        advance(gyro, 0.0, 20.0)
        rates = np.diff(drive(gyro, np.zeros(20_001), 0.1)) / 0.1
    for m in (3, 10, 30, 100):
        means = rates[: len(rates) // m * m].reshape(-1, m).mean(axis=1)
        deviation = math.sqrt(0.5 * np.mean(np.diff(means) ** 2))
        assert deviation == pytest.approx(0.664 * b, rel=0.25)
