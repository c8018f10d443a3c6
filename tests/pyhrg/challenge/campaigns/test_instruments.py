"""Noise, quantum and digits of a log."""

from dataclasses import replace

import numpy as np
import pytest

from pyhrg.challenge.campaigns.gyro import TrueGyro
from pyhrg.challenge.campaigns.instruments import Instruments, record_log
from pyhrg.common.units import ARCSEC, DEG
from pyhrg.fmu import GyroFmu
from pyhrg.records import Log
from tests.pyhrg.challenge.short import GYRO, resting


@pytest.fixture(scope="module")
def exact(slow_fmu: GyroFmu) -> Log:
    course = replace(resting(4000.0), step=1.0)
    return TrueGyro(slow_fmu, GYRO).exact("", course, 0.3, np.zeros((1, 1)))


def test_channels_have_their_own_noise(exact: Log) -> None:
    own = Instruments()
    log = record_log(exact, GYRO, own, np.random.default_rng(1))
    for name in ("temperature", "amplitude", "frequency_offset", "quadrature_force"):
        noise = getattr(log, name) - getattr(exact, name)
        assert np.std(noise) == pytest.approx(getattr(own, name), rel=0.05)
    relative = log.amplitude_force / exact.amplitude_force - 1
    assert np.std(relative) == pytest.approx(own.amplitude_force, rel=0.05)
    angle = log.gyro_angle - exact.gyro_angle
    assert np.std(angle) == pytest.approx(GYRO.angle_white_noise, rel=0.05)


def test_output_is_a_multiple_of_its_quantum_to_the_digits(exact: Log) -> None:
    quantum = 0.3 * ARCSEC
    device = replace(GYRO, quantization_step=quantum)
    steps = record_log(exact, device, Instruments(), np.random.default_rng(1)).gyro_angle / quantum
    np.testing.assert_allclose(steps, np.round(steps), atol=0.5e-9 * DEG / quantum * 1.01)


def test_columns_have_the_recorded_digits(exact: Log) -> None:
    log = record_log(exact, GYRO, Instruments(), np.random.default_rng(1))
    wave = log.wave_angle / DEG * 1e4
    np.testing.assert_allclose(wave, np.round(wave), atol=1e-6)
    for force in log.quadrature_force[:50].tolist():
        assert float(f"{force:.6e}") == pytest.approx(force, rel=1e-12)


def test_another_benchs_instruments_are_within_a_factor(exact: Log) -> None:
    drawn = Instruments().draw_another(np.random.default_rng(1))
    ratio = drawn.amplitude / Instruments().amplitude
    assert 1 / 1.4 <= ratio <= 1.4
    assert ratio != 1
