"""A triad flown under a schedule: three FMUs in a case that turns, and the navigator."""

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from ins_eval.error_model.linear_model import AXES
from ins_eval.imu.gyros import GyroOutput, resolve_force_in_case, simulate_together
from ins_eval.mission_model.missions import STILL
from ins_eval.schedules.knowledge import KnownGyro
from ins_eval.schedules.schedule import VERTICAL, Schedule, Sweep, turn_into_case
from ins_eval.study.cosimulated import MissionTruth, align_and_navigate
from pyhrg.bench.bench import Bench
from pyhrg.common.arrays import Array
from pyhrg.records.imu.log import Increments


@dataclass(frozen=True)
class TriadFlight:
    """Outputs of a triad under a schedule.

    Attributes:
        schedule: the schedule.
        outputs: of the three gyros, along the axes of the case.
        velocity: (n, 3) increments of the accelerometers along these, m/s.
    """

    schedule: Schedule
    outputs: Sequence[GyroOutput]
    velocity: Array

    def navigate(self, truth: MissionTruth, gyros: Sequence[KnownGyro]) -> Array:
        """(k, 2) error north and east, m, of a navigator that knows the angle of the case."""
        true = truth.increments
        rotation = np.stack([output.rotation for output in self.outputs], axis=1)
        for axis, (gyro, output) in enumerate(zip(gyros, self.outputs, strict=True)):
            at_start = float(gyro.evaluate_bias(output.pattern_angle[0]))
            known = float(gyro.values[0]) if self.schedule.takes_mean[axis] else at_start
            rotation[:, axis] -= known * true.interval
        rotation[:, VERTICAL] -= list_steps(self.schedule.case, true)
        back = -find_case_angle(self.schedule, true)
        return align_and_navigate(
            truth,
            replace(
                true,
                rotation=turn_into_case(rotation, back),
                velocity=turn_into_case(self.velocity, back),
            ),
        )


def fly_schedules(
    benches: Sequence[Bench],
    truth: MissionTruth,
    schedules: Sequence[Schedule],
    accelerometers: Array,
) -> list[TriadFlight]:
    """A triad under each schedule, with the same noise of the gyros.

    accelerometers: (n, 3) errors of the increments along the axes of the case, m/s.
    """
    true = truth.increments
    devices, rotations, forces, commands = [], [], [], []
    for schedule in schedules:
        case = find_case_angle(schedule, true)
        rotation = turn_into_case(true.rotation, case)
        rotation[:, VERTICAL] += list_steps(schedule.case, true)
        turned = replace(true, velocity=turn_into_case(true.velocity, case))
        rotations.append(rotation)
        for axis, (bench, start) in enumerate(zip(benches, schedule.start_angles, strict=True)):
            devices.append(bench if start is None else park_pattern(bench, start))
            forces.append(resolve_force_in_case(turned, np.eye(AXES)[axis]))
            steps = list_steps(schedule.virtual_rotation[axis], true)
            commands.append({"virtualRotation": steps / true.interval})
    outputs = simulate_together(devices, np.hstack(rotations), forces, true.interval, commands)
    return [
        TriadFlight(
            schedule,
            outputs[AXES * number : AXES * (number + 1)],
            turn_into_case(true.velocity, find_case_angle(schedule, true)) + accelerometers,
        )
        for number, schedule in enumerate(schedules)
    ]


def park_pattern(bench: Bench, start: float) -> Bench:
    """The gyro with its pattern started at an angle, rad, as well as power-on angles repeat."""
    return replace(bench, device=replace(bench.device, power_on_angle=start))


def find_case_angle(schedule: Schedule, true: Increments) -> Array:
    """(n,) angle of the case in the middle of each interval, rad."""
    return schedule.case.angle(true.bounds[:-1] + STILL + true.interval / 2)


def list_steps(sweep: Sweep, true: Increments) -> Array:
    """(n,) changes of an angle over the intervals, rad."""
    return np.diff(sweep.angle(true.bounds + STILL))
