"""What the catalogue does not have: forms of errors of gyro and bench.

Physical where the FMU has a parameter for it that no catalogued effect uses, else added to the
input rate, to an input, or to what the bench shows. Loaded by name alone (`form.FILE`).
"""

import math
from collections.abc import Callable
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray
from scipy.signal import lfilter

from pyhrg.challenge.campaigns.course import Course
from pyhrg.challenge.campaigns.gyro import Disturbance
from pyhrg.challenge.truths.form import Form
from pyhrg.common.units import ARCSEC, DEG, DEG_PER_H, HZ, PPM
from pyhrg.device.device import Device
from pyhrg.records import Log

Array = NDArray[np.float64]
Shape = Callable[[Course, float], Array]
"""Added rate at unit size, (n, m), by course and start angle."""


def added_rate(
    name: str, coordinate: str, scale: float, shaped: Callable[[Device, np.random.Generator], Shape]
) -> Form:
    """A form that adds to the input rate: `shaped` gives its shape, of course and start angle."""

    def disturbance(device: Device, size: float, generator: np.random.Generator) -> Disturbance:
        shape = shaped(device, generator)
        return Disturbance(rate=lambda course, start: size * scale * shape(course, start))

    return Form(name, coordinate, scale, disturbance)


def physical(
    name: str,
    coordinate: str,
    scale: float,
    parameters: Callable[[np.random.Generator], dict[str, float]],
) -> Form:
    """A form that is parameters of the FMU, those at unit size of 1."""

    def disturbance(device: Device, size: float, generator: np.random.Generator) -> Disturbance:
        drawn = parameters(generator)
        return Disturbance(model={n: size * scale * value for n, value in drawn.items()})

    return Form(name, coordinate, scale, disturbance)


def shown(
    name: str,
    coordinate: str,
    scale: float,
    changed: Callable[[Device, float, np.random.Generator], Callable[[Log], Log]],
) -> Form:
    """A form of the bench's own instruments."""

    def disturbance(device: Device, size: float, generator: np.random.Generator) -> Disturbance:
        return Disturbance(shown=changed(device, size * scale, generator))

    return Form(name, coordinate, scale, disturbance)


# What shapes are made of


def pattern_angle(device: Device, course: Course, start: float) -> Array:
    """(n, m) where the pattern would be without errors, rad."""
    earth = device.site.vertical_rate * course.integrated(course.each("axis_up"))
    turned = course.table_angle + earth - course.integrated(course.each("virtual_rotation"))
    return np.asarray(start - device.bryan_factor * turned)


def resonator_warmth(device: Device, course: Course) -> Array:
    """(n, m) temperature of the resonator above the reference, K."""
    kept = math.exp(-course.step / device.thermal_lag)
    case = (course.temperature - device.reference_temperature).ravel()
    return np.asarray(lfilter([1 - kept], [1, -kept], case).reshape(course.temperature.shape))


def played(values: Array, width: float) -> Array:
    """(n,) what follows values with a play of this width: behind by half of it, either way."""
    follower = np.empty_like(values)
    at = values[0]
    for i, value in enumerate(values.tolist()):
        at = min(max(at, value - width / 2), value + width / 2)
        follower[i] = at
    return follower


def decaying(time: Array, lag: float) -> Array:
    """exp(-time/lag)."""
    return np.asarray(np.exp(-time / lag), dtype=np.float64)


def sign(generator: np.random.Generator) -> float:
    """Plus or minus one."""
    return float(generator.choice((-1.0, 1.0)))


# Pattern angle


def harmonic(order: int) -> Form:
    """A bias that goes with a harmonic of the pattern angle."""

    def shaped(device: Device, generator: np.random.Generator) -> Shape:
        phase = generator.uniform(0, 2 * math.pi)
        return lambda course, start: np.sin(order * pattern_angle(device, course, start) + phase)

    return added_rate(f"bias_harmonic_{order}", "wave_angle", 0.1 * DEG_PER_H, shaped)


def frequency_pulling(
    device: Device, size: float, generator: np.random.Generator
) -> Callable[[Log], Log]:
    """The phase loop's frequency goes with twice the pattern angle."""
    phase = generator.uniform(0, 2 * math.pi)
    return lambda log: replace(
        log, frequency_offset=log.frequency_offset + size * np.sin(2 * log.wave_angle + phase)
    )


# Table


def encoder(order: int) -> Form:
    """An encoder that is out of centre (1), or whose disc is (2)."""

    def changed(
        device: Device, size: float, generator: np.random.Generator
    ) -> Callable[[Log], Log]:
        phase = generator.uniform(0, 2 * math.pi)

        def error(angle: Array) -> Array:
            return np.asarray(size * (np.sin(order * angle + phase) - math.sin(phase)))

        return lambda log: replace(log, table_angle=log.table_angle + error(log.table_angle))

    return shown(f"encoder_harmonic_{order}", "table_angle", 5 * ARCSEC, changed)


# Temperature


def squared_temperature(device: Device, generator: np.random.Generator) -> Shape:
    """A bias that goes with the square of the temperature."""
    way = sign(generator)
    return lambda course, start: way * (resonator_warmth(device, course) / 30) ** 2


def hysteresis(device: Device, generator: np.random.Generator) -> Shape:
    """A bias that the way to a temperature leaves behind."""
    way, width = sign(generator), generator.uniform(5, 20)

    def shape(course: Course, start: float) -> Array:
        case = course.case_temperature
        left = (case - played(case, width)) / width
        return np.asarray(way * (left[1:] + left[:-1])[:, None] / 2)

    return shape


def sensor_lag(device: Device, size: float, generator: np.random.Generator) -> Callable[[Log], Log]:
    """A temperature sensor that is late, s."""

    def late(log: Log) -> Log:
        kept = math.exp(-log.interval / max(size, 1e-9))
        above = log.temperature - device.reference_temperature
        lagged = lfilter([1 - kept], [1, -kept], above)
        return replace(log, temperature=device.reference_temperature + lagged)

    return late


# Rate


def asymmetry(device: Device, generator: np.random.Generator) -> Shape:
    """A scale factor that differs between the ways of turning."""
    way = sign(generator)
    return lambda course, start: way * np.abs(course.rate)


def squared_rate(device: Device, generator: np.random.Generator) -> Shape:
    """A scale factor that goes with the rate's size: unity at 100 deg/s."""
    way = sign(generator)
    return lambda course, start: way * course.rate * np.abs(course.rate / (100 * DEG))


def cubed_rate(device: Device, generator: np.random.Generator) -> Shape:
    """A scale factor that goes with the square of the rate: unity at 100 deg/s."""
    way = sign(generator)
    return lambda course, start: way * course.rate * (course.rate / (100 * DEG)) ** 2


# Acceleration


def squared_acceleration(generator: np.random.Generator) -> dict[str, float]:
    """A pick-off gain that goes with the square of a specific force across the axis."""
    axis = generator.choice((1, 2))
    return {f"pickOff.gainPerAccelerationSquared[{axis}]": sign(generator)}


def cross_axis(generator: np.random.Generator) -> dict[str, float]:
    """A force frame that a specific force across the axis turns."""
    axis = generator.choice((1, 2))
    return {f"drive.rotationPerAcceleration[{axis}]": sign(generator)}


def split_by_acceleration(generator: np.random.Generator) -> dict[str, float]:
    """A frequency split that a specific force across the axis makes."""
    axis = generator.choice((1, 2))
    return {f"resonator.material.splitPerAcceleration[{axis}]": sign(generator)}


# Amplitude


def squared_amplitude(device: Device, generator: np.random.Generator) -> Shape:
    """A bias that goes with the square of the amplitude; none at the nominal one."""
    way = sign(generator)
    return lambda course, start: way * (course.each("amplitude_setpoint") ** 2 - 1)


# Time


def warm_up(device: Device, generator: np.random.Generator) -> Shape:
    """A bias that dies out after power-on."""
    way, lag = sign(generator), generator.uniform(300, 1500)
    return lambda course, start: way * decaying(course.time, lag)


def jump(device: Device, generator: np.random.Generator) -> Shape:
    """A bias that is there from some time on."""
    way, share = sign(generator), generator.uniform(0.3, 0.7)
    return lambda course, start: (
        way * (course.time > share * len(course) * course.interval).astype(np.float64)
    )


def periodic(device: Device, generator: np.random.Generator) -> Shape:
    """A disturbance of a period."""
    period, phase = generator.uniform(60, 900), generator.uniform(0, 2 * math.pi)
    return lambda course, start: np.sin(2 * math.pi * course.time / period + phase)


def charge(device: Device, size: float, generator: np.random.Generator) -> Disturbance:
    """Charge that drifts on the electrodes: frequency and split move with the bias voltage."""
    axis = generator.uniform(0, math.pi / 2)
    softening = {
        "resonator.material.electrostaticShift": 3.0,
        "resonator.material.electrostaticSplit": 0.3,
        "resonator.material.electrostaticAxis": axis,
    }

    def drifting(course: Course, start: float) -> dict[str, Array]:
        hours = (np.arange(len(course)) + 0.5) * course.interval / 3600
        return {"bias_voltage": 1 + size * CHARGE * hours}

    return Disturbance(model=softening, inputs=drifting)


CHARGE = 1e-4
"""Drift of the bias voltage, relative, 1/h."""


# Noise


def bursts(device: Device, generator: np.random.Generator) -> Shape:
    """Rate noise that comes and goes in minutes."""
    seed = int(generator.integers(2**31))

    def shape(course: Course, start: float) -> Array:
        own = np.random.default_rng([seed, len(course)])
        spell = np.arange(len(course)) * course.interval // 120
        loud = own.random(int(spell[-1]) + 1) < 0.1
        noise = own.standard_normal(len(course)) / math.sqrt(course.interval)
        return np.asarray((noise * loud[spell.astype(int)])[:, None])

    return shape


FORMS = (
    harmonic(2),
    harmonic(6),
    harmonic(12),
    shown("frequency_pulling", "wave_angle", 1e-4 * HZ, frequency_pulling),
    encoder(1),
    encoder(2),
    added_rate("temperature_squared", "temperature", 0.01 * DEG_PER_H, squared_temperature),
    added_rate("temperature_hysteresis", "temperature", 0.01 * DEG_PER_H, hysteresis),
    shown("temperature_sensor_lag", "temperature", 10.0, sensor_lag),
    added_rate("scale_factor_asymmetry", "rate", 10 * PPM, asymmetry),
    added_rate("rate_squared", "rate", 10 * PPM, squared_rate),
    added_rate("rate_cubed", "rate", 10 * PPM, cubed_rate),
    physical("gain_acceleration_squared", "acceleration", 5e-7, squared_acceleration),
    physical("cross_axis_acceleration", "acceleration", 1e-6, cross_axis),
    physical("split_acceleration", "acceleration", 1e-5, split_by_acceleration),
    added_rate("amplitude_squared", "amplitude", 0.1 * DEG_PER_H, squared_amplitude),
    added_rate("warm_up", "time", 0.05 * DEG_PER_H, warm_up),
    added_rate("bias_jump", "time", 0.05 * DEG_PER_H, jump),
    added_rate("periodic", "time", 0.05 * DEG_PER_H, periodic),
    physical(
        "decay_time_ageing",
        "time",
        1e-9,
        lambda generator: {"resonator.material.decayTimeAgeing": 1.0},
    ),
    Form("charge", "time", CHARGE, charge),
    added_rate("noise_bursts", "noise", 3e-7, bursts),
)
