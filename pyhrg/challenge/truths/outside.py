"""Forms of errors of gyro and bench that the catalogue lacks, written without sight of the terms
that a diagnosis proposes.

Each has a place, a coordinate, a typical size and a shape of about 1. What a shape draws is uniform
in the range that stands in it; a sign is drawn for each. A truth draws the size for a strength of
6 to 60 sigma, at most 30 typical sizes (`truth.py`). The module is loaded by name alone
(`form.FORMS_MODULE`).
"""

import math
from dataclasses import replace

import numpy as np

from pyhrg.bench.programme import Course
from pyhrg.challenge.campaigns.gyro import Disturbance
from pyhrg.challenge.truths.conditions import Conditions
from pyhrg.challenge.truths.entry import (
    Shape,
    command,
    damp,
    damp_along_axis,
    detune,
    misread,
    show,
    turn,
    turn_by_amplitude,
    vary,
)
from pyhrg.challenge.truths.form import Disturb, Form, apply_play, draw_sign
from pyhrg.common.arrays import Array
from pyhrg.common.units import ARCSEC, DEG, DEG_PER_H, HZ, MINUTE, PPM, STANDARD_GRAVITY
from pyhrg.device.device import Device
from pyhrg.records import Log

KELVINS = 30.0
"""Change of temperature at which an error over temperature has its typical size, K."""
FAST, SLOW = 100 * DEG, 1 * DEG
"""Rates at which an error over the rate has its typical size, rad/s."""
CHARGE = 1e-4
"""Drift of the bias voltage, relative, 1/h."""

# Shapes


def wave(order: int) -> Shape:
    """A harmonic of the pattern angle."""
    return lambda now, draw: np.sin(order * now.wave_angle + draw.uniform(0, 2 * math.pi))


def swing(shortest: float, longest: float) -> Shape:
    """A sine over time, of a period in this range, s."""

    def shape(now: Conditions, draw: np.random.Generator) -> Array:
        phase, period = draw.uniform(0, 2 * math.pi), draw.uniform(shortest, longest)
        return np.sin(2 * math.pi * now.time / period + phase)

    return shape


def fade(shortest: float, longest: float) -> Shape:
    """An exponential decay after power-on, of a time constant in this range, s."""
    return lambda now, draw: np.exp(-now.time / draw.uniform(shortest, longest))


def warm(power: int) -> Shape:
    """A power of the resonator's temperature above the reference."""
    return lambda now, draw: (now.warmth / KELVINS) ** power


def hysteresis(now: Conditions, draw: np.random.Generator) -> Array:
    """Half the width of a play of 5 to 20 K, on the side from which the temperature came."""
    width = draw.uniform(5, 20)
    return (now.case - apply_play(now.case.ravel(), width).reshape(now.case.shape)) / width


def jump(now: Conditions, draw: np.random.Generator) -> Array:
    """A step after 30 to 70 % of the test."""
    return (now.time > draw.uniform(0.3, 0.7) * now.time.max()).astype(float)


def popcorn(now: Conditions, draw: np.random.Generator) -> Array:
    """Two levels, each held for a random time of 60 to 600 s in the mean."""
    dwell, own = draw.uniform(60, 600), _draw_anew(now, draw)
    longest = now.time.max()
    switches = np.cumsum(own.exponential(dwell, 10 + math.ceil(3 * longest / dwell)))
    return np.asarray(np.searchsorted(switches, now.time) % 2 - 0.5)


def noise(now: Conditions, draw: np.random.Generator) -> Array:
    """(n, 1) white noise of unit density, another in each test."""
    own = _draw_anew(now, draw)
    return own.standard_normal((len(now.time), 1)) / math.sqrt(now.interval)


def bursts(now: Conditions, draw: np.random.Generator) -> Array:
    """Noise in a tenth of the spells of two minutes."""
    spell = (np.arange(len(now.time)) * now.interval // 120).astype(int)
    loud = _draw_anew(now, draw).random(int(spell[-1]) + 1) < 0.1
    return noise(now, draw) * loud[spell, None]


def scratch(now: Conditions, draw: np.random.Generator) -> Array:
    """A bump of 2 to 10 deg at one table angle, less its value at power-on."""
    place, width = draw.uniform(-math.pi, math.pi), draw.uniform(2, 10) * DEG

    def bump(angle: Array) -> Array:
        away = np.remainder(angle - place + math.pi, 2 * math.pi) - math.pi
        return np.asarray(np.exp(-((away / width) ** 2) / 2))

    return np.asarray(bump(now.table_angle) - bump(np.zeros(1)))


def friction_peak(now: Conditions, draw: np.random.Generator) -> Array:
    """A peak of 4 to 12 K at a temperature within 20 K of the reference."""
    peak, width = draw.uniform(-20, 20), draw.uniform(4, 12)
    return np.asarray(np.exp(-(((now.warmth - peak) / width) ** 2) / 2))


def _draw_anew(now: Conditions, draw: np.random.Generator) -> np.random.Generator:
    """A generator that differs between tests of different length."""
    return np.random.default_rng([int(draw.integers(2**31)), len(now.time)])


# Ways to enter that one form has


def across(parameter: str, scale: float) -> Disturb:
    """A parameter of the FMU by specific force along x or y, the axes across the input axis."""

    def disturb(device: Device, size: float, generator: np.random.Generator) -> Disturbance:
        axis = generator.choice((1, 2))
        return Disturbance(model={f"{parameter}[{axis}]": size * scale * draw_sign(generator)})

    return disturb


def charge(device: Device, size: float, generator: np.random.Generator) -> Disturbance:
    """A drifting bias voltage: frequency and split move with its square."""
    softening = {
        "resonator.material.electrostaticShift": 3.0,
        "resonator.material.electrostaticSplit": 0.3,
        "resonator.material.electrostaticAxis": generator.uniform(0, math.pi / 2),
    }

    def drifting(course: Course, start: float) -> dict[str, Array]:
        hours = (np.arange(len(course)) + 0.5) * course.interval / 3600
        return {"bias_voltage": 1 + size * CHARGE * hours}

    return Disturbance(model=softening, inputs=drifting)


def age(device: Device, size: float, generator: np.random.Generator) -> Disturbance:
    """A decay time that becomes shorter."""
    return Disturbance(model={"resonator.material.decayTimeAgeing": size * 1e-9})


def backlash(device: Device, size: float, generator: np.random.Generator) -> Disturbance:
    """An encoder with a play of 1 arcsec."""

    def change(log: Log) -> Log:
        angle = apply_play(np.append(0.0, log.table_angle), size * ARCSEC)[1:]
        return replace(log, table_angle=angle)

    return Disturbance(shown=change)


# Name, place, coordinate, way to enter with typical size and shape, reason

FORMS = (
    Form("bias_harmonic_2", "bias", "wave_angle", turn(0.1 * DEG_PER_H, wave(2)),
         "A shell that sits off centre has a gap that varies once round."),
    Form("bias_harmonic_6", "bias", "wave_angle", turn(0.1 * DEG_PER_H, wave(6)),
         "The wall's thickness has a sixth harmonic of machining."),
    Form("bias_harmonic_12", "bias", "wave_angle", turn(0.1 * DEG_PER_H, wave(12)),
         "Electrodes and the gaps between them repeat round the shell."),
    Form("magnetic_torque", "bias", "table_angle",
         turn(0.05 * DEG_PER_H,
              lambda now, draw: np.sin(2 * now.table_angle + draw.uniform(0, 2 * math.pi))),
         "Soft iron in the mount turns in the Earth's magnetic field."),
    Form("temperature_squared", "bias", "temperature", turn(0.01 * DEG_PER_H, warm(2)),
         "Two materials of the mount expand differently, to second order too."),
    Form("temperature_hysteresis", "bias", "temperature", turn(0.01 * DEG_PER_H, hysteresis),
         "A glued joint creeps on heating and does not return on the same way."),
    Form("acceleration_squared", "bias", "acceleration",
         turn(0.05 * DEG_PER_H, lambda now, draw: (now.acceleration[2] / STANDARD_GRAVITY) ** 2),
         "Weight along the stem bends the shell the same way up and down."),
    Form("amplitude_squared", "bias", "amplitude",
         turn_by_amplitude(0.1 * DEG_PER_H, lambda now, draw: now.amplitude**2 - 1),
         "Cubic elasticity turns a pattern with a residual quadrature by its energy."),
    Form("warm_up", "bias", "time", turn(0.05 * DEG_PER_H, fade(300, 1500)),
         "Electronics warm up after power-on where no thermometer is."),
    Form("bias_creep", "bias", "time",
         turn(0.01 * DEG_PER_H, lambda now, draw: np.log1p(now.time / draw.uniform(20, 200))),
         "Glue relaxes with the logarithm of time."),
    Form("bias_jump", "bias", "time", turn(0.05 * DEG_PER_H, jump),
         "A crack or a loose particle changes the balance at once."),
    Form("periodic", "bias", "time", turn(0.05 * DEG_PER_H, swing(60, 900)),
         "A controller of temperature switches on and off."),
    Form("scale_factor_asymmetry", "readout", "rate",
         turn(10 * PPM, lambda now, draw: np.abs(now.rate)),
         "A counter of increments loses some in one direction."),
    Form("rate_squared", "readout", "rate",
         turn(10 * PPM, lambda now, draw: now.rate * np.abs(now.rate) / FAST),
         "Friction of a fast table heats its mount and strains it."),
    Form("rate_cubed", "readout", "rate",
         turn(10 * PPM, lambda now, draw: now.rate * (now.rate / FAST) ** 2),
         "Centrifugal force widens the shell, which changes the angular gain."),
    Form("truncation", "readout", "rate",
         turn(0.05 * DEG_PER_H, lambda now, draw: np.tanh(now.rate / SLOW)),
         "A read-out that truncates towards zero loses a part of each step."),
    Form("arctangent_table", "readout", "wave_angle", misread(0.1 * ARCSEC, wave(16)),
         "A table of arctangents with few entries errs between them."),
    Form("damping_amplitude", "damping", "amplitude",
         damp(3e-8, lambda now, draw: now.amplitude**2 - 1),
         "Friction in the coating grows with the strain."),
    Form("anisotropy_amplitude", "damping", "amplitude",
         damp_along_axis(1e-7, lambda now, draw: now.amplitude**2 - 1),
         "A joint that slips at large amplitudes damps along one axis."),
    Form("desorption", "damping", "time", damp(1e-8, fade(200, 1000)),
         "A film of water leaves the shell after power-on."),
    Form("friction_peak", "damping", "temperature", damp(1e-8, friction_peak),
         "Internal friction of a coating peaks at a transition."),
    Form("decay_time_ageing", "damping", "time", age,
         "The vacuum becomes worse."),
    Form("frequency_pulling", "stiffness", "wave_angle",
         show("frequency_offset", 1e-4 * HZ, wave(2)),
         "One electrode with another gap softens the shell where the pattern passes it."),
    Form("frequency_fourth_power", "stiffness", "amplitude",
         detune(1e-4 * HZ, lambda now, draw: now.amplitude**4 - 1),
         "The force over a gap has higher orders where the vibration fills it."),
    Form("frequency_temperature_squared", "stiffness", "temperature",
         show("frequency_offset", 1e-3 * HZ, warm(2)),
         "The modulus of silica has a second-order temperature coefficient."),
    Form("gradient_stress", "stiffness", "temperature_rate",
         show("frequency_offset", 1e-3 * HZ, lambda now, draw: now.warming * MINUTE),
         "A gradient from stem to rim stresses the shell while the case warms."),
    Form("spin_softening", "stiffness", "rate",
         show("frequency_offset", 1e-5 * HZ, lambda now, draw: (now.rate / FAST) ** 2),
         "Centrifugal force changes the stiffness of a turning shell."),
    Form("split_temperature", "stiffness", "temperature",
         vary("resonator.material.splitPerAcceleration", 1e-6 * HZ, warm(1)),
         "A trimmed split is the difference of two that change differently."),
    Form("split_acceleration", "stiffness", "acceleration",
         across("resonator.material.splitPerAcceleration", 1e-5),
         "Weight bends the stem and makes the gaps uneven."),
    Form("charge", "stiffness", "time", charge,
         "Charge drifts on the glass between the electrodes."),
    Form("gain_acceleration_squared", "pickoff", "acceleration",
         across("pickOff.gainPerAccelerationSquared", 5e-7),
         "Weight closes a gap to second order."),
    Form("gain_swing", "pickoff", "time",
         vary("pickOff.gainPerAcceleration", 1e-6, swing(100, 1000)),
         "The supply of one channel's preamplifier swings with the room's air."),
    Form("cross_axis_acceleration", "drive", "acceleration",
         across("drive.rotationPerAcceleration", 1e-6),
         "Weight across the stem twists the block of electrodes."),
    Form("joint_slip", "drive", "temperature",
         vary("drive.rotationPerAcceleration", 1e-5, lambda now, draw: np.maximum.accumulate(
             np.abs(now.warmth).ravel()).reshape(now.warmth.shape) / KELVINS),
         "The drives' joint slips where it is hotter or colder than ever, and stays."),
    Form("virtual_rotation_asymmetry", "drive", "rate",
         turn(0.05 * DEG_PER_H, lambda now, draw: np.abs(now.virtual_rotation) / SLOW),
         "A drive amplifier pulls harder than it pushes."),
    Form("reference_voltage", "electronics", "temperature",
         command("amplitude_setpoint", 1e-6, warm(1)),
         "The reference of the amplitude loop has a temperature coefficient."),
    Form("phase_settling", "electronics", "time",
         command("phase_offset", 1e-5, fade(100, 1000)),
         "A filter's capacitor polarizes after power-on."),
    Form("popcorn", "electronics", "time", turn(0.05 * DEG_PER_H, popcorn),
         "A trap in a transistor fills and empties."),
    Form("noise_bursts", "electronics", "noise", turn(3e-7, bursts),
         "A contact is bad at times."),
    Form("noise_of_rate", "electronics", "noise",
         turn(3e-7, lambda now, draw: noise(now, draw) * np.abs(now.rate) / FAST),
         "A noisy reference multiplies the rate."),
    Form("encoder_scratch", "bench", "table_angle", show("table_angle", ARCSEC, scratch),
         "A scratch or a fingerprint is on the encoder's disc."),
    Form("encoder_backlash", "bench", "table_angle", backlash,
         "The encoder's coupling has play."),
    Form("table_sag", "bench", "acceleration",
         show("table_angle", ARCSEC, lambda now, draw: now.acceleration[0] / STANDARD_GRAVITY),
         "A tilted table twists between encoder and gyro."),
    Form("thermometer_draught", "bench", "time", show("temperature", 0.01, swing(300, 1500)),
         "The air of the room reaches the thermometer and not the gyro."),
)  # fmt: skip
"""Forms outside the catalogue."""
