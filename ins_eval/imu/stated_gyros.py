"""Three gyros: what is asked of any kind, and those with the stated errors of a triad."""

from dataclasses import dataclass
from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from ins_eval.common.increments import Increments
from ins_eval.common.sensor_errors import SensorErrors
from ins_eval.imu.mounting import Mounting
from ins_eval.imu.triad import IDEAL, Triad

Array = NDArray[np.float64]


@dataclass(frozen=True)
class GyroReading:
    """rotation: (n, 3) increments about the input axes, rad; pattern_angle: (n, 3) at the end of
    each interval, rad, of gyros that have a pattern; ready: (n,) whether all three measure as they
    are meant to then, of gyros that start up."""

    rotation: Array
    pattern_angle: Array | None = None
    ready: NDArray[np.bool_] | None = None


class Gyros(Protocol):
    """Three gyros of some kind."""

    def measure(
        self, truth: Increments, mounting: Mounting, generator: np.random.Generator
    ) -> GyroReading:
        """What they make of the true motion."""

    def from_power_on(self) -> "Gyros":
        """The same, for a record that begins when they are switched on."""

    @property
    def errors(self) -> SensorErrors:
        """What a linear model should believe of one of them."""


@dataclass(frozen=True)
class StatedGyros:
    """Gyros with the errors of a triad; ideal by default. IMU studies with them need no FMU."""

    triad: Triad = IDEAL

    def measure(
        self, truth: Increments, mounting: Mounting, generator: np.random.Generator
    ) -> GyroReading:
        """See `Gyros`."""
        sensed = mounting.sensed(truth.rotation)
        return GyroReading(self.triad.measure(sensed, truth.interval, generator))

    def from_power_on(self) -> "StatedGyros":
        """They need no start."""
        return self

    @property
    def errors(self) -> SensorErrors:
        """See `Gyros`; scale factor and misalignment act with the manoeuvre and are left out."""
        return SensorErrors(
            gyro_bias=self.triad.bias.size,
            angle_random_walk=self.triad.white,
            gyro_bias_instability=self.triad.bias_instability,
            angle_quantum=self.triad.quantum,
        )


IDEAL_GYROS = StatedGyros()
