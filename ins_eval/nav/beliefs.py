"""What the linear model believes of an IMU: effects, and the standard deviations of each."""

import math
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ins_eval.error_model.effects import (
    Effect,
    Sensor,
    accelerometer_bias,
    accelerometer_scale_factor,
    bias_map,
    gyro_bias,
    gyro_scale_factor,
)
from ins_eval.error_model.motion import Motion
from ins_eval.imu.gyros import FmuGyros
from ins_eval.imu.imu import Imu
from ins_eval.imu.stated_gyros import StatedGyros
from ins_eval.imu.triad import IDEAL
from ins_eval.sensor_errors import SensorErrors

Array = NDArray[np.float64]

AXES = 3
HARMONIC = 4
"""Of the pattern angle, that a calibrated whole-angle gyro's bias mainly goes with."""


@dataclass(frozen=True)
class Beliefs:
    """effects: with constant coefficients; deviations: (e, 3) of them, SI; noise: random walks."""

    effects: tuple[Effect, ...]
    deviations: Array
    noise: SensorErrors


def beliefs(imu: Imu, first_angle: Array | None = None) -> Beliefs:
    """Of an IMU whose constants nobody knows.

    Args:
        imu: any.
        first_angle: (3,) pattern angles at the motion's start, rad; variances don't depend on them.

    Bias instability counts as constant. A calibrated whole-angle gyro's bias is cosine and sine of
    four times its pattern angle, of equal deviation: the same at every angle.
    """
    errors, force = imu.errors, imu.accelerometers
    gyro = math.hypot(errors.gyro_bias, errors.gyro_bias_instability)
    triad = imu.gyros.triad if isinstance(imu.gyros, StatedGyros) else IDEAL
    crossed = math.hypot(triad.misalignment.size, imu.mounting_deviation)
    of_gyros = [(effect, gyro) for effect in _gyro_bias(imu, first_angle)]
    of_gyros.append((gyro_scale_factor(), triad.scale_factor.size))
    of_gyros += [(effect, crossed) for effect in misalignment("gyro")]
    of_forces = [
        (accelerometer_bias(), math.hypot(force.bias.size, force.bias_instability)),
        (accelerometer_scale_factor(), force.scale_factor.size),
    ]
    of_forces += [(effect, force.misalignment.size) for effect in misalignment("accelerometer")]
    believed = [(effect, size) for effect, size in of_gyros + of_forces if size > 0]
    sizes = np.array([size for _, size in believed])
    effects = tuple(effect for effect, _ in believed)
    return Beliefs(effects, np.tile(sizes[:, None], (1, AXES)), errors)


def misalignment(sensor: Sensor) -> tuple[Effect, Effect]:
    """What each axis feels of the next and of the one after it (Groves 2013, Eq. 4.16)."""

    def felt(shift: int) -> Callable[[Motion], Array]:
        def regressor(motion: Motion) -> Array:
            return np.roll(motion.rate if sensor == "gyro" else motion.force, -shift, axis=1)

        return regressor

    family = f"{sensor} misalignment"
    return (
        Effect(f"{family}, next axis", sensor, "rad", felt(1), family=family),
        Effect(f"{family}, axis after", sensor, "rad", felt(2), family=family),
    )


def _gyro_bias(imu: Imu, first_angle: Array | None) -> tuple[Effect, ...]:
    if isinstance(imu.gyros, FmuGyros) and imu.gyros.calibrated:
        return bias_map(HARMONIC, np.zeros(AXES) if first_angle is None else first_angle)
    return (gyro_bias(),)
