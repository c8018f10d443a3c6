"""Outputs of a gyro with one mechanism, fitted by harmonics of the pattern angle."""

from collections.abc import Mapping

import numpy as np

from pyhrg.common.units import DEG
from pyhrg.fmu import GyroFmu
from tests.driving import advance

K = 0.277
TAU = 450.0
CHANNELS = ("amplitudeForce", "quadratureForce", "frequencyOffset")
ANGLES = np.arange(16) * 11.25 * DEG
"""Half a turn of the pattern: harmonics 2, 4 and 8 are orthogonal over it."""


def harmonics(values: np.ndarray) -> dict[str, complex]:
    """Mean and complex amplitudes: value = mean + Re sum H_n exp(-i n th)."""
    result: dict[str, complex] = {"0": complex(np.mean(values))}
    for n in (2, 4, 6, 8):
        result[str(n)] = complex(2 * np.mean(values * np.exp(1j * n * ANGLES)))
    return result


def at_rest(
    fmu: GyroFmu,
    parameters: Mapping[str, float],
    inputs: Mapping[str, float] | None = None,
    settle: float = 10.0,
    dwell: float = 20.0,
) -> dict[str, dict[str, complex]]:
    """Harmonics of output bias and channels over the circumference, the case at rest."""
    table: dict[str, list[float]] = {name: [] for name in ("bias", *CHANNELS)}
    for angle in ANGLES:
        with fmu.power_on(parameters, seed=0, start_angle=angle) as gyro:
            for name, value in (inputs or {}).items():
                gyro.command(name, value)
            settled = advance(gyro, 0.0, settle)
            table["bias"].append((advance(gyro, 0.0, dwell) - settled) / dwell)
            for name in CHANNELS:
                table[name].append(gyro.read(name))
    return {name: harmonics(np.array(values)) for name, values in table.items()}


def close(got: complex, expected: complex, scale: float, tolerance: float = 0.01) -> bool:
    return abs(got - expected) <= tolerance * abs(scale)
