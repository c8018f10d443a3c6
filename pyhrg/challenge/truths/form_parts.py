"""Kinds of forms outside the catalogue, and what their shapes are made of."""

import math
from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray
from scipy.signal import lfilter

from pyhrg.challenge.campaigns.course import Course
from pyhrg.challenge.campaigns.gyro import Disturbance
from pyhrg.challenge.truths.form import Form
from pyhrg.device.device import Device
from pyhrg.records import Log

Array = NDArray[np.float64]
Shape = Callable[[Course, float], Array]
"""Added input rate at unit size, (n, m), rad/s, by course and start angle."""


def make_rate_form(
    name: str, coordinate: str, scale: float, shaped: Callable[[Device, np.random.Generator], Shape]
) -> Form:
    """A form that adds to the input rate: `shaped` gives its shape, of course and start angle."""

    def disturbance(device: Device, size: float, generator: np.random.Generator) -> Disturbance:
        shape = shaped(device, generator)
        return Disturbance(rate=lambda course, start: size * scale * shape(course, start))

    return Form(name, coordinate, scale, disturbance)


def make_parameter_form(
    name: str,
    coordinate: str,
    scale: float,
    parameters: Callable[[np.random.Generator], dict[str, float]],
) -> Form:
    """A form that changes parameters of the FMU, by these values at unit size."""

    def disturbance(device: Device, size: float, generator: np.random.Generator) -> Disturbance:
        drawn = parameters(generator)
        return Disturbance(model={n: size * scale * value for n, value in drawn.items()})

    return Form(name, coordinate, scale, disturbance)


def make_display_form(
    name: str,
    coordinate: str,
    scale: float,
    changed: Callable[[Device, float, np.random.Generator], Callable[[Log], Log]],
) -> Form:
    """A form of the bench's own instruments."""

    def disturbance(device: Device, size: float, generator: np.random.Generator) -> Disturbance:
        return Disturbance(shown=changed(device, size * scale, generator))

    return Form(name, coordinate, scale, disturbance)


def find_ideal_pattern_angle(device: Device, course: Course, start: float) -> Array:
    """(n, m) pattern angle of a gyro without errors, rad."""
    earth = device.site.vertical_rate * course.integrated(course.each("axis_up"))
    turned = course.table_angle + earth - course.integrated(course.each("virtual_rotation"))
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


def decay(time: Array, lag: float) -> Array:
    """exp(-time/lag)."""
    return np.asarray(np.exp(-time / lag), dtype=np.float64)


def draw_sign(generator: np.random.Generator) -> float:
    """Plus or minus one."""
    return float(generator.choice((-1.0, 1.0)))
