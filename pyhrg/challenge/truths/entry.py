"""Ways in which an error of some shape enters a gyro, its read-out or its bench.

Each returns a disturbance of the nominal device by its size and a generator; `scale` is the
typical size of the error, SI.
"""

import math
from collections.abc import Callable
from dataclasses import replace
from typing import Any

import numpy as np

from pyhrg.bench.programme import Course
from pyhrg.challenge.campaigns.gyro import Disturbance
from pyhrg.challenge.truths.conditions import (
    Conditions,
    find_conditions_of_course,
    find_conditions_of_log,
)
from pyhrg.challenge.truths.form import Disturb, draw_sign
from pyhrg.common.arrays import Array
from pyhrg.device.device import Device
from pyhrg.records import Log

Shape = Callable[[Conditions, np.random.Generator], Array]
"""An error of unit size by the conditions of a test. The generator, which is the same in each test,
draws what else it depends on."""
Error = Callable[[Conditions], Array]
"""An error, SI, by the conditions of a test."""


def turn(scale: float, shape: Shape) -> Disturb:
    """A rate that is added to the input rate: a bias."""

    def disturb(device: Device, size: float, generator: np.random.Generator) -> Disturbance:
        error = _draw_error(size * scale, shape, generator)
        return Disturbance(
            rate=lambda course, start: error(find_conditions_of_course(device, course, start))
        )

    return disturb


def turn_by_amplitude(scale: float, shape: Shape) -> Disturb:
    """A rate that is added to the input rate and depends on the amplitude of the vibration."""

    def disturb(device: Device, size: float, generator: np.random.Generator) -> Disturbance:
        error = _draw_error(size * scale, shape, generator)

        def rate(course: Course, start: float, amplitude: Array) -> Array:
            return error(find_conditions_of_course(device, course, start, amplitude))

        return Disturbance(rate_at_amplitude=rate)

    return disturb


def damp(scale: float, shape: Shape) -> Disturb:
    """A rate of decay, 1/s, that is added to all modes. The amplitude force balances it; while the
    drive is off, the amplitude decays by it."""

    def disturb(device: Device, size: float, generator: np.random.Generator) -> Disturbance:
        error = _draw_error(size * scale, shape, generator)

        def decay(log: Log, course: Course, start: float, amplitude: Array) -> Log:
            return _decay(log, error(find_conditions_of_course(device, course, start, amplitude)))

        return Disturbance(change_at_amplitude=decay)

    return disturb


def damp_along_axis(scale: float, shape: Shape) -> Disturb:
    """A damping anisotropy D, 1/s, along a drawn axis: a bias -(D/4k) sin 4(th - th_tau) and a rate
    of decay (D/2) cos 4(th - th_tau)."""

    def disturb(device: Device, size: float, generator: np.random.Generator) -> Disturbance:
        axis = generator.uniform(0, math.pi / 2)
        error = _draw_error(size * scale, shape, generator)

        def turn_by(course: Course, start: float, amplitude: Array) -> Array:
            now = find_conditions_of_course(device, course, start, amplitude)
            slope = np.sin(4 * (now.wave_angle - axis)) / (4 * device.bryan_factor)
            return np.asarray(-error(now) * slope)

        def decay(log: Log, course: Course, start: float, amplitude: Array) -> Log:
            now = find_conditions_of_course(device, course, start, amplitude)
            return _decay(log, error(now) / 2 * np.cos(4 * (now.wave_angle - axis)))

        return Disturbance(rate_at_amplitude=turn_by, change_at_amplitude=decay)

    return disturb


def detune(scale: float, shape: Shape) -> Disturb:
    """A modal frequency, rad/s, that may depend on the amplitude of the vibration."""

    def disturb(device: Device, size: float, generator: np.random.Generator) -> Disturbance:
        error = _draw_error(size * scale, shape, generator)

        def change(log: Log, course: Course, start: float, amplitude: Array) -> Log:
            now = find_conditions_of_course(device, course, start, amplitude)
            return replace(log, frequency_offset=log.frequency_offset + error(now).mean(axis=1))

        return Disturbance(change_at_amplitude=change)

    return disturb


def vary(parameter: str, scale: float, shape: Shape) -> Disturb:
    """A parameter of the FMU that follows a shape.

    The parameter is one by specific force; its component along y is set, and that input of the FMU
    gets the shape. Nothing else of a nominal device depends on it.
    """

    def disturb(device: Device, size: float, generator: np.random.Generator) -> Disturbance:
        error = _draw_error(1.0, shape, generator)

        def force(course: Course, start: float) -> dict[str, Array]:
            values = error(find_conditions_of_course(device, course, start))
            return {"acceleration_y": values.mean(axis=1)}

        return Disturbance(model={f"{parameter}[2]": size * scale}, inputs=force)

    return disturb


def command(name: str, scale: float, shape: Shape) -> Disturb:
    """A command that reaches the gyro with an error which the log does not show."""

    def disturb(device: Device, size: float, generator: np.random.Generator) -> Disturbance:
        error = _draw_error(size * scale, shape, generator)

        def wrong(course: Course, start: float) -> dict[str, Array]:
            values = error(find_conditions_of_course(device, course, start))
            return {name: course.held[name] + values.mean(axis=1)}

        return Disturbance(inputs=wrong)

    return disturb


def show(field: str, scale: float, shape: Shape) -> Disturb:
    """A column of the log with an error."""

    def disturb(device: Device, size: float, generator: np.random.Generator) -> Disturbance:
        error = _draw_error(size * scale, shape, generator)

        def change(log: Log) -> Log:
            wrong: Any = {field: getattr(log, field) + error(find_conditions_of_log(device, log))}
            return replace(log, **wrong)

        return Disturbance(shown=change)

    return disturb


def misread(scale: float, shape: Shape) -> Disturb:
    """An error of the detected pattern angle, rad, with which the loops do not work."""

    def disturb(device: Device, size: float, generator: np.random.Generator) -> Disturbance:
        error = _draw_error(size * scale, shape, generator)

        def change(log: Log) -> Log:
            wrong = error(find_conditions_of_log(device, log))
            gyro = log.gyro_angle - wrong / device.bryan_factor
            return replace(log, wave_angle=log.wave_angle + wrong, gyro_angle=gyro)

        return Disturbance(shown=change)

    return disturb


def _draw_error(size: float, shape: Shape, generator: np.random.Generator) -> Error:
    """A shape at a size, SI, of a drawn sign."""
    signed, seed = size * draw_sign(generator), int(generator.integers(2**31))
    return lambda now: np.asarray(signed * shape(now, np.random.default_rng(seed)))


def _decay(log: Log, rate: Array) -> Log:
    """A log with an added rate of decay, (n, m), 1/s, to first order."""
    is_free, mean = log.is_free, rate.mean(axis=1)
    lost = np.cumsum(np.where(is_free, mean, 0.0)) * log.interval
    return replace(
        log,
        amplitude_force=log.amplitude_force + np.where(is_free, 0.0, mean),
        amplitude=log.amplitude * np.exp(-lost),
    )
