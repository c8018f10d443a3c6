"""Bias maps of the gyros by the coefficients of their effects."""

from dataclasses import dataclass

import numpy as np

from ins_eval.aided.kalman.sensors import SensorStates
from ins_eval.error_model.effects import ANGULAR_GAIN, Effect
from ins_eval.error_model.linear_model import AXES
from ins_eval.error_model.motion import Motion
from ins_eval.mission_model.gyro_map import HARMONICS, TERMS, evaluate_terms
from pyhrg.common.arrays import Array

ANGLES = np.pi * np.arange(64) / 64
"""Pattern angles at which a map is evaluated, rad; chosen: eight in a period of the eighth
harmonic."""

ROUNDING = 1e-9
"""Share of an effect's largest term below which a term is that of rounding. Chosen."""


@dataclass(frozen=True)
class BiasMap:
    """Bias at rest over the pattern angle, rad/s, in `mission_model.gyro_map.evaluate_terms`.

    coefficients: (3, TERMS) of the gyros; covariance: (3, TERMS, TERMS) of each; joint: (3 TERMS, 3
    TERMS) of all.
    """

    coefficients: Array
    joint: Array

    @property
    def covariance(self) -> Array:
        """(3, TERMS, TERMS) of each gyro's."""
        each = [slice(axis * TERMS, (axis + 1) * TERMS) for axis in range(AXES)]
        return np.stack([self.joint[own, own] for own in each])

    def evaluate(self, angle: Array) -> tuple[Array, Array]:
        """Bias (3, m) and its standard deviation (3, m) at pattern angles (m,), rad."""
        rows = evaluate_terms(angle)
        variance = np.einsum("mi,aij,mj->am", rows, self.covariance, rows)
        return self.coefficients @ rows.T, np.sqrt(np.maximum(variance, 0.0))

    def measure_amplitudes(self) -> tuple[Array, Array]:
        """(3, 4) amplitudes of `HARMONICS`, rad/s, and the standard deviation along each."""
        pairs = self.coefficients[:, 1:].reshape(AXES, len(HARMONICS), 2)
        size = np.linalg.norm(pairs, axis=-1)
        along = np.divide(
            pairs, size[..., None], out=np.full_like(pairs, 0.5**0.5), where=size[..., None] > 0
        )
        blocks = np.stack(
            [self.covariance[:, k : k + 2, k : k + 2] for k in range(1, TERMS, 2)], axis=1
        )
        variance = np.einsum("ahi,ahij,ahj->ah", along, blocks, along)
        return size, np.sqrt(np.maximum(variance, 0.0))


def read_bias_map(
    sensors: SensorStates, coefficients: Array, covariance: Array, time: float
) -> BiasMap:
    """The maps at a time, s, by coefficients (c,) and their covariance (c, c), without what wanders
    with a correlation time. The effects are of patterns that start at angle 0."""
    response = respond(sensors, time)[:, :TERMS]
    values = response @ coefficients
    joint = response.reshape(AXES * TERMS, -1)
    return BiasMap(values, joint @ covariance @ joint.T)


def respond(sensors: SensorStates, time: float) -> Array:
    """(3, 2 TERMS, c) terms of each gyro's map of bias, rad/s, then of scale-factor error, per unit
    of each coefficient."""
    count = len(ANGLES)
    project = np.linalg.pinv(evaluate_terms(ANGLES))

    def observe(effect: Effect, axis: int, rate: float) -> Array:
        """(TERMS,) error of a gyro whose case turns about its input axis."""
        none = np.zeros((count, AXES))
        moving = Motion(
            step=1e-6,
            start=time,
            latitude=none[:, 0],
            height=none[:, 0],
            velocity=none,
            mat_nb=np.zeros((count, AXES, AXES)),
            rate=none + rate * np.eye(AXES)[axis],
            force=none,
            turned=none - ANGLES[:, None] / ANGULAR_GAIN,
        )
        terms = project @ effect.regressor(moving)[:, axis]
        return np.where(np.abs(terms) > ROUNDING * np.max(np.abs(terms)), terms, 0.0)

    response = np.zeros((AXES, 2 * TERMS, len(sensors)))
    for number, effect in enumerate(sensors.effects):
        if effect.sensor == "gyro" and np.isinf(effect.correlation_time):
            for axis in range(AXES):
                resting, turning = (observe(effect, axis, rate) for rate in (0.0, 1.0))
                own = response[axis, :, AXES * number + axis]
                own[:TERMS], own[TERMS:] = resting, turning - resting
    return response
