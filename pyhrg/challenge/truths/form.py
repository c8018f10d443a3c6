"""Forms of errors that the catalogue lacks, parts of their shapes, and what a gyro meets in a test,
on which a form may depend.
"""

import math
from collections.abc import Callable
from dataclasses import dataclass
from importlib import import_module

import numpy as np
from scipy.signal import lfilter

from pyhrg.bench.programme import Course
from pyhrg.challenge.campaigns.gyro import Disturbance
from pyhrg.common.arrays import Array
from pyhrg.device.device import Device
from pyhrg.records import Log

Disturb = Callable[[Device, float, np.random.Generator], Disturbance]
"""Disturbance of the nominal device at a size (1 is a typical one), by a generator that draws all
else; the same generator gives the same form at any size."""
PLACES = (
    *("bias", "readout", "damping", "stiffness"),
    *("pickoff", "drive", "electronics", "bench"),
)
"""Where a form acts, by the names of the record format."""
FORMS_MODULE = "pyhrg.challenge.truths.outside"
"""Loaded by this name when a challenge is generated; no module imports it."""


@dataclass(frozen=True)
class Form:
    """A form of error that the catalogue lacks.

    place: where it acts, of `PLACES`.
    coordinate: in which it shows, by the name of the record format.
    reason: why a laboratory may meet it, a sentence.
    """

    name: str
    place: str
    coordinate: str
    disturbance: Disturb
    reason: str


def load_forms() -> tuple[Form, ...]:
    """All forms."""
    forms: tuple[Form, ...] = import_module(FORMS_MODULE).FORMS
    return forms


def find_ideal_pattern_angle(device: Device, course: Course, start: float) -> Array:
    """(n, m) pattern angle of a gyro without errors, rad."""
    earth = device.site.vertical_rate * course.integrate(course.each("axis_up"))
    turned = course.table_angle + earth - course.integrate(course.each("virtual_rotation"))
    return np.asarray(start - device.bryan_factor * turned)


def find_resonator_warmth(device: Device, course: Course) -> Array:
    """(n, m) temperature of the resonator above the reference, K."""
    case = (course.temperature - device.reference_temperature).ravel()
    return follow(case, course.step, device.thermal_lag).reshape(course.temperature.shape)


def follow(values: Array, step: float, lag: float) -> Array:
    """(n,) values, a step in s apart, with a first-order lag, s, from zero."""
    kept = math.exp(-step / lag)
    return np.asarray(lfilter([1 - kept], [1, -kept], values))


def apply_play(values: Array, width: float) -> Array:
    """(n,) values with a play of this width: they lag by half of it, either way."""
    follower = np.empty_like(values)
    at = values[0]
    for i, value in enumerate(values.tolist()):
        at = min(max(at, value - width / 2), value + width / 2)
        follower[i] = at
    return follower


def draw_sign(generator: np.random.Generator) -> float:
    """Plus or minus one."""
    return float(generator.choice((-1.0, 1.0)))


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
