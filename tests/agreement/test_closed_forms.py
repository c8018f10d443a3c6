"""The FMU against closed forms: drift against pattern angle, hold error, noise."""

import math

import numpy as np
import pytest

from pyhrg.common.units import DEG, DEG_PER_H, DEG_PER_SQRT_H
from pyhrg.device.ready_devices import TYPICAL, Device
from pyhrg.fmu import GyroFmu
from pyhrg.theory import closed_forms as theory
from tests.driving import advance, drive

ANGLES = np.arange(0.0, 90.0, 11.25) * DEG


def drift(fmu: GyroFmu, device: Device, angle: float) -> float:
    """Output rate at rest, rad/s."""
    with fmu.power_on(device.fmu_parameters(), seed=0, start_angle=angle) as gyro:
        settled = advance(gyro, 0.0, 20.0)
        return (advance(gyro, 0.0, 100.0) - settled) / 100.0


SINGLE_EFFECTS = {
    "damping anisotropy": Device(damping_anisotropy=1e-6, damping_axis=20 * DEG),
    "pick-off gain": Device(pickoff_gain_mismatch=1e-4),
    "drive gain": Device(drive_gain_mismatch=1e-4),
    "pick-off non-orthogonality": Device(pickoff_nonorthogonality=1e-4),
    "drive non-orthogonality": Device(drive_nonorthogonality=1e-4),
    "anisotropy of parametric drive": Device(
        parametric_share=0.7, pump_anisotropy=1e-4, pump_axis=20 * DEG, pickoff_gain_mismatch=1e-4
    ),
    "frequency split and phase error": Device(
        frequency_split=2 * math.pi * 1e-3, stiffness_axis=50 * DEG, phase_error=1e-3
    ),
}


@pytest.mark.parametrize("device", SINGLE_EFFECTS.values(), ids=SINGLE_EFFECTS.keys())
def test_drift_against_pattern_angle(fmu: GyroFmu, device: Device) -> None:
    """Within 1 % of the map's amplitude, at every angle."""
    measured = np.array([drift(fmu, device, angle) for angle in ANGLES])
    amplitude = abs(theory.static_bias_phasor(device))
    assert np.max(np.abs(measured - theory.static_bias(device, ANGLES))) < 0.01 * amplitude
    assert np.ptp(measured) > 1.5 * amplitude


def test_damping_drift_is_the_papers_term_corrected(fmu: GyroFmu) -> None:
    """-(D/4k) sin 4(th - th_tau): the paper's Eq. (1) with its coefficient and sign mended."""
    device = SINGLE_EFFECTS["damping anisotropy"]
    for angle in ANGLES:
        expected = -device.damping_anisotropy / (4 * 0.277) * math.sin(4 * (angle - 20 * DEG))
        assert drift(fmu, device, angle) == pytest.approx(expected, rel=0.01, abs=1e-12)


def test_all_effects_together(fmu: GyroFmu) -> None:
    device = TYPICAL.without_noise()
    measured = np.array([drift(fmu, device, angle) for angle in ANGLES])
    error = np.abs(measured - theory.static_bias(device, ANGLES))
    assert np.max(error) < 0.01 * abs(theory.static_bias_phasor(device))


def test_frequency_split_alone_gives_no_bias(fmu: GyroFmu) -> None:
    device = Device(frequency_split=2 * math.pi * 1e-3)
    assert all(abs(drift(fmu, device, angle)) < 1e-4 * DEG_PER_H for angle in ANGLES)


@pytest.mark.parametrize("rate", [0.01, -0.01, 0.5, -5.0])
def test_ideal_gyro_returns_the_input_angle(fmu: GyroFmu, rate: float) -> None:
    """To 1e-7 after the closed form of its own hold, -(Ts/2)/tau."""
    device = Device()
    with fmu.power_on(device.fmu_parameters(), seed=0, start_angle=0.1) as gyro:
        angle = advance(gyro, rate, 100.0)
    error = angle / (100.0 * rate) - 1
    hold = theory.hold_scale_factor_error(1e-3, 0.0, device.decay_time)
    assert hold == pytest.approx(-1.1111e-6, rel=1e-4)
    assert error == pytest.approx(hold, abs=1e-7)


def test_virtual_rotation_moves_the_pattern_and_not_the_output(fmu: GyroFmu) -> None:
    with fmu.power_on(Device().fmu_parameters(), seed=0, start_angle=0.0) as gyro:
        gyro.command("virtualRotation", 1.0 * DEG)
        angle = advance(gyro, 0.0, 50.0)
        assert gyro.read("patternAngle") == pytest.approx(0.277 * 50 * DEG, rel=1e-4)
        assert abs(angle) < 1e-5 * 50 * DEG


def test_angle_random_walk_is_what_the_parameter_says(fmu: GyroFmu) -> None:
    """400 means of 1 s: their standard deviation is N/sqrt(1 s) within 3.5 sigma (12 %)."""
    walk = 1e-3 * DEG_PER_SQRT_H
    device = Device(angle_random_walk=walk)
    with fmu.power_on(device.fmu_parameters(), seed=42, start_angle=0.2) as gyro:
        advance(gyro, 0.0, 5.0)
        means = np.diff(drive(gyro, np.zeros(401), 1.0))
    expected = walk / math.sqrt(1.0)  # rate means over 1 s
    assert np.std(means, ddof=1) == pytest.approx(expected, rel=3.5 / math.sqrt(2 * 400))


def test_pickoff_noise_is_what_the_parameter_says(fmu: GyroFmu) -> None:
    """Angle read every 0.1 s: white with the stated deviation, within 3.5 sigma."""
    device = Device(angle_white_noise=1e-6)
    with fmu.power_on(device.fmu_parameters(), seed=43, start_angle=0.2) as gyro:
        advance(gyro, 0.0, 1.0)
        angles = drive(gyro, np.zeros(4000), 0.1)
    assert np.std(angles) == pytest.approx(1e-6, rel=3.5 / math.sqrt(2 * 4000))


def test_seeds_give_unrelated_noise(fmu: GyroFmu) -> None:
    """Neighbouring seeds: correlation of 4000 increments below 4 sigma."""
    device = Device(angle_random_walk=1e-6)
    series = []
    for seed in (1, 2, 3):
        with fmu.power_on(device.fmu_parameters(), seed=seed, start_angle=0.2) as gyro:
            series.append(np.diff(drive(gyro, np.zeros(4001), 0.1)))
    correlation = np.corrcoef(series) - np.eye(3)
    assert np.max(np.abs(correlation)) < 4 / math.sqrt(4000)
