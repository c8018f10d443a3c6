"""Gyros of a flight with effects outside the model, as a challenge's campaigns have them."""

from dataclasses import dataclass

import numpy as np

from ins_eval.study.cosimulated import MissionTruth, tilt_input_axes
from ins_eval.study.gyros.drawn_triad import DrawnTriad
from pyhrg.bench.programme import HELD_INPUTS, Course
from pyhrg.challenge.campaigns.gyro import Disturbance
from pyhrg.common.arrays import Array
from pyhrg.records.columns import COLUMNS
from pyhrg.records.log import Log

NOMINAL = {"amplitude_setpoint": 1.0, "phase_offset": 0.0, "drive_on": 1.0, "bias_voltage": 1.0}
"""Inputs that a flight does not command."""
READ_AT_END = ("gyro_angle", "wave_angle")
AVERAGED = ("amplitude_force", "quadrature_force", "frequency_offset")
"""Columns of a log that a flight records at the ends of its rows, and as means over them."""


@dataclass(frozen=True)
class DisturbedGyro:
    """A gyro of a triad in flight, in rows of the IMU's increments from power-on.

    Attributes:
        disturbance: effect outside the model.
        course: motion and environment.
        start: pattern angle at power-on, rad.
    """

    disturbance: Disturbance
    course: Course
    start: float

    def list_inputs(self) -> dict[str, Array]:
        """(n,) inputs of the FMU by its names; `angularRate` is what is added to it, rad/s."""
        held = {**self.course.held, **self.disturbance.inputs(self.course, self.start)}
        named = {HELD_INPUTS[n]: held[n] for n in held if n in HELD_INPUTS}
        amplitude = np.ones_like(self.course.rate)
        added = self.disturbance.compute_rate(self.course, self.start, amplitude)
        rate = np.broadcast_to(added, self.course.rate.shape)[:, 0]
        return {**named, "angularRate": rate}

    def change_records(self, ends: Array, means: Array) -> None:
        """Put the effect into what was recorded: (n, 2) angles of output and pattern, rad, and (n,
        3) amplitude and quadrature force, 1/s, and frequency offset, rad/s."""
        course = self.course
        commands = {name: course.held[name] for name in course.held if name != "bias_voltage"}
        recorded = {
            "time": course.interval * np.arange(1.0, len(course) + 1),
            "table_angle": course.table_angle_at_ends,
            "temperature": course.case_temperature[1:],
            "amplitude": np.ones(len(course)),
            **dict(zip(READ_AT_END, ends.T, strict=True)),
            **dict(zip(AVERAGED, means.T, strict=True)),
        }
        missing = {c.field: np.full(len(course), np.nan) for c in COLUMNS}
        log = Log(source="flight", interval=course.interval, **{**missing, **commands, **recorded})
        true = self.disturbance.change_log(log, course, self.start, np.ones_like(course.rate))
        shown = self.disturbance.shown(true)
        ends[:] = np.column_stack([getattr(shown, name) for name in READ_AT_END])
        means[:] = np.column_stack([getattr(shown, name) for name in AVERAGED])


def disturb_gyro(
    disturbance: Disturbance, truth: MissionTruth, triad: DrawnTriad, axis: int, rotation: Array
) -> DisturbedGyro:
    """rotation: (n,) virtual rotation, rad/s."""
    true, flown = truth.increments, triad.flights[axis]
    rate = true.rotation @ tilt_input_axes(triad.mounting)[axis] / true.interval
    held = {f"acceleration_{x}": truth.forces[axis][:, i] for i, x in enumerate("xyz")}
    held |= {name: np.full(len(true), value) for name, value in NOMINAL.items()}
    held |= {"virtual_rotation": rotation, "axis_up": np.zeros(len(true))}
    course = Course(
        interval=true.interval,
        step=true.interval,
        table_rate=np.concatenate([rate[:1], 0.5 * (rate[1:] + rate[:-1]), rate[-1:]]),
        case_temperature=flown.case_temperature(true.bounds),
        held=held,
    )
    return DisturbedGyro(disturbance, course, flown.power_on_angle)
