"""What the linear model assumes of an IMU: effects, and the standard deviations of each."""

import math
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from ins_eval.common.arrays import Array
from ins_eval.common.sensor_errors import SensorErrors
from ins_eval.error_model.effects import (
    Effect,
    Sensor,
    accelerometer_bias,
    accelerometer_scale_factor,
    bias_map,
    gyro_bias,
    gyro_scale_factor,
)
from ins_eval.error_model.linear_model import AXES
from ins_eval.error_model.motion import Motion
from ins_eval.imu.gyros import FmuGyros
from ins_eval.imu.imu import Imu
from ins_eval.imu.sensor_error_model import IDEAL_SENSORS
from ins_eval.imu.stated_gyros import StatedGyros
from pyhrg.noise.flicker import compute_process_variance

HARMONIC = 4
"""Harmonic of the pattern angle that a calibrated whole-angle gyro's bias mainly follows."""
ASSUMED_FLICKER_TIMES = (1e1, 1e2, 1e3, 1e4, 1e5)
"""Correlation times of the Gauss-Markov processes whose sum approximates flicker noise, s. Chosen:
the Allan deviation of their sum is flat to 5 % from 100 s to 30 000 s (test_assumed_errors.py)."""


@dataclass(frozen=True)
class AssumedErrors:
    """effects: of sensors; deviations: (e, 3) of their coefficients, SI; noise: random walks."""

    effects: tuple[Effect, ...]
    deviations: Array
    noise: SensorErrors

    @property
    def constant(self) -> "AssumedErrors":
        """The assumed errors without effects that wander."""
        stays = [i for i, effect in enumerate(self.effects) if math.isinf(effect.correlation_time)]
        return AssumedErrors(
            tuple(self.effects[i] for i in stays), self.deviations[stays], self.noise
        )


def assume_errors(imu: Imu, first_angle: Array | None = None) -> AssumedErrors:
    """Effects of an IMU whose constants nobody knows; variances do not depend on the first angle.

    A calibrated whole-angle gyro's bias is cosine and sine of four times its pattern angle, of
    equal deviation: the same at every angle.
    """
    errors, force = imu.errors, imu.accelerometers
    triad = imu.gyros.error_model if isinstance(imu.gyros, StatedGyros) else IDEAL_SENSORS
    crossed = math.hypot(triad.misalignment.size, imu.mounting_deviation)
    gyro_process, force_process = (
        math.sqrt(compute_process_variance(coefficient))
        for coefficient in (errors.gyro_bias_instability, force.bias_instability)
    )
    sized = [
        *((effect, errors.gyro_bias) for effect in _gyro_bias(imu, first_angle)),
        *((gyro_bias(time), gyro_process) for time in ASSUMED_FLICKER_TIMES),
        (gyro_scale_factor(), triad.scale_factor.size),
        *((effect, crossed) for effect in model_misalignment("gyro")),
        (accelerometer_bias(), force.bias.size),
        *((accelerometer_bias(time), force_process) for time in ASSUMED_FLICKER_TIMES),
        (accelerometer_scale_factor(), force.scale_factor.size),
        *((effect, force.misalignment.size) for effect in model_misalignment("accelerometer")),
    ]
    effects = tuple(effect for effect, size in sized if size > 0)
    sizes = np.array([size for _, size in sized if size > 0])
    return AssumedErrors(effects, np.tile(sizes[:, None], (1, AXES)), errors)


def model_misalignment(sensor: Sensor) -> tuple[Effect, Effect]:
    """What each axis feels of the next and of the one after it (Groves 2013, Eq. 4.16)."""

    def felt(shift: int) -> Callable[[Motion], Array]:
        def regressor(motion: Motion) -> Array:
            return np.roll(motion.rate if sensor == "gyro" else motion.force, -shift, axis=1)

        return regressor

    family = f"{sensor} misalignment"
    return (
        Effect(f"{family}, next axis", sensor, felt(1), family=family),
        Effect(f"{family}, axis after", sensor, felt(2), family=family),
    )


def _gyro_bias(imu: Imu, first_angle: Array | None) -> tuple[Effect, ...]:
    if isinstance(imu.gyros, FmuGyros) and imu.gyros.calibrated:
        return bias_map(HARMONIC, np.zeros(AXES) if first_angle is None else first_angle)
    return (gyro_bias(),)
