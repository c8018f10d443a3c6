"""Position error of a mission by the gyros' maps under a schedule, by the linear model.

The response of the position to a rate error in each second is computed once for a mission
(docs/methods/mission_model.md, Eq. 9). Under a schedule the maps become signals in time, whose
weighted sums are the weights of the maps' terms (docs/schedules.md, Eqs. 1 and 2).
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from ins_eval.error_model.effects import ANGULAR_GAIN
from ins_eval.error_model.linear_model import AXES
from ins_eval.mission_model.gyro_map import TERMS, evaluate_terms
from ins_eval.mission_model.mission_weights import STEP, linearize_mission
from ins_eval.mission_model.missions import SETTLING, STILL, StudyMission
from ins_eval.mission_model.noise_weights import compute_error_weights
from ins_eval.schedules.schedule import VERTICAL, Schedule, turn_into_case
from pyhrg.common.arrays import Array
from pyhrg.common.units import HOUR


@dataclass(frozen=True)
class MissionResponse:
    """Position error per sensor error in each of the n seconds since power-on.

    Attributes:
        weights: (2 k, n, 6) error north and east at the kept times, m, per mean rate error, rad/s,
            and per mean error of specific force, m/s^2, along the body axes; zero before the
            alignment.
        rate: (n, 3) mean true rate, rad/s.
    """

    weights: Array
    rate: Array


def compute_mission_response(mission: StudyMission) -> MissionResponse:
    """Response of a mission's position error."""
    trajectory = mission.trajectory()
    settling, aligning = round(SETTLING / STEP), round((STILL - SETTLING) / STEP)
    spacing, steps = round(mission.interval / STEP), round(mission.hours * HOUR / STEP)
    models = list(linearize_mission(trajectory, steps, ()))
    weights = compute_error_weights(
        np.concatenate([model.transition for model in models]),
        np.concatenate([model.constant_errors for model in models]),
        aligning + np.arange(spacing, steps + 1, spacing),
    )
    rotation = trajectory.increments(-STILL, STEP, settling + aligning + steps).rotation
    return MissionResponse(np.pad(weights, ((0, 0), (settling, 0), (0, 0))), rotation / STEP)


@dataclass(frozen=True)
class ScheduleWeights:
    """Position error of a mission under m schedules.

    Attributes:
        maps: (m, k, 2, 3 TERMS, 3) m per term of the maps of bias, of scale-factor error and of
            virtual rotation of each gyro, over the pattern's turn from where it starts.
        walk: (m, 3) mean square over the kept times, m^2, per squared angle random walk,
            rad^2/s, of each gyro.
        accelerometers: (m,) the same per squared bias of each accelerometer, (m/s^2)^2.
    """

    maps: Array
    walk: Array
    accelerometers: Array


def weigh_schedules(response: MissionResponse, schedules: Sequence[Schedule]) -> ScheduleWeights:
    """Weights of schedules, whose start angles do not matter to them."""
    parts = zip(*(_weigh(response, schedule) for schedule in schedules), strict=True)
    return ScheduleWeights(*(np.stack(part) for part in parts))


def _weigh(response: MissionResponse, schedule: Schedule) -> tuple[Array, Array, Array]:
    rows, n, _ = response.weights.shape
    bounds = STEP * np.arange(n + 1.0)
    middle = bounds[:-1] + STEP / 2
    case = schedule.case.angle(middle)
    rate = turn_into_case(response.rate, case)
    rate[:, VERTICAL] += np.diff(schedule.case.angle(bounds)) / STEP
    turned = STEP * (np.cumsum(rate, axis=0) - rate / 2)
    gyros, accelerometers = (
        turn_into_case(response.weights[..., kind].reshape(-1, AXES), np.tile(case, rows))
        for kind in (slice(0, AXES), slice(AXES, 2 * AXES))
    )
    maps = np.empty((rows, 3 * TERMS, AXES))
    for axis, command in enumerate(schedule.virtual_rotation):
        terms = evaluate_terms(ANGULAR_GAIN * (command.angle(middle) - turned[:, axis]))
        commanded = np.diff(command.angle(bounds)) / STEP
        signals = [terms, terms * rate[:, axis, None], terms * commanded[:, None]]
        maps[:, :, axis] = gyros[:, axis].reshape(rows, n) @ np.hstack(signals)
    times = rows // 2
    walk = np.square(gyros).sum(axis=0) / STEP / times
    bias = accelerometers.reshape(rows, n, AXES).sum(axis=1)
    power = np.asarray(np.square(bias).sum() / times)
    return maps.reshape(times, 2, 3 * TERMS, AXES), walk, power
