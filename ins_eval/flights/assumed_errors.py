"""Errors of an IMU that the linear model assumes: effects with their standard deviations."""

import math
from collections.abc import Sequence
from dataclasses import dataclass
from itertools import compress

import numpy as np
from numpy.typing import ArrayLike

from ins_eval.common.sensor_errors import SensorErrors
from ins_eval.error_model.effects import (
    Effect,
    Sensor,
    accelerometer_bias,
    accelerometer_scale_factor,
    bias_map,
    gyro_bias,
    gyro_scale_factor,
    misalignment,
    pick_off_map,
)
from ins_eval.error_model.linear_model import AXES
from ins_eval.imu.gyros import FmuGyros
from ins_eval.imu.imu import Imu
from ins_eval.imu.map_sizes import MapSizes
from ins_eval.imu.sensor_error_model import IDEAL_SENSORS, OFF_DIAGONAL, SensorErrorModel
from pyhrg.common.arrays import Array
from pyhrg.noise.coefficients import compute_process_variance

SizedEffect = tuple[Effect, ArrayLike]
"""An effect and the standard deviation of its coefficient, of all axes or (3,) of each, SI."""
ASSUMED_FLICKER_TIMES = (1e1, 1e2, 1e3, 1e4, 1e5)
"""Correlation times of the Gauss-Markov processes whose sum approximates flicker noise, s. Chosen:
the Allan deviation of their sum is flat to 5 % from 100 s to 30 000 s (test_assumed_errors.py)."""


@dataclass(frozen=True)
class AssumedErrors:
    """Errors of an IMU that the linear model assumes.

    Attributes:
        effects: effects of the sensors.
        deviations: (e, 3) standard deviations of their coefficients, SI.
        noise: random walks.
    """

    effects: tuple[Effect, ...]
    deviations: Array
    noise: SensorErrors

    @property
    def constant(self) -> "AssumedErrors":
        """The assumed errors without effects that wander."""
        return self._keep([math.isinf(effect.correlation_time) for effect in self.effects])

    @property
    def without_gyros(self) -> "AssumedErrors":
        """The assumed errors without effects of gyros."""
        return self._keep([effect.sensor != "gyro" for effect in self.effects])

    def _keep(self, chosen: Sequence[bool]) -> "AssumedErrors":
        effects = tuple(compress(self.effects, chosen))
        return AssumedErrors(effects, self.deviations[list(chosen)], self.noise)


def assume_errors(imu: Imu) -> AssumedErrors:
    """Effects of an IMU whose constants nobody knows.

    A whole-angle gyro's bias and scale factor follow harmonics of its pattern angle, with cosine
    and sine of equal deviation: the same at every angle.
    """
    errors, force = imu.errors, imu.accelerometers
    gyro_process, force_process = (
        math.sqrt(compute_process_variance(coefficient))
        for coefficient in (errors.gyro_bias_instability, force.bias_instability)
    )
    sized = [
        *_list_gyro_effects(imu),
        *((gyro_bias(time), gyro_process) for time in ASSUMED_FLICKER_TIMES),
        (accelerometer_bias(), force.bias.sizes(AXES)),
        *((accelerometer_bias(time), force_process) for time in ASSUMED_FLICKER_TIMES),
        (accelerometer_scale_factor(), force.scale_factor.sizes(AXES)),
        *_size_misalignment("accelerometer", force, 0.0),
    ]
    sizes = [np.broadcast_to(np.asarray(size, dtype=float), AXES) for _, size in sized]
    kept = [number for number, size in enumerate(sizes) if np.any(size > 0)]
    return AssumedErrors(
        tuple(sized[number][0] for number in kept),
        np.array([sizes[number] for number in kept]).reshape(-1, AXES),
        errors,
    )


def _list_gyro_effects(imu: Imu) -> list[SizedEffect]:
    """Constant effects of the gyros with their deviations, of all axes or of each."""
    if isinstance(imu.gyros, FmuGyros):
        triad = IDEAL_SENSORS
        own = _list_map_effects(imu.gyros.map_sizes)
    else:
        triad = imu.gyros.error_model
        own = [
            (gyro_bias(), triad.bias.sizes(AXES)),
            (gyro_scale_factor(), triad.scale_factor.sizes(AXES)),
        ]
    return [*own, *_size_misalignment("gyro", triad, imu.mounting_deviation)]


def _list_map_effects(gyros: Sequence[MapSizes]) -> list[SizedEffect]:
    """Effects of whole-angle gyros; the variance is the same from every pattern angle on."""
    angle = np.zeros(AXES)
    (decay_time,) = {sizes.decay_time for sizes in gyros}
    biases = [
        (effect, [sizes.bias[harmonic] for sizes in gyros])
        for harmonic in gyros[0].bias
        for effect in bias_map(harmonic, angle)
    ]
    pick_offs = [
        (effect, [sizes.pick_off[harmonic] for sizes in gyros])
        for harmonic in gyros[0].pick_off
        for effect in pick_off_map(harmonic, angle, decay_time)
    ]
    return [
        (gyro_bias(), [sizes.mean for sizes in gyros]),
        (gyro_scale_factor(), [sizes.scale_factor for sizes in gyros]),
        *biases,
        *pick_offs,
    ]


def _size_misalignment(
    sensor: Sensor, triad: SensorErrorModel, mounting: float
) -> list[SizedEffect]:
    """Misalignments of each axis; `mounting` is the deviation of the input axes, rad."""
    six = np.hypot(triad.misalignment.sizes(2 * AXES), mounting)
    matrix = np.zeros((AXES, AXES))
    matrix[OFF_DIAGONAL] = six
    axes = np.arange(AXES)
    return [
        (effect, matrix[axes, (axes + shift) % AXES])
        for shift, effect in enumerate(misalignment(sensor), start=1)
    ]


def describe_assumption(imu: Imu) -> str:
    """What the one-sigma of an IMU leaves out, in words; empty where nothing."""
    if isinstance(imu.gyros, FmuGyros) and imu.gyros.is_swept:
        return (
            "1-sigma: by the linear model, as if the gyros did not sweep their pattern "
            "(sweep_angle_deg)"
        )
    return ""
