"""HRGSlow beside HRG where a step turns the pattern far, and where drives are overloaded."""

import math

import numpy as np
import pytest

from fmu_build.bundle import build_fmu
from pyhrg.fmu import GyroFmu
from tests.driving import advance, drive

K = 0.277


@pytest.fixture(scope="module")
def slow() -> GyroFmu:
    return GyroFmu(build_fmu("HRGSlow"))


@pytest.mark.parametrize("period", [0.01, 0.1, 1.0])
@pytest.mark.parametrize("rate", [3.0, -30.0, 100.0])
def test_no_rate_is_too_fast_for_a_long_period(slow: GyroFmu, period: float, rate: float) -> None:
    """Beyond pi/4 of pattern a period, where angles at the ends alone would alias."""
    with slow.power_on({"samplePeriod": period}, seed=0, start_angle=0.3) as gyro:
        assert advance(gyro, rate, 20.0) == pytest.approx(20 * rate, rel=1e-5)


def test_fast_virtual_rotation_is_taken_out(slow: GyroFmu) -> None:
    with slow.power_on({"samplePeriod": 1.0}, seed=0, start_angle=0.3) as gyro:
        gyro.command("virtualRotation", 5.0)
        assert abs(advance(gyro, 0.0, 20.0)) < 1e-4 * 100


def test_drive_on_scales_the_force_once(fmu: GyroFmu) -> None:
    """Half the drive, half the virtual rotation; the read-out counts the half."""
    with fmu.power_on({}, seed=0, start_angle=0.0) as gyro:
        gyro.command("driveOn", 0.5)
        gyro.command("virtualRotation", 0.1)
        angle = advance(gyro, 0.0, 20.0)
        assert gyro.read("patternAngle") == pytest.approx(K * 0.5 * 0.1 * 20, rel=1e-3)
        assert abs(angle) < 1e-3


def test_overload_passes_without_a_trace(fmu: GyroFmu) -> None:
    """Rebalance beyond its range for a second: not valid then, valid and right afterwards."""
    authority = 0.02
    beyond = 1.5 * authority / (2 * K)
    parameters = {"controller.forceToRebalance": 1, "drive.authority": authority}
    with fmu.power_on(parameters, seed=0, start_angle=0.0) as gyro:
        advance(gyro, 0.0, 3.0)
        advance(gyro, beyond, 5.0)
        assert gyro.read("valid") == 0
        angle = advance(gyro, 0.0, 60.0)
        assert gyro.read("valid") == 1
        assert angle == pytest.approx(5 * beyond, rel=0.02)


def test_first_rate_is_no_spike(fmu: GyroFmu) -> None:
    """The angle begins at the read-out's error; the rate does not."""
    with fmu.power_on({"pickOff.gainMismatch": 1e-3}, seed=0, start_angle=0.3) as gyro:
        assert gyro.read("gyroAngle") == pytest.approx(1e-3 / (4 * K) * math.sin(1.2), rel=0.01)
        assert gyro.read("gyroRate") == 0


def test_flicker_is_the_same_at_any_period(slow: GyroFmu) -> None:
    """0.664 B of Allan deviation over four periods, within 20 %; eight seeds, 1000 means each."""
    for period in (0.1, 1.0):
        ratios = []
        for seed in range(8):
            parameters = {"noise.biasInstability": 1e-6, "samplePeriod": period}
            with slow.power_on(parameters, seed=seed, start_angle=0.1) as gyro:
                advance(gyro, 0.0, 20.0)
                rates = np.diff(drive(gyro, np.zeros(1001), 4 * period)) / (4 * period)
            ratios.append(0.5 * np.mean(np.diff(rates) ** 2) / 1e-12)
        assert math.sqrt(np.mean(ratios)) == pytest.approx(0.664, rel=0.2)
