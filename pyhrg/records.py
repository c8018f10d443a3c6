"""Stub, replaced."""
from dataclasses import dataclass
import numpy as np
from numpy.typing import NDArray
Array = NDArray[np.float64]
class LogError(Exception): ...
@dataclass(frozen=True)
class Log:
    source: str
    interval: float
    time: Array
    table_angle: Array
    axis_up: Array
    acceleration_x: Array
    acceleration_y: Array
    acceleration_z: Array
    temperature: Array
    virtual_rotation: Array
    amplitude_setpoint: Array
    phase_offset: Array
    drive_on: Array
    gyro_angle: Array
    wave_angle: Array
    amplitude: Array
    amplitude_force: Array
    quadrature_force: Array
    frequency_offset: Array
    valid: Array | None = None
    exclusions: tuple[str, ...] = ()
    def require(self, *names: str) -> None: ...
    def stretches(self, *names: str) -> list[slice]:
        return [slice(0, len(self.time))]
