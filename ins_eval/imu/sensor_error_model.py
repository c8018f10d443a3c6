"""Stated errors of three equal sensors: accelerometers, or gyros that are not simulated by an
FMU."""

from dataclasses import dataclass

import numpy as np

from pyhrg.common.arrays import Array
from pyhrg.common.units import MICRO_G
from pyhrg.noise.coefficients import draw_flicker


@dataclass(frozen=True)
class AxisConstants:
    """Constants of the axes, such as biases: a given part plus a random part.

    Attributes:
        value: given part, one number for all or one a constant.
        deviation: standard deviation of the random part, which is drawn anew for each unit.
    """

    value: tuple[float, ...] | float = 0.0
    deviation: float = 0.0

    def draw(self, shape: tuple[int, ...], generator: np.random.Generator) -> Array:
        """Draw the constants of one unit."""
        given = np.reshape(self.value, shape) if np.ndim(self.value) else self.value
        return np.asarray(given + generator.normal(0.0, self.deviation, size=shape))

    def sizes(self, count: int) -> Array:
        """Root mean square over units of each of `count` constants."""
        return np.hypot(self.deviation, np.broadcast_to(self.value, count))

    @property
    def size(self) -> float:
        """Root mean square over axes and units."""
        return float(np.hypot(self.deviation, np.sqrt(np.mean(np.square(self.value)))))


OFF_DIAGONAL = ~np.eye(3, dtype=bool)
"""Places of the misalignments in the (3, 3) matrix of sensitivities."""


@dataclass(frozen=True)
class SensorErrorModel:
    """Errors of three sensors along nearly the body axes; none by default. Terms of IEEE Std 528.

    With u the unit of the sensed quantity (m/s^2 or rad/s):

    Attributes:
        bias: constant bias, u.
        scale_factor: relative error.
        misalignment: six sensitivities, rad: of x to y and z, of y to x and z, of z to x and y
            (Groves 2013, Eq. 4.16).
        random_walk: coefficient N of the angle or velocity random walk, u sqrt(s).
        bias_instability: coefficient B of IEEE Std 952, u; the Allan deviation's floor is 0.664 B.
        quantization_step: one count of the summed increments, u s; 0 is none.
    """

    bias: AxisConstants = AxisConstants()
    scale_factor: AxisConstants = AxisConstants()
    misalignment: AxisConstants = AxisConstants()
    random_walk: float = 0.0
    bias_instability: float = 0.0
    quantization_step: float = 0.0

    def measure(self, truth: Array, interval: float, generator: np.random.Generator) -> Array:
        """Add the errors of one unit, drawn at random, to true increments (n, 3) over equal
        intervals, s.

        Errors that are 0 use up as many random numbers as others, except bias instability. Models
        with the same seed therefore share the errors that they have in common.
        """
        bias, noise, sensitivity = self.draw(truth.shape, generator)
        increments = truth @ sensitivity.T
        increments = increments + bias * interval + noise * np.sqrt(interval)
        if self.bias_instability:
            increments += interval * draw_flicker(self.bias_instability, truth.shape, generator)
        return (
            quantize(increments, self.quantization_step) if self.quantization_step else increments
        )

    def draw(
        self, shape: tuple[int, ...], generator: np.random.Generator
    ) -> tuple[Array, Array, Array]:
        """Draw one unit: bias (3,), white noise of increments of this shape over the root of their
        interval, and the matrix (3, 3) from true to sensed quantities."""
        bias = self.bias.draw((3,), generator)
        noise = generator.normal(0.0, self.random_walk, size=shape)
        sensitivity = np.diag(1.0 + self.scale_factor.draw((3,), generator))
        sensitivity[OFF_DIAGONAL] = self.misalignment.draw((6,), generator)
        return bias, noise, sensitivity


IDEAL_SENSORS = SensorErrorModel()
TYPICAL_ACCELEROMETERS = SensorErrorModel(
    bias=AxisConstants(deviation=5 * MICRO_G), random_walk=5 * MICRO_G
)
"""Bias 5 micro-g, noise 5 micro-g/sqrt(Hz). Chosen so that a gyro bias of 0.001 deg/h still shows
in the position error."""


def quantize(increments: Array, quantization_step: float) -> Array:
    """Round increments (n, ...) to whole counts; remainders are carried over to the next interval,
    so that the error of the sum never exceeds half a count."""
    counts = np.rint(np.cumsum(increments, axis=0) / quantization_step)
    return np.asarray(quantization_step * np.diff(counts, axis=0, prepend=0.0))
