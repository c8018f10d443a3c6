"""How far each coefficient of a gyro's map carries the position in a mission: once for all devices.

With the pattern angle th = th0 - k Psi(t), Psi the true turn about the axis, the map's harmonics
are known signals along the mission; the linear error model, alignment included, makes of each its
error over time. What any device does is then a sum (`flown`).
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from ins_eval.error_model.aligning import alignment_model
from ins_eval.error_model.effects import Effect, accelerometer_bias
from ins_eval.error_model.linear_model import AXES, LinearModel, linear_model
from ins_eval.error_model.motion import Motion, along, step_mean
from ins_eval.error_model.states import ATTITUDE, COUNT
from ins_eval.mission_model import pattern_drift, signals
from ins_eval.mission_model.gyro_map import TERMS
from ins_eval.mission_model.missions import SETTLING, STILL, StudyMission
from ins_eval.mission_model.noise_weights import error_weights, noise_covariances
from ins_eval.mission_model.standing import Standing
from ins_eval.navigation.height import Clamped
from ins_eval.trajectories.trajectory import Trajectory

Array = NDArray[np.float64]

STEP = 1.0
"""Of the linear model, s."""
PIECE = 1200
"""Steps that are modelled at once: bounds memory."""


@dataclass(frozen=True)
class MissionWeights:
    """name; time: (k,) s since alignment;
    maps: (k, 2, COUNT, 3) error north and east, m, per coefficient of `signals`, started at pattern
    angle 0, of the gyro along each body axis;
    drift: (k, 2, pattern_drift.COUNT, 3) the same per product of `pattern_drift`;
    accelerometers: (k, 2, 3) m per m/s^2 of bias;
    noise: (KINDS, 3, 2 k, 2 k) covariance of the errors, m^2, north and east at each time in turn,
    per squared unit of each kind of noise (`noise_weights`) of each gyro;
    standing: the alignment, for what it does beyond first order.
    """

    name: str
    time: Array
    maps: Array
    drift: Array
    accelerometers: Array
    noise: Array
    standing: Standing

    @property
    def gyros(self) -> Array:
        """(k, 2, 2 TERMS, 3) of a `GyroMap` that stays as it is."""
        return self.maps[:, :, : 2 * TERMS]


def mission_weights(mission: StudyMission) -> MissionWeights:
    """Weights of a mission: half a minute for two hours."""
    trajectory = mission.trajectory()
    by = pattern_drift.swept(trajectory, -STILL, mission.hours * 3600)
    effects = [*signals.signal_effects(), *pattern_drift.drift_effects(by), accelerometer_bias()]
    aligning = round((STILL - SETTLING) / STEP)
    steps = round(mission.hours * 3600 / STEP)
    every = round(mission.kept / STEP)
    kept = aligning + np.arange(every, steps + 1, every)
    models = _models(trajectory, steps, effects)
    carried, transition, per_rate = _carried(models, len(effects), aligning, kept)
    by_coefficient, attitude = carried[:, :, :-AXES], carried[:, :, -AXES:]
    by_effect = by_coefficient.reshape(len(kept), 2, -1, AXES)
    weights = error_weights(transition, per_rate, kept)
    return MissionWeights(
        name=mission.name,
        time=mission.kept * np.arange(1.0, len(kept) + 1),
        maps=by_effect[:, :, : signals.COUNT],
        drift=by_effect[:, :, signals.COUNT : -1],
        accelerometers=by_effect[:, :, -1],
        noise=noise_covariances(weights, STEP, round(SETTLING / STEP)),
        standing=_standing(trajectory, effects[: signals.COUNT], attitude),
    )


def _models(trajectory: Trajectory, steps: int, effects: Sequence[Effect]) -> Iterator[LinearModel]:
    """Of the alignment, then of the flight in pieces."""
    standing = _at_rest(trajectory)
    yield alignment_model(standing, effects)
    turned = standing.turned[-1]
    for first in range(0, steps, PIECE):
        count = min(PIECE, steps - first)
        flying = _turned(along(trajectory, STEP * first, STEP, count), turned)
        turned = flying.turned[-1]
        yield linear_model(flying, Clamped(np.zeros(1)), effects)


def _at_rest(trajectory: Trajectory) -> Motion:
    """During the alignment; the case has turned with the Earth since power-on."""
    settled = trajectory.increments(-STILL, STEP, round(SETTLING / STEP))
    start = SETTLING - STILL
    return _turned(
        along(trajectory, start, STEP, round(-start / STEP)), settled.rotation.sum(axis=0)
    )


def _turned(motion: Motion, before: Array) -> Motion:
    return replace(motion, turned=motion.turned + before)


def _carried(
    models: Iterator[LinearModel], effects: int, aligning: int, kept: NDArray[np.int64]
) -> tuple[Array, Array, Array]:
    """(k, 2, e 3 + 3) error north and east after the kept steps, per constant coefficient, and
    per attitude error after the alignment; and the steps, of `error_weights`."""
    wanted = set(kept.tolist())
    carried, told, steps = np.zeros((COUNT, AXES * (effects + 1))), [], 0
    transition, per_rate = [], []
    for model in models:
        inputs = model.inputs.reshape(len(model), COUNT, -1)
        transition.append(model.transition)
        per_rate.append(model.constant_errors[:, :, :AXES])
        for step_transition, given in zip(model.transition, inputs, strict=True):
            carried = step_transition @ carried
            carried[:, :-AXES] += given
            steps += 1
            if steps == aligning:
                carried[ATTITUDE, -AXES:] = np.eye(AXES)
            if steps in wanted:
                told.append(carried[:2].copy())
    return np.stack(told), np.concatenate(transition), np.concatenate(per_rate)


def _standing(trajectory: Trajectory, effects: Sequence[Effect], attitude: Array) -> Standing:
    motion = _at_rest(trajectory)
    return Standing(
        latitude=float(motion.latitude[0]),
        height=float(motion.height[0]),
        mat_nb=motion.mat_nb[0],
        rates=np.stack([step_mean(effect.regressor(motion)).mean(axis=0) for effect in effects]),
        attitude=attitude,
    )
