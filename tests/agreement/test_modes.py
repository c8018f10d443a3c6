"""Modes of operation: ring-down, rebalance, start-up, compensation, cancellation."""

import math
from pathlib import Path

import numpy as np
import pytest

from benchmarks.modes.paired_gyros import calibrate_at_rest, evaluate_map
from pyhrg.common.units import DEG, DEG_PER_H, DEG_PER_SQRT_H
from pyhrg.device.device import Device
from pyhrg.fmu import GyroFmu
from pyhrg.theory.closed_forms import static_bias
from pyhrg.theory.travelling_waves import split_into_waves, unequal_wave_bias
from tests.driving import advance, drive

K = 0.277
TAU = 450.0


def test_ring_down_gives_decay_time_and_damping_axis(fmu: GyroFmu) -> None:
    """tan 2(th - th_tau) = tan 2(th0 - th_tau) exp(D t); the amplitude decays with tau."""
    d, axis, start = 2e-4, 10 * DEG, 30 * DEG
    parameters = {
        "resonator.material.dampingAnisotropy": d,
        "resonator.material.dampingAxis": axis,
    }
    with fmu.power_on(parameters, seed=0, start_angle=start) as gyro:
        gyro.command("driveOn", 0.0)
        advance(gyro, 0.0, 0.001)
        begin = gyro.read("patternAngle")
        advance(gyro, 0.0, 200.0)
        expected = axis + 0.5 * math.atan(math.tan(2 * (begin - axis)) * math.exp(d * 200))
        assert gyro.read("patternAngle") == pytest.approx(expected, abs=1e-7)
        growth = math.log(gyro.read("amplitude")) / 200
        assert growth == pytest.approx(-1 / TAU, rel=0.05)


def test_a_gyro_that_rang_down_goes_on(fmu: GyroFmu) -> None:
    """After 1000 decay times it turns as before, invalid, of a size below thermal motion; switched
    on again it is as new, but for the angle by which the force's aim lags the pattern."""
    with fmu.power_on({"resonator.material.decayTime": 1.0}, seed=0, start_angle=0.2) as gyro:
        advance(gyro, 0.01, 1.0)
        gyro.command("driveOn", 0.0)
        begin = advance(gyro, 0.01, 900.0)
        assert advance(gyro, 0.01, 100.0) - begin == pytest.approx(1.0, rel=1e-9)
        assert gyro.read("valid") == 0
        assert 0 < gyro.read("amplitude") <= 1e-9
        gyro.command("driveOn", 1.0)
        on_again = advance(gyro, 0.01, 10.0)
        assert gyro.read("valid") == 1
        assert advance(gyro, 0.01, 10.0) - on_again == pytest.approx(0.1, rel=1e-3)


def test_force_to_rebalance_holds_the_pattern_and_measures(fmu: GyroFmu) -> None:
    with fmu.power_on({"controller.forceToRebalance": 1}, seed=0, start_angle=20 * DEG) as gyro:
        advance(gyro, 1 * DEG, 2.0)
        before = advance(gyro, 1 * DEG, 1.0)
        angle = advance(gyro, 1 * DEG, 20.0)
        assert gyro.read("patternAngle") == pytest.approx(20 * DEG, abs=1e-6)
        assert (angle - before) / 20 == pytest.approx(1 * DEG, rel=1e-5)
        assert gyro.read("gyroRate") == pytest.approx(1 * DEG, rel=1e-4)


@pytest.mark.parametrize("division", [0, 1])
def test_force_to_rebalance_range_is_the_drives_authority(fmu: GyroFmu, division: int) -> None:
    """A force of f turns the pattern at f/2: full range is f/(2k); beyond it the pattern slips. In
    time division f acts half the time."""
    authority = 0.02
    full = authority / (2 * K) / (1 + division)
    parameters = {
        "controller.forceToRebalance": 1,
        "controller.timeDivision": division,
        "drive.authority": authority,
    }
    for rate, held in ((0.8 * full, True), (1.3 * full, False)):
        with fmu.power_on(parameters, seed=0, start_angle=0.0) as gyro:
            advance(gyro, rate, 5.0)
            assert (abs(gyro.read("patternAngle")) < 1e-3) == held


def test_start_up_in_two_stages(fmu: GyroFmu) -> None:
    """From 1 % of amplitude: a valid rate within 1 s, full amplitude at 10 s."""
    parameters = {"startAmplitude": 0.01, "controller.startUp.firstAmplitude": 0.05}
    with fmu.power_on(parameters, seed=0, start_angle=0.3) as gyro:
        assert gyro.read("valid") == 0
        advance(gyro, 0.1, 1.0)
        assert gyro.read("valid") == 1
        assert gyro.read("amplitude") < 0.15
        first = advance(gyro, 0.1, 0.5)
        assert (advance(gyro, 0.1, 1.0) - first) / 0.1 == pytest.approx(1.0, rel=1e-3)
        advance(gyro, 0.1, 8.0)
        assert gyro.read("amplitude") == pytest.approx(1.0, rel=0.02)
        assert gyro.read("valid") == 1


def test_bias_map_compensates_the_dead_zone(fmu: GyroFmu) -> None:
    """Eq. (5): locked, the pattern stands; with the map the output still gives the input."""
    d = 1e-2
    limit = d / (4 * K)
    parameters = {
        "resonator.material.dampingAnisotropy": d,
        "controller.biasMap.sin4": -limit,
    }
    with fmu.power_on(parameters, seed=0, start_angle=0.0) as gyro:
        before = advance(gyro, 0.6 * limit, 2000.0)
        angle = gyro.read("patternAngle")
        gained = advance(gyro, 0.6 * limit, 100.0) - before
        assert gyro.read("patternAngle") == pytest.approx(angle, abs=1e-4)
        assert gained == pytest.approx(60 * limit, rel=1e-3)


def test_cancellation_removes_the_dead_zone(fmu: GyroFmu) -> None:
    """Eq. (7), its factors mended: the pattern precesses again, at half the lock-in rate."""
    d, axis = 1e-2, 15 * DEG
    limit = d / (4 * K)
    parameters = {
        "resonator.material.dampingAnisotropy": d,
        "resonator.material.dampingAxis": axis,
        "controller.cancellation.dampingAnisotropy": d,
        "controller.cancellation.dampingAxis": axis,
    }
    with fmu.power_on(parameters, seed=0, start_angle=0.0) as gyro:
        before = advance(gyro, 0.5 * limit, 10.0)
        gained = advance(gyro, 0.5 * limit, 500.0) - before
    assert gained == pytest.approx(250 * limit, rel=1e-3)


def test_full_turn_mean_is_zero_for_imposed_rotation_only(fmu: GyroFmu) -> None:
    """The paper's 1.2: yes for an imposed uniform turn; a free pattern obeys Adler, and its mean
    output falls short by W - sqrt(W^2 - WL^2)."""
    d = 1e-4
    limit = d / (4 * K)
    rate = 20 * limit
    parameters = {"resonator.material.dampingAnisotropy": d}
    short = rate - math.sqrt(rate**2 - limit**2)
    period = 2 * math.pi / (4 * K * math.sqrt(rate**2 - limit**2))
    with fmu.power_on(parameters, seed=0, start_angle=0.0) as gyro:
        before = advance(gyro, rate, 20.0)
        free = (advance(gyro, rate, period) - before) / period - rate
    hold = -rate * 5e-4 / TAU
    assert free - hold == pytest.approx(-short, rel=0.05)
    angles = np.arange(16) * 22.5 / 4 * DEG
    imposed = []
    for angle in angles:
        with fmu.power_on(parameters, seed=0, start_angle=angle) as gyro:
            before = advance(gyro, 0.0, 5.0)
            imposed.append((advance(gyro, 0.0, 1.0) - before) / 1.0)
    assert abs(np.mean(imposed)) < 0.02 * short + 1e-5 * DEG_PER_H


def test_scale_factor_map_takes_out_the_angle_error(fmu: GyroFmu) -> None:
    """Eqs. (2) and (3): calibrated pick-off errors leave what is of second order in them."""
    g, d, offset = 1e-3, -7e-4, 5e-4
    errors = {
        "pickOff.gainMismatch": g,
        "pickOff.nonOrthogonality": d,
        "pickOff.offset": offset,
    }
    calibration = {
        "controller.scaleFactorMap.sin4": -g / 4,
        "controller.scaleFactorMap.cos4": d / 4,
        "controller.scaleFactorMap.sin2": -offset / 2,
    }
    wrong = {name: -value for name, value in calibration.items()}
    turned = 2.0 * 0.1 * np.arange(1, 101)
    spread = []
    for parameters in (errors, {**errors, **calibration}, {**errors, **wrong}):
        with fmu.power_on(parameters, seed=0, start_angle=0.1) as gyro:
            angle = drive(gyro, np.full(100, 2.0), 0.1)[20:]
        straight = np.polyval(np.polyfit(turned[20:], angle, 1), turned[20:])
        spread.append(float(np.std(angle - straight)))
    assert spread[0] > 1e-4
    assert spread[1] < 0.01 * spread[0]
    assert spread[2] == pytest.approx(2 * spread[0], rel=0.02)


def test_two_gyros_calibrate_each_other(fmu_path: Path) -> None:
    """With next to no noise each knows its harmonics within 1 % of 0.8 deg/h, and half of the
    difference of the mean biases, which leaves (m1 + m2)/2 to both (`benchmarks.modes`)."""
    sizes, quiet = (1e-3, -4e-4), 1e-6 * DEG_PER_SQRT_H
    pair = [
        Device(
            damping_anisotropy=4e-3 * abs(size),
            damping_axis=0.3,
            drive_nonorthogonality=size,
            drive_gain_mismatch=size,
            angle_random_walk=quiet,
        )
        for size in sizes
    ]
    known = calibrate_at_rest(GyroFmu(fmu_path), pair, seed=1)
    angles = np.arange(16) * math.pi / 16
    left = np.mean(sizes) / (4 * K * TAU)
    for size, coefficients in zip(sizes, known, strict=True):
        bias = -abs(size) * 1e-3 / K * np.sin(4 * (angles - 0.3))
        bias += size / (4 * K * TAU) * (np.sin(4 * angles) - np.cos(4 * angles) - 1)
        assert bias - evaluate_map(coefficients, angles) == pytest.approx(-left, abs=0.01 * 4e-6)


def test_the_orbit_is_two_travelling_waves(fmu: GyroFmu) -> None:
    """While a gyro with a split and errors of its pick-offs turns: amplitude and quadrature are
    half the sum and half the difference of the waves' amplitudes as read, and the pattern angle is
    a quarter of their phases' difference."""
    parameters = {
        "resonator.material.frequencySplit": 1e-2,
        "pickOff.gainMismatch": 1e-2,
        "pickOff.nonOrthogonality": 1e-2,
        "controller.quadratureSetpoint": 0.2,
    }
    with fmu.power_on(parameters, seed=0, start_angle=0.3) as gyro:
        for _ in range(5):
            advance(gyro, 0.5, 1.0)
            reading = [gyro.read(f"pickOff.reading[{i}]") for i in (1, 2, 3, 4)]
            forward, backward = split_into_waves(reading)
            sizes = abs(forward), abs(backward)
            assert gyro.read("amplitude") == pytest.approx(sum(sizes) / 2, rel=1e-12)
            assert gyro.read("quadrature") == pytest.approx((sizes[0] - sizes[1]) / 2, rel=1e-12)
            turned = 4 * gyro.read("patternAngle") - np.angle(forward / backward)
            assert math.remainder(turned, 2 * math.pi) == pytest.approx(0, abs=1e-12)


def test_unequal_waves_have_more_bias(fmu: GyroFmu) -> None:
    """Closed form of a ratio of 1 to 3; equal waves have that of the whole-angle mode."""
    device = Device(
        damping_anisotropy=4e-6, damping_axis=0.4, frequency_split=2e-6, stiffness_axis=0.5
    )
    for quadrature in (0.0, 0.5):
        parameters = {
            "resonator.material.dampingAnisotropy": device.damping_anisotropy,
            "resonator.material.dampingAxis": device.damping_axis,
            "resonator.material.frequencySplit": device.frequency_split,
            "resonator.material.stiffnessAxis": device.stiffness_axis,
            "controller.quadratureSetpoint": quadrature,
        }
        with fmu.power_on(parameters, seed=0, start_angle=0.1) as gyro:
            before = advance(gyro, 0.0, 10.0)
            measured = (advance(gyro, 0.0, 20.0) - before) / 20.0
            angle = gyro.read("patternAngle")
        (expected,) = unequal_wave_bias(device, [angle], quadrature)
        assert measured == pytest.approx(expected, abs=2e-3 * 4e-6 / (4 * K))
        if quadrature == 0.0:
            (usual,) = static_bias(device, [angle])
            assert expected == pytest.approx(usual, rel=1e-12)
