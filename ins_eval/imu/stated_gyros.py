"""Three gyros that are simulated by their stated errors."""

from dataclasses import dataclass

import numpy as np

from ins_eval.common.sensor_errors import SensorErrors
from ins_eval.imu.mounting import Mounting
from ins_eval.imu.sensor_error_model import IDEAL_SENSORS, SensorErrorModel
from pyhrg.common.arrays import Array, Mask
from pyhrg.records.imu.log import Increments


@dataclass(frozen=True)
class GyroReading:
    """Output of three gyros.

    Attributes:
        rotation: (n, 3) increments about the input axes, rad.
        pattern_angle: (n, 3) at the end of each interval, rad, None for gyros without a pattern.
        ready: (n,) whether all three are ready at that time, None for gyros without start-up.
    """

    rotation: Array
    pattern_angle: Array | None = None
    ready: Mask | None = None


@dataclass(frozen=True)
class StatedGyros:
    """Gyros with stated errors, none by default; they need no FMU."""

    error_model: SensorErrorModel = IDEAL_SENSORS

    def measure(
        self, truth: Increments, mounting: Mounting, generator: np.random.Generator
    ) -> GyroReading:
        """Simulate the gyros on the true motion."""
        components = mounting.project(truth.rotation)
        return GyroReading(self.error_model.measure(components, truth.interval, generator))

    @property
    def errors(self) -> SensorErrors:
        """Sensor errors of one gyro that a linear model should assume. Scale factor and
        misalignment are left out: they depend on the manoeuvre."""
        return SensorErrors(
            gyro_bias=self.error_model.bias.size,
            angle_random_walk=self.error_model.random_walk,
            gyro_bias_instability=self.error_model.bias_instability,
            angle_quantization_step=self.error_model.quantization_step,
        )


IDEAL_GYROS = StatedGyros()
