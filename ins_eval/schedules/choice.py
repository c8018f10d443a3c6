"""The schedule of a family that makes a mission's position error least, by the linear model.

The criterion is the expected mean square of the horizontal error over the kept times: by the maps
that the bench measured, by what it leaves uncertain, by the scatter of the start angles, by the
angle random walk and by the accelerometers' biases (docs/schedules.md, Eqs. 3 and 4). Errors of the
gyros add, so that their commands are chosen together.
"""

from collections.abc import Sequence
from dataclasses import dataclass, field

import numpy as np

from ins_eval.error_model.linear_model import AXES
from ins_eval.imu.sensor_error_model import TYPICAL_ACCELEROMETERS
from ins_eval.mission_model.gyro_map import turn_weights
from ins_eval.schedules.families import Family
from ins_eval.schedules.knowledge import KnownGyro
from ins_eval.schedules.schedule import Schedule
from ins_eval.schedules.weights import MissionResponse, ScheduleWeights, weigh_schedules
from pyhrg.common.arrays import Array

NODES, NODE_WEIGHTS = np.array([-np.sqrt(3.0), 0.0, np.sqrt(3.0)]), np.array([1.0, 4.0, 1.0]) / 6
"""Nodes, in standard deviations, and weights of a normal distribution (Gauss and Hermite)."""
UNKNOWN_STARTS = np.arange(0.0, np.pi, np.pi / 24)
"""Start angles that count alike where a gyro's own is not known, rad. Chosen: they average the
harmonics up to 8 and their squares."""


@dataclass(frozen=True)
class GyroError:
    """Position error by one gyro under m commands: (m, 2 k) mean, m; (m,) mean square over the kept
    times of what scatters about it, m^2."""

    mean: Array
    scatter: Array


@dataclass(frozen=True)
class Prediction:
    """Position error of a triad under a schedule.

    Attributes:
        schedule: the schedule.
        mean: (k, 2) north and east, m, by the maps that the bench measured.
        rms: root of the expected mean square of the horizontal error over the kept times, m, by
            all that counts.
    """

    schedule: Schedule
    mean: Array
    rms: float


@dataclass(frozen=True)
class Planner:
    """A mission, by which schedules are chosen; it keeps the weights of families for all triads."""

    response: MissionResponse
    _weights: dict[str, ScheduleWeights] = field(default_factory=dict)

    def weigh(self, family: Family) -> ScheduleWeights:
        """Weights of a family's motions."""
        if family.name not in self._weights:
            self._weights[family.name] = weigh_schedules(self.response, family.motions)
        return self._weights[family.name]

    def choose(self, family: Family, gyros: Sequence[KnownGyro]) -> Prediction:
        """The best schedule of a family for the three gyros of a triad."""
        weights = self.weigh(family)
        errors = [
            _predict_gyro(weights, family.motions, axis, gyro, family.starts[axis])
            for axis, gyro in enumerate(gyros)
        ]
        return self.predict(family.compose(_find_least(family, errors, weights)), gyros)

    def predict(self, schedule: Schedule, gyros: Sequence[KnownGyro]) -> Prediction:
        """The position error of a triad under a schedule."""
        weights = weigh_schedules(self.response, [schedule])
        errors = [
            _predict_gyro(weights, [schedule], axis, gyro, [start])
            for axis, (gyro, start) in enumerate(zip(gyros, schedule.start_angles, strict=True))
        ]
        mean = np.sum([error.mean[0] for error in errors], axis=0)
        times = len(mean) // 2
        scatter = sum(float(error.scatter[0]) for error in errors) + _accelerometers(weights)[0]
        total = float(np.square(mean).sum()) / times + scatter
        return Prediction(schedule, mean.reshape(times, 2), float(np.sqrt(total)))


def _predict_gyro(
    weights: ScheduleWeights,
    motions: Sequence[Schedule],
    axis: int,
    gyro: KnownGyro,
    starts: Sequence[float | None],
) -> GyroError:
    """Errors by the gyro along an axis, for every motion with every start angle."""
    maps = weights.maps[:, None, None, ..., axis : axis + 1]
    angles, shares = _list_start_angles(gyro, starts)
    turned = turn_weights(maps, angles[..., None])[..., 0]
    takes_mean = np.array([motion.takes_mean[axis] for motion in motions])[:, None, None]
    taken_out = np.where(takes_mean, gyro.values[0], gyro.evaluate_bias(angles))
    every = turned @ gyro.values - turned[..., 0] * taken_out[..., None, None]
    times = every.shape[-2]
    flat = every.reshape(*every.shape[:3], 2 * times)
    mean = np.einsum("q,msqi->msi", shares, flat)
    spread = np.einsum("q,msqi->ms", shares, flat**2) - np.square(mean).sum(axis=-1)
    unknown = np.einsum("q,msqkic,c->ms", shares, turned**2, gyro.variances)
    rotation = np.array([motion.virtual_rotation[axis].rate for motion in motions])
    power = gyro.random_walk**2 + (gyro.rotation_noise * rotation) ** 2
    scatter = (spread + unknown) / times + (weights.walk[:, axis] * power)[:, None]
    return GyroError(mean.reshape(-1, 2 * times), scatter.ravel())


def _list_start_angles(gyro: KnownGyro, starts: Sequence[float | None]) -> tuple[Array, Array]:
    """(s, q) angles, rad, about each start angle, and (q,) their shares."""
    own = [gyro.start if start is None else start for start in starts]
    if None in own:
        return np.tile(UNKNOWN_STARTS, (len(own), 1)), np.full(len(UNKNOWN_STARTS), 1 / 24)
    return np.array(own, dtype=float)[:, None] + gyro.scatter * NODES, NODE_WEIGHTS


def _accelerometers(weights: ScheduleWeights) -> Array:
    """(m,) mean square of the error by accelerometer biases, m^2."""
    deviation = float(np.max(TYPICAL_ACCELEROMETERS.bias.deviation))
    return weights.accelerometers * deviation**2


def _find_least(
    family: Family, errors: Sequence[GyroError], weights: ScheduleWeights
) -> tuple[int, ...]:
    """Candidates (`Family.counts`) with the least mean square."""
    times = errors[0].mean.shape[-1] // 2
    if family.is_joint:
        mean = sum(error.mean for error in errors)
        scatter = sum(error.scatter for error in errors) + _accelerometers(weights)
        return (int(np.argmin(np.square(mean).sum(axis=-1) / times + scatter)),)
    total = np.zeros(family.counts)
    for i, error in enumerate(errors):
        alone = np.square(error.mean).sum(axis=-1) / times + error.scatter
        total += _spread_over(alone, i)
        for j in range(i + 1, len(errors)):
            both = 2 * error.mean @ errors[j].mean.T / times
            total += np.expand_dims(both, AXES - i - j)
    return tuple(int(at) for at in np.unravel_index(np.argmin(total), total.shape))


def _spread_over(values: Array, axis: int) -> Array:
    """Values (m,) of one gyro's candidates, as an array over those of all."""
    return np.expand_dims(values, tuple(other for other in range(AXES) if other != axis))
