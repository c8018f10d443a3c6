"""The IMU: errors as stated, gyros calibrated."""

from dataclasses import replace

import numpy as np
import pytest

from ins_eval.imu.gyros import Accelerometers, measured_rotation
from ins_eval.increments import Increments
from pyhrg import theory
from pyhrg.fmu import GyroFmu
from pyhrg.parameters import TYPICAL
from pyhrg.units import DEG_PER_H


def test_accelerometers_have_the_stated_bias_and_noise() -> None:
    """2000 triads of ten intervals: deviations within 3.5 sigma."""
    truth = Increments(0.01, np.zeros((10, 3)), np.ones((10, 3)))
    triad = Accelerometers(bias=2e-3, noise=1e-4)
    generator = np.random.default_rng(1)
    errors = np.array([triad.measure(truth, generator) - 1 for _ in range(2000)])
    bias = errors.mean(axis=1).std() / 0.01
    assert bias == pytest.approx(np.hypot(2e-3, 1e-4 / np.sqrt(0.1)), rel=3.5 / np.sqrt(12_000))
    noise = np.diff(errors, axis=1).std() / np.sqrt(2) / np.sqrt(0.01)
    assert noise == pytest.approx(1e-4, rel=0.03)


def test_mean_bias_is_calibrated(fmu: GyroFmu) -> None:
    """What is left at rest is the map without its mean, which is 0.3 deg/h here."""
    device = replace(
        TYPICAL, pickoff_nonorthogonality=7e-4, angle_random_walk=0.0, pickoff_noise=0.0
    )
    device = replace(device, power_on_scatter=0.0)
    assert theory.mean_bias(device) < -0.25 * DEG_PER_H
    rotation = measured_rotation(fmu, device, np.zeros(12_000), 0.01, np.random.default_rng(1))
    left = rotation[2000:].sum() / 100.0
    expected = theory.static_bias(device, device.power_on_angle) - theory.mean_bias(device)
    assert left == pytest.approx(float(expected), abs=0.005 * DEG_PER_H)
