"""Campaigns of a gyro with an error that the catalogue lacks."""

from collections.abc import Callable, Sequence
from dataclasses import replace

import numpy as np

from pyhrg.bench.bench import Bench, PowerOn
from pyhrg.bench.programme import Course, make_course
from pyhrg.challenge.campaigns.gyro import Disturbance, TrueGyro
from pyhrg.challenge.truths.form import find_ideal_pattern_angle
from pyhrg.common.arrays import Array
from pyhrg.common.units import ARCSEC, DEG_PER_H
from pyhrg.device.device import Device
from pyhrg.fmu import GyroFmu
from pyhrg.records import Log
from pyhrg.records.campaign import Campaign, Test
from tests.pyhrg.gap.bench import short, stated
from tests.pyhrg.gap.soundness.conftest import NOMINAL

GAIN, GROWTH = NOMINAL.bryan_factor, 1 / NOMINAL.decay_time
COS6, SIN6 = 0.6, -0.4
"""Coefficients of the bias, deg/h."""


def record_planted(
    fmu: GyroFmu,
    disturbance: Disturbance,
    seed: int = 3,
    power_ons: Sequence[PowerOn] | None = None,
    device: Device = NOMINAL,
) -> Campaign:
    """A campaign of a device with a disturbance, by default a short one, where `NOMINAL` is told;
    a manoeuvre is held out."""
    generator = np.random.default_rng(seed)
    gyro = TrueGyro(fmu, device, disturbance=disturbance)
    tests = []
    for power_on in short(Bench(fmu, NOMINAL)) if power_ons is None else power_ons:
        course = make_course(power_on.programme, power_on.programme.interval / 100)
        start = generator.uniform(0, 1.5)
        log, _ = gyro.log(power_on.id, course, start, generator)
        role = "holdout" if power_on.kind == "manoeuvre" else "fit"
        tests.append(Test(power_on.id, power_on.kind, role, log))
    return Campaign("planted", NOMINAL.site, stated(NOMINAL), tuple(tests))


def triangle(angle: Array) -> Array:
    """A triangular wave: a cosine with a ninth of its third harmonic, and less of others."""
    return np.asarray(2 / np.pi * np.arcsin(np.cos(angle)))


def shift_angle(log: Log, error: Array) -> Log:
    """A log whose angles are read with an error of the output angle, rad."""
    return replace(log, gyro_angle=log.gyro_angle + error, wave_angle=log.wave_angle - GAIN * error)


def plant_electrode_error(
    shape: Callable[[Array, Array], Array], arcsec: float, is_pickoff: bool
) -> Callable[[float], Disturbance]:
    """An error of the pick-off, or of the drive alone, by pattern angle and amplitude, at a size:
    the forces of all loops point beside the pattern."""

    def disturb(size: float) -> Disturbance:
        unit = size * arcsec * ARCSEC

        def rate(course: Course, start: float) -> Array:
            angle = find_ideal_pattern_angle(NOMINAL, course, start)
            level = course.each("amplitude_setpoint") / NOMINAL.amplitude
            before = np.vstack([np.ones_like(level[:1]), level[:-1]])
            change = np.log(level / before) / course.interval
            middle = shape(angle, np.sqrt(before * level))
            mean = (shape(angle, before) + 4 * middle + shape(angle, level)) / 6  # of the change
            pushed = shape(angle, level) * GROWTH + mean * change
            return np.asarray(unit * pushed * course.each("drive_on"))

        def show(log: Log) -> Log:
            error = unit * shape(log.wave_angle, log.amplitude)
            held = 4 * GAIN**2 * log.virtual_rotation * error
            pushed = replace(
                log,
                amplitude_force=log.amplitude_force - held * log.is_driven,
                frequency_offset=log.frequency_offset - 2 * GAIN * log.quadrature_force * error,
            )
            return shift_angle(pushed, error) if is_pickoff else pushed

        return Disturbance(rate=rate, shown=show)

    return disturb


def plant_drive_gain(
    shape: Callable[[Array], Array], ratio: float
) -> Callable[[float], Disturbance]:
    """A gain of the drive by the pattern angle: rotation is larger, commanded forces smaller."""

    def disturb(size: float) -> Disturbance:
        def rate(course: Course, start: float) -> Array:
            angle = find_ideal_pattern_angle(NOMINAL, course, start)
            return np.asarray(-size * ratio * shape(angle) * course.each("virtual_rotation"))

        def show(log: Log) -> Log:
            gain = 1 + size * ratio * shape(log.wave_angle)
            return replace(
                log,
                amplitude_force=log.amplitude_force / gain,
                quadrature_force=log.quadrature_force / gain,
            )

        return Disturbance(rate=rate, shown=show)

    return disturb


def record_sixth_harmonic(fmu: GyroFmu, seed: int = 3) -> Campaign:
    """The bias enters as an input rate, computed apart from any candidate term."""

    def rate(course: Course, start: float) -> np.ndarray:
        angle = 6 * find_ideal_pattern_angle(NOMINAL, course, start)
        return np.asarray((COS6 * np.cos(angle) + SIN6 * np.sin(angle)) * DEG_PER_H)

    return record_planted(fmu, Disturbance(rate=rate), seed)
