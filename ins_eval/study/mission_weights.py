"""How far each coefficient of a gyro's map carries the position in a mission: once for all devices.

With the pattern angle th = th0 - k Psi(t), Psi the true turn about the axis, the map's harmonics
are known signals along the mission; the linear error model, alignment included, makes of each its
error over time. What any device does is then a sum (`flown`).
"""

from collections.abc import Iterator
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from ins_eval.error_model.aligning import alignment_model
from ins_eval.error_model.effects import (
    Effect,
    accelerometer_bias,
    bias_map,
    gyro_bias,
    gyro_scale_factor,
    pick_off_map,
)
from ins_eval.error_model.linear_model import AXES, LinearModel, linear_model
from ins_eval.error_model.motion import Motion, along, step_mean
from ins_eval.error_model.states import ATTITUDE, COUNT
from ins_eval.navigation.height import Clamped
from ins_eval.study.gyro_map import HARMONICS, TERMS
from ins_eval.study.missions import SETTLING, STILL, StudyMission
from ins_eval.study.noise_weights import error_weights, noise_covariances
from ins_eval.study.standing import Standing
from ins_eval.study.warming import angle_errors, growing
from ins_eval.trajectories.trajectory import Trajectory

Array = NDArray[np.float64]

STEP = 1.0
"""Of the linear model, s."""
PIECE = 3600
"""Steps that are modelled at once: bounds memory."""


@dataclass(frozen=True)
class MissionWeights:
    """name; time: (k,) s since alignment;
    gyros: (k, 2, 2 TERMS, 3) error north and east, m, per coefficient of `GyroMap`, started at
    pattern angle 0, of the gyro along each body axis;
    warming, curving: the same for coefficients that grow with warmth and its square (`warming`);
    accelerometers: (k, 2, 3) m per m/s^2 of bias;
    noise: (KINDS, 3, 2 k, 2 k) covariance of the errors, m^2, north and east at each time in turn,
    per squared unit of each kind of noise (`noise_weights`) of each gyro;
    standing: the alignment, for what it does beyond first order.
    """

    name: str
    time: Array
    gyros: Array
    warming: Array
    curving: Array
    accelerometers: Array
    noise: Array
    standing: Standing


def mission_weights(mission: StudyMission) -> MissionWeights:
    """Weights of a mission: about 10 s for two hours."""
    trajectory = mission.trajectory()
    aligning = round((STILL - SETTLING) / STEP)
    steps = round(mission.hours * 3600 / STEP)
    every = round(mission.kept / STEP)
    kept = aligning + np.arange(every, steps + 1, every)
    carried, transition, per_rate = _carried(_models(trajectory, steps), aligning, kept)
    half = 2 * TERMS
    by_coefficient, attitude = carried[:, :, :-AXES], carried[:, :, -AXES:]
    effects = by_coefficient.reshape(len(kept), 2, -1, AXES)
    weights = error_weights(transition, per_rate, kept)
    return MissionWeights(
        name=mission.name,
        time=mission.kept * np.arange(1.0, len(kept) + 1),
        gyros=effects[:, :, :half],
        warming=effects[:, :, half : 2 * half],
        curving=effects[:, :, 2 * half : 3 * half],
        accelerometers=effects[:, :, -1],
        noise=noise_covariances(weights, STEP, round(SETTLING / STEP)),
        standing=_standing(trajectory, attitude),
    )


def _models(trajectory: Trajectory, steps: int) -> Iterator[LinearModel]:
    """Of the alignment, then of the flight in pieces."""
    standing = _at_rest(trajectory)
    yield alignment_model(standing, EFFECTS)
    turned = standing.turned[-1]
    for first in range(0, steps, PIECE):
        count = min(PIECE, steps - first)
        flying = _turned(along(trajectory, STEP * first, STEP, count), turned)
        turned = flying.turned[-1]
        yield linear_model(flying, Clamped(np.zeros(1)), EFFECTS)


def _at_rest(trajectory: Trajectory) -> Motion:
    """During the alignment; the case has turned with the Earth since power-on."""
    settled = trajectory.increments(-STILL, STEP, round(SETTLING / STEP))
    start = SETTLING - STILL
    return _turned(
        along(trajectory, start, STEP, round(-start / STEP)), settled.rotation.sum(axis=0)
    )


def _turned(motion: Motion, before: Array) -> Motion:
    return replace(motion, turned=motion.turned + before)


def _effects() -> list[Effect]:
    """Those of `GyroMap`, in its order; those again, growing with warmth; accelerometers."""
    zero = np.zeros(AXES)
    bias = [gyro_bias(), *(e for h in HARMONICS for e in bias_map(h, zero))]
    scale = [gyro_scale_factor(), *(e for h in HARMONICS for e in pick_off_map(h, zero))]
    assert len(bias) == len(scale) == TERMS
    moving = [None] * (TERMS + 1) + angle_errors(zero)
    warming = [
        growing(effect, power, angle_error)
        for power in (1, 2)
        for effect, angle_error in zip((*bias, *scale), moving, strict=True)
    ]
    return [*bias, *scale, *warming, accelerometer_bias()]


EFFECTS = _effects()


def _carried(
    models: Iterator[LinearModel], aligning: int, kept: NDArray[np.int64]
) -> tuple[Array, Array, Array]:
    """(k, 2, e 3 + 3) error north and east after the kept steps, per constant coefficient, and
    per attitude error after the alignment; and the steps, of `error_weights`."""
    wanted = set(kept.tolist())
    carried, told, steps = np.zeros((COUNT, AXES * (len(EFFECTS) + 1))), [], 0
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


def _standing(trajectory: Trajectory, attitude: Array) -> Standing:
    motion = _at_rest(trajectory)
    means = [step_mean(effect.regressor(motion)).mean(axis=0) for effect in EFFECTS[:-1]]
    half = 2 * TERMS
    return Standing(
        latitude=float(motion.latitude[0]),
        height=float(motion.height[0]),
        mat_nb=motion.mat_nb[0],
        started=np.stack(means[:half]),
        warming=np.stack(means[half : 2 * half]),
        curving=np.stack(means[2 * half :]),
        attitude=attitude,
    )
