"""Mechanisms that a turn, a virtual rotation or capture shows, against their closed forms; numbers
as in `test_mechanisms`."""

import math
from collections.abc import Mapping

import numpy as np
import pytest

from fmu_build.bundle import build_fmu
from pyhrg.common.units import DEG
from pyhrg.fmu import Gyro, GyroFmu
from tests.agreement.mechanisms import TAU, K
from tests.driving import advance, drive


@pytest.mark.parametrize("delay", [0.0, 5e-4, 3e-3])
def test_15_loop_delay_is_a_scale_factor_error(fmu: GyroFmu, delay: float) -> None:
    """-(Ts/2 + td)/tau, odd in the rate."""
    for rate in (0.5, -0.5):
        with fmu.power_on(
            {"controller.synthesis.loopDelay": delay}, seed=0, start_angle=0.1
        ) as gyro:
            error = advance(gyro, rate, 50.0) / (50 * rate) - 1
        assert error == pytest.approx(-(5e-4 + delay) / TAU, abs=5e-8)


def turning(fmu: GyroFmu, parameters: Mapping[str, float], rate: float = 0.5) -> float:
    """Scale-factor error after 50 s, the hold's taken out."""
    with fmu.power_on(parameters, seed=0, start_angle=0.1) as gyro:
        return advance(gyro, rate, 50.0) / (50 * rate) - 1 + 5e-4 / TAU


def test_16_bryan_factor_error_is_a_scale_factor_error(fmu: GyroFmu) -> None:
    error = turning(fmu, {"resonator.material.bryanFactor": 0.277 * (1 + 20e-6)})
    assert error == pytest.approx(20e-6, rel=0.01)


def test_17_clock_error_leaves_the_angle_and_scales_the_rate(fmu: GyroFmu) -> None:
    with fmu.power_on({"controller.readout.clockError": 1e-4}, seed=0, start_angle=0.1) as gyro:
        angle = advance(gyro, 0.5, 50.0)
        assert angle / 25 - 1 == pytest.approx(-5e-4 / TAU, abs=1e-7)
        assert gyro.read("gyroRate") / 0.5 - 1 == pytest.approx(-1e-4, rel=0.02)
        assert gyro.read("frequencyOffset") == pytest.approx(-1e-4 * 2 * math.pi * 7000, rel=1e-3)


@pytest.mark.parametrize("direction", [1, -1])
def test_18_virtual_rotation_error_flips_with_the_rotation(fmu: GyroFmu, direction: int) -> None:
    """B = -e V/k, V the pattern rate: -e times the commanded input rate."""
    rate, e = direction * 1.0 * DEG, 1e-4
    with fmu.power_on(
        {"controller.readout.virtualRotationError": e}, seed=0, start_angle=0.1
    ) as gyro:
        gyro.command("virtualRotation", rate)
        settled = advance(gyro, 0.0, 10.0)
        bias = (advance(gyro, 0.0, 40.0) - settled) / 40.0
    assert bias == pytest.approx(-e * rate, rel=0.02)


def locked_angle(gyro: Gyro, rate: float, seconds: float) -> float:
    advance(gyro, rate, seconds)
    return gyro.read("patternAngle")


def test_19_lock_in_follows_adler(fmu: GyroFmu) -> None:
    """Below W_L = D/4k the pattern stops where sin 4(th - th_tau) = W/W_L; above, free precession
    has the mean rate sqrt(W^2 - W_L^2), while an imposed uniform turn has none."""
    d = 1e-2
    limit = d / (4 * K)
    parameters = {"resonator.material.dampingAnisotropy": d}
    with fmu.power_on(parameters, seed=0, start_angle=0.1) as gyro:
        angle = locked_angle(gyro, 0.5 * limit, 3000.0)
        held = advance(gyro, 0.5 * limit, 100.0)
        assert gyro.read("patternAngle") == pytest.approx(angle, abs=1e-6)
        assert math.sin(4 * angle) == pytest.approx(0.5, rel=0.02)
        assert held == pytest.approx((0.1 - angle) / K, rel=1e-3)
    period = 2 * math.pi / (4 * K * math.sqrt(3) * limit)
    with fmu.power_on(parameters, seed=0, start_angle=0.1) as gyro:
        before = advance(gyro, 2 * limit, 50.0)
        mean = (advance(gyro, 2 * limit, period) - before) / period
    assert mean == pytest.approx(math.sqrt(3) * limit, rel=1e-3)


@pytest.mark.parametrize("fidelity", ["HRG", "HRGSlow"])
def test_40_time_division_in_a_turn_is_its_bias_along_the_pattern(fidelity: str) -> None:
    """Integral of B = -(dw^2 Ts/16k) sin 8 th, th' = -k W: (dw^2 Ts/(128 k^2 W)) (cos 8 th_0 - cos
    8 th), which comes and goes. Loops that lag by t would add a mean bias of (dw^2 Ts/8) W t."""
    dw, rate, start, gyro_fmu = 0.05, 0.1, 0.2, GyroFmu(build_fmu(fidelity))
    parameters = {"resonator.material.frequencySplit": dw}
    angles = []
    for division in (1, 0):
        with gyro_fmu.power_on(
            {**parameters, "controller.timeDivision": division}, seed=0, start_angle=start
        ) as gyro:
            angles.append(drive(gyro, np.full(50, rate), 2.0))
    swing = dw**2 * 1e-3 / (128 * K**2 * rate)
    pattern = start - K * rate * 2.0 * np.arange(1, 51)
    expected = swing * (np.cos(8 * start) - np.cos(8 * pattern))
    np.testing.assert_allclose(angles[0] - angles[1], expected, rtol=0, atol=0.01 * swing)
