"""States of the sensors: coefficients of effects, with what is known of them before a drive."""

from dataclasses import dataclass, replace

import numpy as np

from ins_eval.error_model.effects import Effect
from ins_eval.error_model.linear_model import AXES
from pyhrg.common.arrays import Array


@dataclass(frozen=True)
class SensorStates:
    """c = 3 e coefficients of e effects, effect by effect, three axes each.

    effects: of gyros and accelerometers; deviations: (e, 3) of the coefficients, SI, at the
    beginning, and always where an effect has a correlation time; walks: (e, 3) density of a random
    walk of the coefficients, SI per root of s; noise: (6,) coefficient N of the angle random walk
    of each gyro, rad/sqrt(s), and of the velocity random walk of each accelerometer,
    m/s/sqrt(s); expected: (c,) mean of the coefficients at the beginning, zero if None; joint: (c,
    c) covariance of the coefficients at the beginning, where they are not independent.
    """

    effects: tuple[Effect, ...]
    deviations: Array
    walks: Array
    noise: Array
    expected: Array | None = None
    joint: Array | None = None

    @property
    def mean(self) -> Array:
        """(c,) of the coefficients at the beginning."""
        return np.zeros(len(self)) if self.expected is None else self.expected

    @property
    def covariance(self) -> Array:
        """(c, c) of the coefficients at the beginning."""
        return np.diag(np.ravel(self.deviations) ** 2) if self.joint is None else self.joint

    def __len__(self) -> int:
        return AXES * len(self.effects)

    def list_persistence(self, step: float) -> Array:
        """(c,) correlation of each coefficient over a step, s."""
        times = np.array([effect.correlation_time for effect in self.effects])
        return np.repeat(np.exp(-step / times), AXES)

    def list_driving_variance(self, step: float) -> Array:
        """(c,) variance that a step, s, adds to each coefficient."""
        wandering = np.ravel(self.deviations) ** 2 * (1 - self.list_persistence(step) ** 2)
        return np.asarray(wandering + step * np.ravel(self.walks) ** 2)

    def condition(self, response: Array, values: Array, variances: Array) -> "SensorStates":
        """The states after measurements (m,) at the beginning, of independent errors of variances
        (m,), of what coefficients make by a response (m, c)."""
        carried = self.covariance @ response.T
        spread = response @ carried + np.diag(variances)
        scale = 1 / np.sqrt(np.diag(spread))
        gain = carried * scale @ np.linalg.inv(spread * np.outer(scale, scale)) * scale
        mean = self.mean + gain @ (values - response @ self.mean)
        kept = np.eye(len(self)) - gain @ response
        joint = kept @ self.covariance @ kept.T + gain * variances @ gain.T
        return replace(self, expected=mean, joint=0.5 * (joint + joint.T))
