"""Forces of a gyro that goes through a recorded motion, simulated by the FMU.

The log has no true rate and no temperature of the resonator. Both are found in rounds
(`following.py`): the rate is the one that turns the simulated pattern, as it is detected, through
the recorded angles, and the temperature the one that gives the recorded frequency.
"""

import math
from collections.abc import Sequence
from contextlib import ExitStack
from dataclasses import dataclass, replace

import numpy as np
from scipy.ndimage import uniform_filter1d

from pyhrg.common.arrays import Array
from pyhrg.common.errors import HrgError
from pyhrg.device.device import Device
from pyhrg.device.fmu_parameters import LOOP_FREQUENCIES
from pyhrg.fmu import Gyro, GyroFmu, record_together
from pyhrg.records.log import Log
from pyhrg.witness.design import Motion, stack_signals
from pyhrg.witness.responses import FORCES, SOAKED_LAG

REQUIRED = ("wave_angle", "frequency_offset")
"""Columns without which nothing is estimated."""
RECORDED_FORCES = ("amplitude_force", "quadrature_force")
"""Columns of which at least one is needed."""
STEP = 0.01
"""Communication step of `HRG`, s. Chosen: ten control periods."""
SLOW_STEP = 0.1
"""Longest communication step of `HRGSlow`, and its sample period, s. Chosen: a replay then takes a
twentieth of the time of one of `HRG`."""
SHORTEST_ROW = 0.01
"""Shortest row that is replayed, s: the shortest sample period of `HRGSlow`."""
SMOOTHING = 10.0
"""Time over which the frequency is averaged to give the temperature, s. Chosen: longer than
`SOAKED_LAG`, so that rounds converge, and shorter than any thermal lag."""
SETTLING = 2 * SMOOTHING
"""Time after the first row that is left out until loops and temperature are settled, s. Derived:
the case's rate of temperature needs two averages on both sides."""


@dataclass(frozen=True)
class Witnesses:
    """A gyro's own channels in a log, with no row missing.

    Attributes:
        interval: length of a row, s.
        angle: (n + 1,) detected pattern angle at the beginning of the first row and at the end of
            each, rad.
        forces: (n, 2) amplitude and quadrature force, 1/s; one that was not recorded is NaN.
        frequency: (n,) offset, rad/s.
        virtual_rotation: (n,) rad/s.
        specific_force: (n, 3) m/s^2.
    """

    interval: float
    angle: Array
    forces: Array
    frequency: Array
    virtual_rotation: Array
    specific_force: Array

    def take(self, count: int) -> "Witnesses":
        """The first rows."""
        return Witnesses(
            self.interval,
            self.angle[: count + 1],
            self.forces[:count],
            self.frequency[:count],
            self.virtual_rotation[:count],
            self.specific_force[:count],
        )

    def merge(self, parts: int) -> "Witnesses":
        """Rows of so many rows each; what is left at the end is left out."""
        count = len(self.forces) // parts

        def average(values: Array) -> Array:
            rows = values[: count * parts].reshape(count, parts, *values.shape[1:])
            return np.asarray(rows.mean(axis=1))

        return Witnesses(
            self.interval * parts,
            self.angle[: count * parts + 1 : parts],
            average(self.forces),
            average(self.frequency),
            average(self.virtual_rotation),
            average(self.specific_force),
        )


@dataclass(frozen=True)
class Replay:
    """Simulation of a log by the FMU, compared with the log.

    Attributes:
        residuals: (n, 2) recorded less simulated forces, 1/s; NaN where none was recorded.
        angle_errors: (n,) recorded less simulated angles at the rows' ends, rad.
        frequency_errors: (n,) recorded less simulated frequency, rad/s.
        motion: motion of the simulated gyro.
        following: how the next replay is to go, so that angles and frequency agree.
    """

    residuals: Array
    angle_errors: Array
    frequency_errors: Array
    motion: Motion
    following: "Course"

    @property
    def angle_error(self) -> float:
        """Rms of recorded less simulated angles, rad."""
        return float(np.sqrt(np.mean(self.angle_errors**2)))


@dataclass(frozen=True)
class Course:
    """Motion and temperature of a simulated gyro.

    Attributes:
        start: pattern angle at the beginning, rad.
        rate: (n,) of the case, rad/s.
        temperature: (n,) above the reference, K.
    """

    start: float
    rate: Array
    temperature: Array


def read_witnesses(log: Log, device: Device) -> Witnesses:
    """The longest stretch of a log without a gap, in rows of at least `SHORTEST_ROW`. One of the
    forces may be missing.

    Raises:
        LogError: a column that is required, or both forces, have no values.
        HrgError: the stretch is too short, or the gyro was commanded what changes its forces.
    """
    for field, nominal in _list_nominal_commands(device).items():
        values = getattr(log, field)
        other = values[np.isfinite(values) & (values != nominal)]
        if len(other):
            raise HrgError(
                f"{log.source}: {field}: found {other[0]:g}, expected {nominal:g} in all rows"
            )
    forces = [name for name in RECORDED_FORCES if log.has_values(name)] or RECORDED_FORCES
    stretches = log.stretches(*REQUIRED, *forces)
    stretch = max(stretches, key=lambda each: each.stop - each.start)
    rows = slice(stretch.start + 1, stretch.stop)
    count = rows.stop - rows.start
    if count * log.interval < 2 * SETTLING:
        raise HrgError(
            f"{log.source}: found {count * log.interval:g} s without a gap, expected "
            f"{2 * SETTLING:g} s or more"
        )
    accelerations = [log.acceleration_x, log.acceleration_y, log.acceleration_z]
    witnesses = Witnesses(
        interval=log.interval,
        angle=log.wave_angle[stretch],
        forces=np.stack([log.amplitude_force[rows], log.quadrature_force[rows]], axis=1),
        frequency=log.frequency_offset[rows],
        virtual_rotation=np.nan_to_num(log.virtual_rotation[rows]),
        specific_force=np.nan_to_num(np.stack(accelerations, axis=1)[rows]),
    )
    return witnesses.merge(max(1, math.ceil(SHORTEST_ROW / log.interval - 1e-9)))


def _list_nominal_commands(device: Device) -> dict[str, float]:
    """Values of a log's commands that the sensitivities hold for, by field."""
    return {"drive_on": 1.0, "phase_offset": 0.0, "amplitude_setpoint": device.amplitude}


def guess_course(device: Device, witnesses: Witnesses) -> Course:
    """The course of an ideal gyro at its reference temperature."""
    pattern_rate = np.diff(witnesses.angle) / witnesses.interval
    rate = witnesses.virtual_rotation - pattern_rate / device.bryan_factor
    return Course(float(witnesses.angle[0]), rate, np.zeros_like(rate))


def replay(
    fmu: GyroFmu,
    devices: Sequence[Device],
    witnesses: Sequence[Witnesses],
    courses: Sequence[Course],
) -> list[Replay]:
    """Each device on its course, all together.

    fmu: `HRG`, or `HRGSlow` for a gyro whose loops are at rest.
    """
    runs = list(zip(devices, witnesses, courses, strict=True))
    intervals = {each.interval for each in witnesses}
    if len(intervals) > 1:
        raise ValueError("found logs of other intervals, expected one for all")
    interval = witnesses[0].interval
    steps = max(1, round(interval / STEP) if fmu.is_sampled else math.ceil(interval / SLOW_STEP))
    step = interval / steps
    moving = [_list_moving(*each, steps) for each in runs]
    held = [
        {f"acceleration{x}": each.specific_force[:, i] for i, x in enumerate("XYZ")}
        | {"virtualRotation": each.virtual_rotation}
        for each in witnesses
    ]
    with ExitStack() as stack:
        gyros = [stack.enter_context(_power_on(fmu, d, c.start, step)) for d, _, c in runs]
        names = [*FORCES, "frequencyOffset"]
        recorded = record_together(gyros, moving, held, step, ["patternAngle"], names)
    return [
        _compare(*run, ends[:, 0], means) for run, (ends, means) in zip(runs, recorded, strict=True)
    ]


def _power_on(fmu: GyroFmu, device: Device, start: float, step: float) -> Gyro:
    # the rate of the case's temperature is not that of the soaked gyro: the design has its effect
    soaked = replace(device.without_noise(), thermal_lag=SOAKED_LAG, bias_per_temperature_rate=0.0)
    parameters = soaked.fmu_parameters()
    if not fmu.is_sampled:
        quasi_steady = {n: v for n, v in parameters.items() if n not in LOOP_FREQUENCIES}
        parameters = {**quasi_steady, "samplePeriod": step}
    return fmu.power_on(parameters, 0, start)


def _list_moving(
    device: Device, witnesses: Witnesses, course: Course, steps: int
) -> dict[str, Array]:
    rows = np.arange(len(course.rate))
    # the resonator follows the case by the lag, so that the case has to be ahead of it
    ahead = np.interp(rows + SOAKED_LAG / witnesses.interval, rows, course.temperature)
    case = device.reference_temperature + ahead
    # a rate that is linear in each row keeps the mean force right to second order
    inside = (np.arange(steps) + 0.5) / steps - 0.5
    return {
        "angularRate": course.rate[:, None] + np.gradient(course.rate)[:, None] * inside,
        "caseTemperature": np.repeat(case[:, None], steps, axis=1),
    }


def _compare(
    device: Device, witnesses: Witnesses, course: Course, angle: Array, means: Array
) -> Replay:
    simulated = np.concatenate([[course.start], angle])
    angle_errors = witnesses.angle[1:] - angle
    frequency_errors = witnesses.frequency - means[:, 2]
    return Replay(
        residuals=witnesses.forces - means[:, :2],
        angle_errors=angle_errors,
        frequency_errors=frequency_errors,
        motion=Motion(
            witnesses.interval,
            0.5 * (simulated[1:] + simulated[:-1]),
            course.rate,
            witnesses.virtual_rotation,
            course.temperature,
            stack_signals(
                _compute_temperature_rate(course, device, witnesses.interval),
                witnesses.specific_force,
            ),
        ),
        following=_correct(course, device, witnesses.interval, angle_errors, frequency_errors),
    )


def _compute_temperature_rate(course: Course, device: Device, interval: float) -> Array:
    """(n,) rate of the case's temperature, K/s, which the resonator follows by its lag."""
    width = max(1, round(SMOOTHING / interval))

    def differentiate(values: Array) -> Array:
        return uniform_filter1d(np.gradient(values, interval), width, mode="nearest")

    rate = differentiate(course.temperature)
    return np.asarray(rate + device.thermal_lag * differentiate(rate))


def _correct(
    course: Course, device: Device, interval: float, error: Array, frequency_error: Array
) -> Course:
    rate = course.rate - np.diff(error, prepend=error[0]) / interval / device.bryan_factor
    per_kelvin = device.frequency * device.frequency_per_kelvin
    if not per_kelvin:
        return Course(course.start + float(error[0]), rate, course.temperature)
    warmer = smooth_errors(frequency_error, interval) / per_kelvin
    return Course(course.start + float(error[0]), rate, course.temperature + warmer)


def smooth_errors(values: Array, interval: float) -> Array:
    """(n,) values, averaged twice over half of `SMOOTHING` and reflected at the ends. No line
    changes its sign by that, so that rounds converge at every frequency."""
    width = 2 * round(SMOOTHING / interval / 4) + 1
    return np.asarray(uniform_filter1d(uniform_filter1d(values, width), width))
