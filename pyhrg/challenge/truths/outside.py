"""Forms of errors of gyro and bench that the catalogue lacks.

A form is physical where the FMU has a parameter for it that no catalogued effect uses. Otherwise it
adds to the input rate, to an input, or to what the bench shows. The module is loaded by name alone
(`form.FORMS_MODULE`).
"""

import math
from dataclasses import replace

import numpy as np
from scipy.signal import lfilter

from pyhrg.challenge.campaigns.course import Course
from pyhrg.challenge.campaigns.gyro import Disturbance
from pyhrg.challenge.truths.form import (
    Form,
    Shape,
    apply_play,
    draw_sign,
    find_ideal_pattern_angle,
    find_resonator_warmth,
    make_rate_form,
    make_signed_rate_form,
)
from pyhrg.common.arrays import Array
from pyhrg.common.units import ARCSEC, DEG, DEG_PER_H, HZ, PPM
from pyhrg.device.device import Device
from pyhrg.records import Log

# Pattern angle


def harmonic(order: int) -> Form:
    """A bias proportional to a harmonic of the pattern angle."""

    def shaped(device: Device, generator: np.random.Generator) -> Shape:
        phase = generator.uniform(0, 2 * math.pi)
        return lambda course, start: np.sin(
            order * find_ideal_pattern_angle(device, course, start) + phase
        )

    return make_rate_form(f"bias_harmonic_{order}", "wave_angle", 0.1 * DEG_PER_H, shaped)


def frequency_pulling(device: Device, size: float, generator: np.random.Generator) -> Disturbance:
    """A loop frequency with a second harmonic of the pattern angle."""
    amplitude, phase = size * (1e-4 * HZ), generator.uniform(0, 2 * math.pi)

    def change(log: Log) -> Log:
        pulled = amplitude * np.sin(2 * log.wave_angle + phase)
        return replace(log, frequency_offset=log.frequency_offset + pulled)

    return Disturbance(shown=change)


# Table


def encoder(order: int) -> Form:
    """An encoder whose disc is elliptic (order 2) or has three lobes."""

    def disturb(device: Device, size: float, generator: np.random.Generator) -> Disturbance:
        amplitude, phase = size * (5 * ARCSEC), generator.uniform(0, 2 * math.pi)

        def change(log: Log) -> Log:
            error = amplitude * (np.sin(order * log.table_angle + phase) - math.sin(phase))
            return replace(log, table_angle=log.table_angle + error)

        return Disturbance(shown=change)

    return Form(f"encoder_harmonic_{order}", "table_angle", disturb, ("table_ripple",))


# Temperature


def hysteresis(device: Device, generator: np.random.Generator) -> Shape:
    """A bias with hysteresis over temperature."""
    way, width = draw_sign(generator), generator.uniform(5, 20)

    def shape(course: Course, start: float) -> Array:
        case = course.case_temperature
        left = (case - apply_play(case, width)) / width
        return np.asarray(way * (left[1:] + left[:-1])[:, None] / 2)

    return shape


def sensor_lag(device: Device, size: float, generator: np.random.Generator) -> Disturbance:
    """A temperature sensor with a lag of 10 s times the size."""

    def change(log: Log) -> Log:
        kept = math.exp(-log.interval / max(size * 10.0, 1e-9))
        above = log.temperature - device.reference_temperature
        lagged = lfilter([1 - kept], [1, -kept], above)
        return replace(log, temperature=device.reference_temperature + lagged)

    return Disturbance(shown=change)


# Acceleration


def across(name: str, parameter: str, scale: float) -> Form:
    """An effect of the specific force along x or y, the axes across the input axis, with a sign."""

    def disturb(device: Device, size: float, generator: np.random.Generator) -> Disturbance:
        axis = generator.choice((1, 2))
        return Disturbance(model={f"{parameter}[{axis}]": size * scale * draw_sign(generator)})

    return Form(name, "acceleration", disturb)


# Time


def warm_up(device: Device, generator: np.random.Generator) -> Shape:
    """A bias that decays after power-on."""
    way, lag = draw_sign(generator), generator.uniform(300, 1500)
    return lambda course, start: way * np.exp(-course.time / lag)


def jump(device: Device, generator: np.random.Generator) -> Shape:
    """A bias that jumps at one moment."""
    way, share = draw_sign(generator), generator.uniform(0.3, 0.7)
    return lambda course, start: (
        way * (course.time > share * len(course) * course.interval).astype(np.float64)
    )


def periodic(device: Device, generator: np.random.Generator) -> Shape:
    """A periodic bias."""
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
    """Bursts of rate noise, two minutes each."""
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
    Form("frequency_pulling", "wave_angle", frequency_pulling),
    encoder(3),
    encoder(2),
    # a bias proportional to the square of the temperature
    make_signed_rate_form(
        "temperature_squared",
        "temperature",
        0.01 * DEG_PER_H,
        lambda device, course: (find_resonator_warmth(device, course) / 30) ** 2,
    ),
    make_rate_form("temperature_hysteresis", "temperature", 0.01 * DEG_PER_H, hysteresis),
    Form("temperature_sensor_lag", "temperature", sensor_lag, ("thermometer_lag",)),
    # a scale factor that differs between the two directions of rotation
    make_signed_rate_form(
        "scale_factor_asymmetry", "rate", 10 * PPM, lambda device, course: np.abs(course.rate)
    ),
    # scale-factor errors proportional to the rate and to its square, of unit size at 100 deg/s
    make_signed_rate_form(
        "rate_squared",
        "rate",
        10 * PPM,
        lambda device, course: course.rate * np.abs(course.rate / (100 * DEG)),
    ),
    make_signed_rate_form(
        "rate_cubed",
        "rate",
        10 * PPM,
        lambda device, course: course.rate * (course.rate / (100 * DEG)) ** 2,
    ),
    # pick-off gain by the square of the force; direction of the force frame; frequency split
    across("gain_acceleration_squared", "pickOff.gainPerAccelerationSquared", 5e-7),
    across("cross_axis_acceleration", "drive.rotationPerAcceleration", 1e-6),
    across("split_acceleration", "resonator.material.splitPerAcceleration", 1e-5),
    # a bias proportional to the square of the amplitude, zero at the nominal one
    make_signed_rate_form(
        "amplitude_squared",
        "amplitude",
        0.1 * DEG_PER_H,
        lambda device, course: course.each("amplitude_setpoint") ** 2 - 1,
    ),
    make_rate_form("warm_up", "time", 0.05 * DEG_PER_H, warm_up),
    make_rate_form("bias_jump", "time", 0.05 * DEG_PER_H, jump),
    make_rate_form("periodic", "time", 0.05 * DEG_PER_H, periodic),
    Form(
        "decay_time_ageing",
        "time",
        lambda device, size, generator: Disturbance(
            model={"resonator.material.decayTimeAgeing": size * 1e-9}
        ),
    ),
    Form("charge", "time", charge),
    make_rate_form("noise_bursts", "noise", 3e-7, bursts),
)
