"""A gyro of a device file in flight: its maps, read off the FMU, and its noise."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ins_eval.study.gyros.drift import Flight
from ins_eval.study.gyros.true_maps import coefficients, started_at, turning
from pyhrg.device.device import Device
from pyhrg.fmu import GyroFmu

Array = NDArray[np.float64]

RISE = 10.0
"""Of the case above the reference temperature after power-on, K; the resonator follows."""
NOISES = ("pickoff_noise", "angle_random_walk", "bias_instability", "rate_random_walk")
"""Fields of a device in the order of `noise_weights.KINDS`."""


@dataclass(frozen=True)
class Gyro:
    """coefficients: (signals.COUNT,) of its maps, over the pattern angle itself;
    noise: (KINDS,) in the units of `noise_weights.KINDS`.
    """

    device: Device
    coefficients: Array
    noise: Array

    def in_flight(self, angles: Array) -> tuple[Array, Array]:
        """(r, signals.COUNT, 3) coefficients, and (r, pattern_drift.TURNING, 3) rad/s of the bias
        that turns the pattern, from power-on angles (r, 3), rad."""
        each = [
            [
                (started_at(self.coefficients, a), turning(self.device, self.coefficients, a))
                for a in triad
            ]
            for triad in angles.tolist()
        ]
        maps, turns = (np.array([[gyro[i] for gyro in triad] for triad in each]) for i in (0, 1))
        return np.moveaxis(maps, 1, -1), np.moveaxis(turns, 1, -1)

    def flights(self, angles: Array) -> tuple[Flight, ...]:
        """Of three such gyros, from power-on angles (3,), rad."""
        return tuple(Flight(self.device, RISE, angle) for angle in angles.tolist())


def gyro(fmu: GyroFmu, device: Device) -> Gyro:
    """Read off the FMU `HRGSlow`.

    Raises:
        GyroError: values that the FMU refuses.
    """
    noise = np.array([getattr(device, name) for name in NOISES])
    return Gyro(device, coefficients(fmu, device, RISE), noise)
