"""Forms of errors that the catalogue lacks, and parts of their shapes."""

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

    Attributes:
        place: place where the form acts, one of `PLACES`.
        coordinate: coordinate in which the form shows, by its name in the record format.
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
    position = values[0]
    for i, value in enumerate(values.tolist()):
        position = min(max(position, value - width / 2), value + width / 2)
        follower[i] = position
    return follower


def draw_sign(generator: np.random.Generator) -> float:
    """Plus or minus one."""
    return float(generator.choice((-1.0, 1.0)))
