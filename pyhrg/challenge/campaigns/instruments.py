"""Instruments: reading noise of the channels, quantization of the output, digits of the log."""

from dataclasses import dataclass, fields, replace
from typing import Any

import numpy as np

from pyhrg.common.arrays import Array
from pyhrg.common.units import HZ
from pyhrg.device.device import Device
from pyhrg.records import Log
from pyhrg.records.columns import BY_FIELD


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

    def draw_another(self, generator: np.random.Generator) -> "Instruments":
        """Instruments of another bench: each up to a factor of 1.4 better or worse."""
        names = [field.name for field in fields(self)]
        factors = (1.4 ** generator.uniform(-1, 1, len(names))).tolist()
        return Instruments(*(getattr(self, n) * f for n, f in zip(names, factors, strict=True)))


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
"""Significant digits of a column that spans decades."""


NOISY = (
    *("gyro_angle", "wave_angle", "temperature", "amplitude"),
    *("amplitude_force", "quadrature_force", "frequency_offset"),
)
"""Fields of a log with reading noise, in the order in which the noise is drawn."""


def record_log(log: Log, device: Device, own: Instruments, generator: np.random.Generator) -> Log:
    """An exact log with reading noise, quantization and the digits of the recorded files.

    White noise and quantization step of the output angle are the device's. They are input-referred,
    so the pattern angle has the noise times the Bryan factor."""
    draws = dict(zip(NOISY, generator.standard_normal((len(NOISY), len(log.time))), strict=True))
    noise, step = device.angle_white_noise, device.quantization_step
    angle = log.gyro_angle + noise * draws["gyro_angle"]
    force = log.amplitude_force
    noisy: dict[str, Any] = {
        "gyro_angle": step * np.round(angle / step) if step else angle,
        "wave_angle": log.wave_angle + device.bryan_factor * noise * draws["wave_angle"],
        "amplitude_force": force + own.amplitude_force * force * draws["amplitude_force"],
        **{
            name: getattr(log, name) + getattr(own, name) * draws[name]
            for name in ("temperature", "amplitude", "quadrature_force", "frequency_offset")
        },
    }
    return _round_log(replace(log, **noisy))


def _round_log(log: Log) -> Log:
    rounded: dict[str, Any] = {}
    for name in (*DECIMALS, *SIGNIFICANT):
        column = BY_FIELD[name]
        values = np.asarray((getattr(log, name) - column.offset) / column.factor)
        if name in DECIMALS:
            values = np.round(values, DECIMALS[name])
        else:
            values = _round_significant(values, SIGNIFICANT[name])
        rounded[name] = values * column.factor + column.offset
    return replace(log, **rounded)


def _round_significant(values: Array, digits: int) -> Array:
    magnitude = np.floor(np.log10(np.abs(values), where=values != 0, out=np.zeros_like(values)))
    scale = 10.0 ** (digits - 1 - magnitude)
    return np.asarray(np.round(values * scale) / scale)
