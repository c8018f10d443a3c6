"""Errors that the catalogue lacks: forms of errors, their kinds, and parts of their shapes."""

import math
from collections.abc import Callable
from dataclasses import dataclass
from importlib import import_module

import numpy as np
from scipy.signal import lfilter

from pyhrg.challenge.campaigns.course import Course
from pyhrg.challenge.campaigns.gyro import Disturbance
from pyhrg.common.arrays import Array
from pyhrg.device.device import Device

Shape = Callable[[Course, float], Array]
"""Added input rate at unit size, (n, m), rad/s, by course and start angle."""
Disturb = Callable[[Device, float, np.random.Generator], Disturbance]
"""Disturbance of the nominal device at a size (1 is a typical one), by a generator that draws all
else; the same generator gives the same form at any size."""
FORMS_MODULE = "pyhrg.challenge.truths.outside"
"""Loaded by this name when a challenge is generated; no module imports it."""


@dataclass(frozen=True)
class Form:
    """A form of error that the catalogue lacks.

    coordinate: in which it shows, by the name of the record format.
    stand_ins: names of the record format that it may be given.
    """

    name: str
    coordinate: str
    disturbance: Disturb
    stand_ins: tuple[str, ...] = ()


def load_forms() -> tuple[Form, ...]:
    """All forms."""
    forms: tuple[Form, ...] = import_module(FORMS_MODULE).FORMS
    return forms


def make_rate_form(
    name: str,
    coordinate: str,
    scale: float,
    draw_shape: Callable[[Device, np.random.Generator], Shape],
) -> Form:
    """A form that adds a rate to the input rate, of a shape times the scale."""

    def disturbance(device: Device, size: float, generator: np.random.Generator) -> Disturbance:
        shape = draw_shape(device, generator)
        return Disturbance(rate=lambda course, start: size * scale * shape(course, start))

    return Form(name, coordinate, disturbance)


def make_signed_rate_form(
    name: str, coordinate: str, scale: float, shape: Callable[[Device, Course], Array]
) -> Form:
    """A form that adds a rate to the input rate, of a shape times the scale and a drawn sign."""

    def draw_shape(device: Device, generator: np.random.Generator) -> Shape:
        sign = draw_sign(generator)
        return lambda course, start: sign * shape(device, course)

    return make_rate_form(name, coordinate, scale, draw_shape)


def find_ideal_pattern_angle(device: Device, course: Course, start: float) -> Array:
    """(n, m) pattern angle of a gyro without errors, rad."""
    earth = device.site.vertical_rate * course.integrate(course.each("axis_up"))
    turned = course.table_angle + earth - course.integrate(course.each("virtual_rotation"))
    return np.asarray(start - device.bryan_factor * turned)


def find_resonator_warmth(device: Device, course: Course) -> Array:
    """(n, m) temperature of the resonator above the reference, K."""
    kept = math.exp(-course.step / device.thermal_lag)
    case = (course.temperature - device.reference_temperature).ravel()
    return np.asarray(lfilter([1 - kept], [1, -kept], case).reshape(course.temperature.shape))


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
