"""Keys of a device file put to the FMU, and what its outputs settle at."""

import math
from collections.abc import Mapping

import numpy as np

from pyhrg.common.units import DEG
from pyhrg.device import device_file
from pyhrg.fmu import Gyro, GyroFmu
from tests.driving import advance

K, TAU = 0.277, 450.0
ANGLES = np.array([7.0, 31.0, 64.0]) * DEG
SPLIT = {"frequency_split_Hz": 1e-3, "stiffness_axis_deg": 50.0}
DW, SPLIT_AXIS = 2 * math.pi * 1e-3, 50 * DEG
SIN4 = np.sin(4 * ANGLES)
SIN_SPLIT = np.sin(4 * (ANGLES - SPLIT_AXIS))
ONE = np.ones(3)


def gyro(fmu: GyroFmu, keys: Mapping[str, float], angle: float) -> Gyro:
    device = device_file.from_table(keys, "test")
    return fmu.power_on(device.fmu_parameters(), seed=0, start_angle=angle)


def settled(
    fmu: GyroFmu, keys: Mapping[str, float], inputs: Mapping[str, float], channel: str
) -> np.ndarray:
    """Mean output rate (`bias`) or another output at each angle, after the loops' transient."""
    values = []
    for angle in ANGLES:
        with gyro(fmu, keys, angle) as running:
            for name, value in inputs.items():
                running.command(name, value)
            before = advance(running, 0.0, 20.0)
            bias = (advance(running, 0.0, 20.0) - before) / 20.0
            values.append(bias if channel == "bias" else running.read(channel))
    return np.array(values)


def holds(measured: np.ndarray, expected: np.ndarray, tolerance: float = 0.01) -> bool:
    return bool(np.max(np.abs(measured - expected)) < tolerance * np.max(np.abs(expected)))
