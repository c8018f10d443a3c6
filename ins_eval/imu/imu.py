"""The inertial measurement unit: three gyros, three accelerometers."""

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from ins_eval.common.increments import Increments
from ins_eval.common.sensor_errors import SensorErrors
from ins_eval.imu.mounting import ORTHOGONAL, Mounting
from ins_eval.imu.stated_gyros import IDEAL_GYROS, Gyros
from ins_eval.imu.triad import IDEAL, Triad
from pyhrg.common.errors import HrgError
from pyhrg.common.units import STANDARD_GRAVITY


class StartUpError(HrgError):
    """Gyros aren't ready when they are needed."""


@dataclass(frozen=True)
class Measured:
    """increments: body axes; pattern_angle: (n, 3) of the gyros at the end of each interval, rad,
    if they have a pattern; ready: (n,) whether all gyros measure as they are meant to then, if they
    start up."""

    increments: Increments
    pattern_angle: NDArray[np.float64] | None
    ready: NDArray[np.bool_] | None = None


@dataclass(frozen=True)
class Imu:
    """An inertial measurement unit; ideal by default.

    gyros, accelerometers: what it is made of;
    interval: of its increments, s;
    mounting: of the gyros' input axes, as the navigator believes it;
    mounting_deviation: standard deviation of what it doesn't know, of each axis in two directions,
    rad.
    """

    gyros: Gyros = IDEAL_GYROS
    accelerometers: Triad = IDEAL
    interval: float = 0.01
    mounting: Mounting = ORTHOGONAL
    mounting_deviation: float = 0.0
    name: str = ""

    def measure(self, truth: Increments, seed: int | np.random.SeedSequence) -> Measured:
        """What one such unit makes of the true motion.

        Args:
            truth: true increments, at the unit's interval.
            seed: of everything that is drawn; the same seed gives the same bytes.

        Raises:
            ValueError: increments at another interval.
            GyroError: see `FmuGyros.measure`.
        """
        if abs(truth.interval / self.interval - 1) > 1e-9:
            raise ValueError(
                f"found increments over {truth.interval:g} s, expected {self.interval:g} s"
            )
        generator = np.random.default_rng(seed)
        aside = np.random.Generator(np.random.PCG64(seed).jumped())
        mounting = self.mounting.disturbed(self.mounting_deviation, aside)
        reading = self.gyros.measure(truth, mounting, generator)
        velocity = self.accelerometers.measure(truth.velocity, truth.interval, generator)
        increments = Increments(
            truth.interval, mounting.decoded(reading.rotation), velocity, truth.start
        )
        return Measured(increments, reading.pattern_angle, reading.ready)

    def from_power_on(self) -> "Imu":
        """The same, for a record that begins when it is switched on."""
        return replace(self, gyros=self.gyros.from_power_on())

    @property
    def errors(self) -> SensorErrors:
        """What a linear model should believe.

        An accelerometer's misalignment to the vertical is a bias while the vehicle is level. Scale
        factors, and misalignments of gyros, act with the manoeuvre and are left out.
        """
        force = self.accelerometers
        tilt = STANDARD_GRAVITY * force.misalignment.size
        return replace(
            self.gyros.errors,
            accelerometer_bias=float(np.hypot(force.bias.size, tilt)),
            velocity_random_walk=force.white,
            accelerometer_bias_instability=force.bias_instability,
            velocity_quantum=force.quantum,
        )
