"""The simulated inertial measurement unit: three gyros and three accelerometers."""

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from ins_eval.common.sensor_errors import SensorErrors
from ins_eval.imu.gyros import FmuGyros
from ins_eval.imu.mounting import ORTHOGONAL, Mounting
from ins_eval.imu.sensor_error_model import IDEAL_SENSORS, SensorErrorModel
from ins_eval.imu.stated_gyros import IDEAL_GYROS, StatedGyros
from pyhrg.common.arrays import Mask
from pyhrg.common.errors import HrgError, describe_briefly
from pyhrg.common.units import STANDARD_GRAVITY
from pyhrg.records.imu.log import Increments


@dataclass(frozen=True)
class ImuReading:
    """Output of an IMU.

    Attributes:
        increments: increments in body axes.
        pattern_angle: (n, 3) pattern angle of each gyro at the end of each interval, rad; None for
            gyros without a pattern.
        ready: (n,) whether all gyros are ready at that time, None for gyros without start-up.
    """

    increments: Increments
    pattern_angle: NDArray[np.float64] | None
    ready: Mask | None = None


@dataclass(frozen=True)
class Imu:
    """An inertial measurement unit; by default an ideal one.

    Attributes:
        gyros, accelerometers: the sensors.
        interval: length of an increment, s.
        mounting: input axes of the gyros, true and as the navigator assumes them.
        mounting_deviation: standard deviation of each input axis' error, in each of two directions,
            rad.
        name: name in reports.
    """

    gyros: FmuGyros | StatedGyros = IDEAL_GYROS
    accelerometers: SensorErrorModel = IDEAL_SENSORS
    interval: float = 0.01
    mounting: Mounting = ORTHOGONAL
    mounting_deviation: float = 0.0
    name: str = ""

    __repr__ = describe_briefly

    def measure(self, truth: Increments, seed: int | np.random.SeedSequence) -> ImuReading:
        """Simulate one unit, drawn at random, on the true motion.

        Args:
            truth: true increments, at the unit's interval.
            seed: seed of all random draws; the same seed gives the same bytes.

        Raises:
            HrgError: increments at another interval; see also `FmuGyros.measure`.
        """
        if abs(truth.interval / self.interval - 1) > 1e-9:
            raise HrgError(
                f"found increments over {truth.interval:g} s, expected {self.interval:g} s"
            )
        generator = np.random.default_rng(seed)
        mounting, _ = self.draw_mounting(seed)
        reading = self.gyros.measure(truth, mounting, generator)
        velocity = self.accelerometers.measure(truth.velocity, truth.interval, generator)
        increments = Increments(
            truth.interval, mounting.decode(reading.rotation), velocity, truth.start
        )
        return ImuReading(increments, reading.pattern_angle, reading.ready)

    def draw_mounting(
        self, seed: int | np.random.SeedSequence
    ) -> tuple[Mounting, np.random.Generator]:
        """Draw the mounting of a seed's unit by a generator independent of the sensors'. Return
        both."""
        aside = np.random.Generator(np.random.PCG64(seed).jumped())
        return self.mounting.disturb(self.mounting_deviation, aside), aside

    def from_power_on(self) -> "Imu":
        """Return the same IMU for a record that begins when it is switched on."""
        if not isinstance(self.gyros, FmuGyros):
            return self
        return replace(self, gyros=replace(self.gyros, start_up=True))

    @property
    def errors(self) -> SensorErrors:
        """Sensor errors that a linear model should assume.

        The misalignment of an accelerometer to the vertical counts as bias, as it does while the
        vehicle is level. Scale factors and misalignments of gyros are left out, because their
        effect depends on the manoeuvre.
        """
        force = self.accelerometers
        tilt = STANDARD_GRAVITY * force.misalignment.size
        return replace(
            self.gyros.errors,
            accelerometer_bias=float(np.hypot(force.bias.size, tilt)),
            velocity_random_walk=force.random_walk,
            accelerometer_bias_instability=force.bias_instability,
            velocity_quantization_step=force.quantization_step,
        )
