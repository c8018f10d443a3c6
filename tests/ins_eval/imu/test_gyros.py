"""Gyros as FMUs: calibrated, fed with rate and specific force of their own axes."""

from dataclasses import replace

import numpy as np
import pytest

from ins_eval.imu.gyros import (
    FmuGyros,
    calibrate_mean_bias,
    case_axes,
    simulate_gyro,
    with_start_up,
)
from ins_eval.imu.mounting import ORTHOGONAL, make_mounting
from pyhrg.bench.bench import Bench
from pyhrg.common.errors import HrgError
from pyhrg.common.units import DEG_PER_H, STANDARD_GRAVITY
from pyhrg.device.device import Device
from pyhrg.device.ready_devices import TYPICAL
from pyhrg.fmu import GyroFmu
from pyhrg.records.imu.log import Increments
from pyhrg.theory import closed_forms as theory

QUIET = replace(TYPICAL, angle_random_walk=0.0, angle_white_noise=0.0, power_on_scatter=0.0)


def still(seconds: float) -> Increments:
    count = round(100 * seconds)
    force = np.tile([0.0, 0.0, -0.01 * STANDARD_GRAVITY], (count, 1))
    return Increments(0.01, np.zeros((count, 3)), force)


def test_mean_bias_is_calibrated(fmu: GyroFmu) -> None:
    """The bias at rest is that of the map without its mean, which is 0.3 deg/h here."""
    device = replace(QUIET, pickoff_nonorthogonality=7e-4)
    assert theory.mean_bias(device) < -0.25 * DEG_PER_H
    bench = Bench(fmu, device, seed=1)
    flight = simulate_gyro(bench, np.zeros(12_000), np.zeros((12_000, 3)), 0.01)
    residual = flight.rotation[2000:].sum() / 100.0 - calibrate_mean_bias(bench)
    expected = theory.static_bias(device, device.power_on_angle) - theory.mean_bias(device)
    assert residual == pytest.approx(float(expected), abs=0.005 * DEG_PER_H)


def test_a_swept_pattern_is_not_calibrated_at_rest() -> None:
    gyros = FmuGyros(replace(QUIET, sweep_angle=1.0))
    assert gyros.is_swept
    with pytest.raises(
        HrgError, match=r"sweep_angle_deg.*expected calibrated = false in \[gyros\]"
    ):
        gyros.measure(still(1), ORTHOGONAL, np.random.default_rng(1))


def test_gyro_is_ready_when_its_amplitude_has_grown(fmu: GyroFmu) -> None:
    """The second stage ends at 10 s (paper 2.3); valid it is from the first on."""
    bench = Bench(fmu, with_start_up(TYPICAL), seed=1)
    flight = simulate_gyro(bench, np.zeros(2000), np.zeros((2000, 3)), 0.01)
    assert 0 < np.flatnonzero(~flight.valid)[-1] < 100
    assert 1000 < np.flatnonzero(~flight.ready)[-1] < 1200


def test_specific_force_along_the_input_axis_reaches_the_gyro(fmu: GyroFmu) -> None:
    """1 deg/h per g, two gyros level and one upright; the others have no such bias."""
    device = Device(bias_per_acceleration=DEG_PER_H / STANDARD_GRAVITY)
    gyros = FmuGyros(device, own_axes=False, calibrated=False, fmu=fmu)
    rotation = gyros.measure(still(60), ORTHOGONAL, np.random.default_rng(1)).rotation
    rate = rotation[3000:].sum(axis=0) / 30
    np.testing.assert_allclose(rate / DEG_PER_H, [0, 0, -1], rtol=0, atol=0.01)


def test_skewed_gyros_are_driven_about_their_axes(fmu: GyroFmu) -> None:
    """Ideal gyros decode to the true rotation, and their patterns turn by -k of what they felt."""
    mounting = make_mounting([[1, 0, 1], [-1, 2, 1], [-1, -2, 1]])
    truth = still(20)
    truth = replace(truth, rotation=np.tile([1e-4, 2e-4, -1e-4], (len(truth), 1)))
    gyros = FmuGyros(Device(), own_axes=False, calibrated=False, fmu=fmu)
    reading = gyros.measure(truth, mounting, np.random.default_rng(1))
    decoded = mounting.decode(reading.rotation).sum(axis=0)
    np.testing.assert_allclose(decoded, truth.rotation.sum(axis=0), rtol=2e-4)
    assert reading.pattern_angle is not None
    felt = mounting.project(truth.rotation)[1000:].sum(axis=0)
    turned = reading.pattern_angle[-1] - reading.pattern_angle[999]
    np.testing.assert_allclose(turned, -0.277 * felt, rtol=1e-4)


def test_case_axes_are_right_handed_about_the_input_axis() -> None:
    for axis in np.random.default_rng(1).normal(size=(20, 3)):
        axes = case_axes(axis / np.linalg.norm(axis))
        np.testing.assert_allclose(axes @ axes.T, np.eye(3), atol=1e-14)
        assert np.linalg.det(axes) == pytest.approx(1)


def test_an_interval_between_control_periods_is_refused(fmu: GyroFmu) -> None:
    truth = replace(still(1), interval=0.0025)
    with pytest.raises(HrgError, match=r"increments over 0\.0025 s; expected .* 0\.001 s"):
        FmuGyros(fmu=fmu).measure(truth, ORTHOGONAL, np.random.default_rng(1))


def test_the_bias_to_believe_is_that_of_the_map() -> None:
    """The root mean square of 2000 gyros of the kind at their power-on angles, 3.5 sigma."""
    generator = np.random.default_rng(1)
    gyros = FmuGyros()
    biases = [
        float(theory.static_bias(device, device.power_on_angle) - theory.mean_bias(device))
        for _ in range(667)
        for device in gyros.devices(generator)
    ]
    squares = np.square(biases)
    spread = 3.5 * squares.std() / np.sqrt(len(squares))
    assert gyros.errors.gyro_bias**2 == pytest.approx(squares.mean(), abs=spread)
