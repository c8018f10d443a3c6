"""A device in flight: its maps, measured on the FMU, and its noise."""

from dataclasses import dataclass

import numpy as np

from ins_eval.mission_model.turned_maps import start_maps
from ins_eval.study.gyros.drift import Flight
from ins_eval.study.gyros.true_maps import compute_turning_bias, read_flight_coefficients
from pyhrg.common.arrays import Array
from pyhrg.device.device import Device
from pyhrg.fmu import GyroFmu
from pyhrg.noise.coefficients import COEFFICIENT_NAMES

CASE_RISE = 10.0
"""Final rise of the case's temperature above the reference temperature after power-on, K; the
resonator follows. Chosen."""


@dataclass(frozen=True)
class Gyro:
    """A device that warms by `CASE_RISE` in flight.

    coefficients: (signals.COUNT,) coefficients of its maps over the pattern angle itself;
    noise: (4,) its noise coefficients, SI, in the order of `COEFFICIENT_NAMES`.
    """

    device: Device
    coefficients: Array
    noise: Array

    def compute_flight_coefficients(self, angles: Array) -> tuple[Array, Array]:
        """Coefficients of r triads of such gyros over the turn since power-on.

        angles: (r, 3) power-on angles, rad.

        Returns (r, signals.COUNT, 3) coefficients of the maps, and (r, pattern_drift.TURNING_TERMS,
        3) bias that turns the pattern, rad/s.
        """
        maps = start_maps(np.repeat(self.coefficients[:, None], 3, axis=1), angles)
        turning = [
            [compute_turning_bias(self.device, self.coefficients, angle) for angle in triad]
            for triad in angles.tolist()
        ]
        return maps, np.moveaxis(np.array(turning), 1, -1)

    def make_flights(self, angles: Array) -> tuple[Flight, ...]:
        """Flights of three such gyros, from their power-on angles (3,), rad."""
        return tuple(Flight(self.device, CASE_RISE, angle) for angle in angles.tolist())


def measure_gyro(fmu: GyroFmu, device: Device) -> Gyro:
    """Measure a device's maps on the FMU `HRGSlow`."""
    noise = np.array([getattr(device, name) for name in COEFFICIENT_NAMES])
    return Gyro(device, read_flight_coefficients(fmu, device, CASE_RISE), noise)
