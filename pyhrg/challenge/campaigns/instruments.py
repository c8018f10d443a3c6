"""Instruments: reading noise of the channels, quantization of the output, digits of the log."""

from collections.abc import Mapping
from dataclasses import dataclass, fields, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from pyhrg.common.units import HZ
from pyhrg.device.device import Device
from pyhrg.records import Log
from pyhrg.records.columns import BY_FIELD

Array = NDArray[np.float64]


@dataclass(frozen=True)
class Instruments:
    """Standard deviations of the white noise of a row, SI; by default those of the recorded
    campaigns."""

    temperature: float = 5e-3
    amplitude: float = 1e-6
    amplitude_force: float = 1e-5
    """Relative to the force."""
    quadrature_force: float = 1e-8
    frequency_offset: float = 1e-5 * HZ

    def drawn(self, generator: np.random.Generator) -> "Instruments":
        """Instruments of another bench: each up to a factor of 1.4 better or worse."""
        factors = 1.4 ** generator.uniform(-1, 1, len(fields(self)))
        names = [field.name for field in fields(self)]
        changed: dict[str, Any] = {
            n: getattr(self, n) * f for n, f in zip(names, factors.tolist(), strict=True)
        }
        return replace(self, **changed)


DECIMALS = {
    "table_angle": 7,
    "acceleration_x": 3,
    "acceleration_y": 3,
    "acceleration_z": 3,
    "temperature": 3,
    "gyro_angle": 9,
    "wave_angle": 4,
    "amplitude": 7,
    "frequency_offset": 7,
}
"""Decimals of a column in its unit, as the recorded campaigns have them."""
SIGNIFICANT = {"amplitude_force": 10, "quadrature_force": 7}
"""Digits of a column that spans decades."""


def record_log(log: Log, device: Device, own: Instruments, generator: np.random.Generator) -> Log:
    """A log with reading noise, quantization and rounded digits.

    Args:
        log: what bench and gyro did, exact.
        device: its white angle noise and quantum; input-referred, so that the pattern angle has the
            Bryan factor of it.
        own: noise of the other channels.
        generator: of the noise.
    """
    draws = dict(zip(NOISY, generator.standard_normal((len(NOISY), len(log.time))), strict=True))
    angle_noise = device.angle_white_noise
    force = log.amplitude_force
    values: dict[str, Any] = {
        "gyro_angle": _quantised(
            log.gyro_angle + angle_noise * draws["gyro_angle"], device.quantization_step
        ),
        "wave_angle": log.wave_angle + device.bryan_factor * angle_noise * draws["wave_angle"],
        "amplitude_force": force + own.amplitude_force * force * draws["amplitude_force"],
        **{
            name: getattr(log, name) + getattr(own, name) * draws[name]
            for name in ("temperature", "amplitude", "quadrature_force", "frequency_offset")
        },
    }
    return round_log(replace(log, **values))


NOISY = (
    "gyro_angle",
    "wave_angle",
    "temperature",
    "amplitude",
    "amplitude_force",
    "quadrature_force",
    "frequency_offset",
)


def round_log(log: Log) -> Log:
    """A log rounded to the digits of the recorded files."""
    decimals: Mapping[str, Array] = {
        name: np.round(_in_unit(log, name), digits) for name, digits in DECIMALS.items()
    }
    significant = {
        name: _significant(_in_unit(log, name), digits) for name, digits in SIGNIFICANT.items()
    }
    values = {**decimals, **significant}
    si: dict[str, Any] = {n: v * BY_FIELD[n].factor + BY_FIELD[n].offset for n, v in values.items()}
    return replace(log, **si)


def _in_unit(log: Log, name: str) -> Array:
    column = BY_FIELD[name]
    return np.asarray((getattr(log, name) - column.offset) / column.factor)


def _significant(values: Array, digits: int) -> Array:
    magnitude = np.floor(np.log10(np.abs(values), where=values != 0, out=np.zeros_like(values)))
    scale = 10.0 ** (digits - 1 - magnitude)
    return np.asarray(np.round(values * scale) / scale)


def _quantised(angle: Array, quantum: float) -> Array:
    return quantum * np.round(angle / quantum) if quantum else angle
