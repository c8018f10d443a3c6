"""Keys of a device file that act over temperature, on the FMU, as `test_devices`."""

import math
from collections.abc import Mapping

import numpy as np
import pytest

from pyhrg.common.units import DEG_PER_H
from pyhrg.fmu import GyroFmu
from tests.agreement.device_keys import (
    DW,
    ONE,
    SIN4,
    SIN_SPLIT,
    SPLIT,
    TAU,
    K,
    gyro,
    holds,
    settled,
)
from tests.driving import advance

WARM = {"caseTemperature": 298.15 + 10.0}
"""10 K above the reference."""
WARMED: dict[str, tuple[Mapping[str, float], str, np.ndarray]] = {
    "D (1 + c dT)": (
        {"damping_anisotropy_per_s": 1e-6, "damping_anisotropy_per_K": 0.05},
        "bias",
        -0.5 * 1e-6 / (4 * K) * SIN4,
    ),
    "tau (1 + c dT)": ({"decay_time_per_K": -1e-4}, "amplitudeForce", 1e-3 / TAU * ONE),
    "phase with split": (
        {**SPLIT, "phase_rad_per_K": 1e-4},
        "bias",
        -DW * 1e-3 / (4 * K) * SIN_SPLIT,
    ),
    "pick-off gain": ({"pickoff_gain_per_K": 1e-5}, "bias", 1e-4 / (4 * K * TAU) * SIN4),
    "frequency": (
        {"frequency_temperature_coefficient_per_K": 8.5e-5, "frequency_Hz": 5000.0},
        "frequencyOffset",
        2 * math.pi * 5000 * 8.5e-4 * ONE,
    ),
}


@pytest.mark.parametrize(("keys", "channel", "change"), WARMED.values(), ids=WARMED.keys())
def test_temperature(
    fmu: GyroFmu, keys: Mapping[str, float], channel: str, change: np.ndarray
) -> None:
    """What 10 K change, once the resonator has followed the case."""
    lagging = {**keys, "thermal_lag_s": 1.0}
    warm = settled(fmu, lagging, WARM, channel)
    assert holds(warm - settled(fmu, lagging, {}, channel), change)


def test_reference_temperature_and_lag(fmu: GyroFmu) -> None:
    """Nothing happens at it; after one lag at 10 K above it, 1 - 1/e of the change has come."""
    keys = {
        "reference_temperature_degC": 40.0,
        "frequency_temperature_coefficient_per_K": 8.5e-5,
        "thermal_lag_s": 30.0,
    }
    with gyro(fmu, keys, 0.1) as running:
        advance(running, 0.0, 20.0)
        assert abs(running.read("frequencyOffset")) < 1e-6
        running.command("caseTemperature", 313.15 + 10.0)
        advance(running, 0.0, 30.0)
        assert running.read("frequencyOffset") == pytest.approx(
            2 * math.pi * 7000 * 8.5e-4 * (1 - math.exp(-1)), rel=1e-3
        )


def test_temperature_rate_bias(fmu: GyroFmu) -> None:
    """0.5 deg/h per K/min at 3 K/min: 1.5 deg/h, the case warming in steps of 10 ms."""
    with gyro(fmu, {"bias_deg_h_per_K_min": 0.5}, 0.1) as running:
        advance(running, 0.0, 10.0)
        before = running.read("gyroAngle")
        for step in range(1, 1001):
            running.command("caseTemperature", 298.15 + 3 / 60 * 0.01 * step)
            advance(running, 0.0, 0.01)
        bias = (running.read("gyroAngle") - before) / 10.0
    assert bias == pytest.approx(1.5 * DEG_PER_H, rel=0.01)
