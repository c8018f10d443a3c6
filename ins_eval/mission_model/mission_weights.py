"""Position error of a mission per unit of each gyro error, computed once for all devices.

The pattern angle follows the true turn about the gyro's axis, so that the harmonics of a map are
known signals along the mission. The linear error model, alignment included, gives the position
error of each over time (docs/methods/mission_model.md, Eq. 6). The error of any device is then a
weighted sum of its coefficients (`position_errors`).
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from ins_eval.error_model.dynamics import ATTITUDE, COUNT
from ins_eval.error_model.effects import Effect, accelerometer_bias, misalignment
from ins_eval.error_model.linear_model import AXES, LinearModel, linearize, model_alignment
from ins_eval.error_model.motion import Motion, sample_motion, step_mean
from ins_eval.mission_model import pattern_drift, signals
from ins_eval.mission_model.alignment_at_rest import AlignmentAtRest
from ins_eval.mission_model.gyro_map import TERMS
from ins_eval.mission_model.missions import SETTLING, STILL, StudyMission
from ins_eval.mission_model.noise_weights import compute_error_weights, compute_noise_covariances
from ins_eval.navigation.height import Clamped
from ins_eval.trajectories.trajectory import Trajectory
from pyhrg.common.arrays import Array

STEP = 1.0
"""Step of the linear model, s. Chosen."""
PIECE = 1200
"""Number of steps that are linearized at once; it bounds memory. Chosen."""


@dataclass(frozen=True)
class MissionWeights:
    """Position error north and east of a mission per unit of each sensor error.

    Attributes:
        name: name of the mission.
        time: (k,) s since alignment.
        maps: (k, 2, COUNT, 3) m per coefficient of `signals` of the gyro along each body axis,
            whose pattern starts at angle 0.
        drift: (k, 2, pattern_drift.COUNT, 3) m per product of `pattern_drift`.
        accelerometers: (k, 2, 3) m per m/s^2 of bias.
        mounting: (k, 2, 2, 3) m per rad by which the input axis along each body axis leans towards
            the next body axis, and towards the one after.
        noise: (4, 3, 2 k, 2 k) covariance of the errors, m^2, north and east at each time in turn,
            per squared unit of each kind of noise (`noise_weights`) of each gyro.
        alignment: the alignment, for its second-order error.
    """

    name: str
    time: Array
    maps: Array
    drift: Array
    accelerometers: Array
    mounting: Array
    noise: Array
    alignment: AlignmentAtRest

    @property
    def gyros(self) -> Array:
        """(k, 2, 2 TERMS, 3) weights of a map that is constant in flight."""
        return self.maps[:, :, : 2 * TERMS]


def compute_mission_weights(mission: StudyMission) -> MissionWeights:
    """Weights of a mission; takes half a minute for two hours."""
    trajectory = mission.trajectory()
    integrals = pattern_drift.integrate_turning_terms(trajectory, -STILL, mission.hours * 3600)
    effects = [
        *signals.list_signal_effects(),
        *pattern_drift.list_drift_effects(integrals),
        *misalignment("gyro"),
        accelerometer_bias(),
    ]
    aligning = round((STILL - SETTLING) / STEP)
    steps = round(mission.hours * 3600 / STEP)
    spacing = round(mission.interval / STEP)
    kept = aligning + np.arange(spacing, steps + 1, spacing)
    models = linearize_mission(trajectory, steps, effects)
    carried, transition, per_rate = _propagate(models, len(effects), aligning, kept)
    by_coefficient, attitude = carried[:, :, :-AXES], carried[:, :, -AXES:]
    by_effect = by_coefficient.reshape(len(kept), 2, -1, AXES)
    weights = compute_error_weights(transition, per_rate, kept)
    return MissionWeights(
        name=mission.name,
        time=mission.interval * np.arange(1.0, len(kept) + 1),
        maps=by_effect[:, :, : signals.COUNT],
        drift=by_effect[:, :, signals.COUNT : -3],
        mounting=by_effect[:, :, -3:-1],
        accelerometers=by_effect[:, :, -1],
        noise=compute_noise_covariances(weights, STEP, round(SETTLING / STEP)),
        alignment=_describe_alignment(trajectory, effects[: signals.COUNT], attitude),
    )


def linearize_mission(
    trajectory: Trajectory, steps: int, effects: Sequence[Effect]
) -> Iterator[LinearModel]:
    """Linear model of the alignment, then of the flight in pieces."""
    at_rest = _sample_alignment(trajectory)
    yield model_alignment(at_rest, effects)
    turned = at_rest.turned[-1]
    for first in range(0, steps, PIECE):
        count = min(PIECE, steps - first)
        flying = _add_turn(sample_motion(trajectory, STEP * first, STEP, count), turned)
        turned = flying.turned[-1]
        yield linearize(flying, Clamped(np.zeros(1)), effects)


def _sample_alignment(trajectory: Trajectory) -> Motion:
    """Motion during the alignment; the case has turned with the Earth since power-on."""
    settled = trajectory.increments(-STILL, STEP, round(SETTLING / STEP))
    start = SETTLING - STILL
    return _add_turn(
        sample_motion(trajectory, start, STEP, round(-start / STEP)), settled.rotation.sum(axis=0)
    )


def _add_turn(motion: Motion, before: Array) -> Motion:
    return replace(motion, turned=motion.turned + before)


def _propagate(
    models: Iterator[LinearModel], effects: int, aligning: int, kept: NDArray[np.int64]
) -> tuple[Array, Array, Array]:
    """Position errors by coefficient, and the matrices of all steps.

    Returns (k, 2, 3 effects + 3) error north and east after the kept steps, m, per coefficient and
    per attitude error after the alignment; transition matrices and errors per rate error of all
    steps, as `compute_error_weights` takes them.
    """
    kept_steps = set(kept.tolist())
    carried, position, steps = np.zeros((COUNT, AXES * (effects + 1))), [], 0
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
            if steps in kept_steps:
                position.append(carried[:2].copy())
    return np.stack(position), np.concatenate(transition), np.concatenate(per_rate)


def _describe_alignment(
    trajectory: Trajectory, effects: Sequence[Effect], attitude: Array
) -> AlignmentAtRest:
    motion = _sample_alignment(trajectory)
    return AlignmentAtRest(
        latitude=float(motion.latitude[0]),
        height=float(motion.height[0]),
        mat_nb=motion.mat_nb[0],
        rates=np.stack([step_mean(effect.regressor(motion)).mean(axis=0) for effect in effects]),
        attitude=attitude,
    )
