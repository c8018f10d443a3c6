"""Conditions of a test that a form of error may depend on."""

from dataclasses import dataclass

import numpy as np

from pyhrg.bench.programme import Course
from pyhrg.challenge.truths.form import find_ideal_pattern_angle, find_resonator_warmth, follow
from pyhrg.common.arrays import Array
from pyhrg.device.device import Device
from pyhrg.records import Log


@dataclass(frozen=True)
class Conditions:
    """Conditions of a test: arrays by step (n, m) of a course or by row (n,) of a log; SI."""

    interval: float
    """Length of a row, s."""
    time: Array
    """Time since power-on, s."""
    rate: Array
    """Rate of the table, rad/s."""
    table_angle: Array
    wave_angle: Array
    case: Array
    """Temperature of the case above the reference, K."""
    warmth: Array
    """Temperature of the resonator above the reference, K."""
    warming: Array
    """Rate of the case's temperature, K/s."""
    acceleration: tuple[Array, Array, Array]
    """Specific force along x, y and the input axis, m/s2."""
    virtual_rotation: Array
    """Commanded rotation as an input rate, zero while the drive is off, rad/s."""
    amplitude: Array
    """Amplitude of the vibration; NaN where it is not known."""


def find_conditions_of_course(
    device: Device, course: Course, start: float, amplitude: Array | None = None
) -> Conditions:
    """Conditions of a nominal device in each step of a course, (n, m)."""
    warming = np.diff(course.case_temperature)[:, None] / course.interval
    shape = course.rate.shape
    return Conditions(
        interval=course.interval,
        time=course.time,
        rate=course.rate,
        table_angle=course.table_angle,
        wave_angle=find_ideal_pattern_angle(device, course, start),
        case=course.temperature - device.reference_temperature,
        warmth=find_resonator_warmth(device, course),
        warming=np.broadcast_to(warming, shape),
        acceleration=(
            course.each("acceleration_x"),
            course.each("acceleration_y"),
            course.each("acceleration_z"),
        ),
        virtual_rotation=course.each("virtual_rotation") * course.each("drive_on"),
        amplitude=np.full(shape, np.nan) if amplitude is None else amplitude,
    )


def find_conditions_of_log(device: Device, log: Log) -> Conditions:
    """Conditions of a device in each row of a true log, (n,)."""
    case = log.temperature - device.reference_temperature
    return Conditions(
        interval=log.interval,
        time=log.time,
        rate=np.diff(log.table_angle, prepend=0.0) / log.interval,
        table_angle=log.table_angle,
        wave_angle=log.wave_angle,
        case=case,
        warmth=follow(case, log.interval, device.thermal_lag),
        warming=np.diff(case, prepend=case[0]) / log.interval,
        acceleration=(log.acceleration_x, log.acceleration_y, log.acceleration_z),
        virtual_rotation=log.virtual_rotation * log.drive_on,
        amplitude=np.full_like(case, np.nan),
    )
