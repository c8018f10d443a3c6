"""Records a test of the true gyro on the FMU, with rate noise that is drawn outside the FMU."""

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field, replace
from typing import Any

import numpy as np
from scipy.fft import irfft, next_fast_len, rfft, rfftfreq

from pyhrg.bench.bench import LOOP_OUTPUTS, OUTPUTS_AT_END, Bench, compute_earth_rate, record_rows
from pyhrg.bench.programme import HELD_INPUTS, LOGGED_COMMANDS, Course, interpolate_rows
from pyhrg.challenge.campaigns.instruments import Instruments, record_log
from pyhrg.common.arrays import Array
from pyhrg.device.device import Device
from pyhrg.fmu import GyroFmu
from pyhrg.records import Log

AXES = {"amplitude": "amplitude", "quadrature": "quadrature"}
"""The FMU's names of the half axes of the vibration's ellipse."""


@dataclass(frozen=True)
class Disturbance:
    """A disturbance of gyro or bench that is no parameter of the device; by default none.

    Attributes:
        model: parameters of the FMU, by its names, SI.
        rate: function of the course and the true start angle that returns an added input rate, (n,
            m) or (1, 1), rad/s.
        inputs: function of the same that returns inputs (n,) that hold over a row and differ from
            the bench's command, by their names in a programme, SI.
        rate_at_amplitude: function of the same and of the amplitude of the vibration, (n, m), that
            returns another added input rate, (n, m), rad/s.
        change_at_amplitude: function of the simulated log and the same three that returns the true
            log.
        shown: function of the true log that returns the log as the bench writes it.
    """

    model: Mapping[str, float] = field(default_factory=dict)
    rate: Callable[[Course, float], Array] = lambda course, start_angle: np.zeros((1, 1))
    inputs: Callable[[Course, float], Mapping[str, Array]] = lambda course, start_angle: {}
    rate_at_amplitude: Callable[[Course, float, Array], Array] | None = None
    change_at_amplitude: Callable[[Log, Course, float, Array], Log] | None = None
    shown: Callable[[Log], Log] = lambda log: log

    def compute_rate(self, course: Course, start_angle: float, amplitude: Array) -> Array:
        """Added input rate at an amplitude of the vibration, (n, m) or (1, 1), rad/s."""
        added = self.rate(course, start_angle)
        if self.rate_at_amplitude:
            added = added + self.rate_at_amplitude(course, start_angle, amplitude)
        return added

    def change_log(self, log: Log, course: Course, start_angle: float, amplitude: Array) -> Log:
        """The true log of a simulated one at an amplitude of the vibration, (n, m)."""
        if self.change_at_amplitude:
            log = self.change_at_amplitude(log, course, start_angle, amplitude)
        return log


@dataclass(frozen=True)
class TrueGyro:
    """The true gyro. With `HRGSlow` its loops are settled at all times."""

    fmu: GyroFmu
    device: Device
    instruments: Instruments = field(default_factory=Instruments)
    disturbance: Disturbance = field(default_factory=Disturbance)

    def log(
        self, source: str, course: Course, start_angle: float, generator: np.random.Generator
    ) -> tuple[Log, Array]:
        """Log of a test that starts at a true pattern angle, rad, and (n,) the part of noise in its
        output angle, rad.

        Noise turns the pattern as an input rate. The noise of the FMU is off, so the spectrum may
        differ from the FMU's, and the other channels have only the noise of their readings.
        """
        drawn = draw_rate_noise(self.device, len(course) * course.steps, course.step, generator)
        noise = drawn.reshape(len(course), course.steps)
        shown = self.disturbance.shown(self.exact(source, course, start_angle, noise))
        log = record_log(shown, self.device, self.instruments, generator)
        turned = np.cumsum(noise.sum(axis=1)) * course.step
        return log, log.gyro_angle - shown.gyro_angle + turned

    def exact(self, source: str, course: Course, start_angle: float, noise: Array) -> Log:
        """The log of bench and gyro without reading noise; `noise` is an input rate, (n, m) or
        (1, 1), rad/s, that is added to the bench's and Earth's."""
        disturbance, amplitude = self.disturbance, np.zeros((1, 1))
        if disturbance.rate_at_amplitude or disturbance.change_at_amplitude:
            amplitude = self._find_amplitude(source, course, start_angle)
        added = noise + disturbance.compute_rate(course, start_angle, amplitude)
        shown = self._simulate(source, course, start_angle, added, OUTPUTS_AT_END)
        columns: dict[str, Any] = {**{name: course.held[name] for name in LOGGED_COMMANDS}, **shown}
        log = Log(
            source=source,
            interval=course.interval,
            time=np.asarray(np.arange(1, len(course) + 1) * course.interval, dtype=np.float64),
            table_angle=course.table_angle_at_ends,
            temperature=course.case_temperature[1:],
            valid=np.full(len(course), np.nan),
            **columns,
        )
        return disturbance.change_log(log, course, start_angle, amplitude)

    def _simulate(
        self,
        source: str,
        course: Course,
        start_angle: float,
        added: Array,
        at_end: Mapping[str, str],
    ) -> dict[str, Array]:
        """(n,) outputs, by field, with an added input rate, (n, m) or (1, 1), rad/s."""
        held = {**course.held, **self.disturbance.inputs(course, start_angle)}
        commands = {name: held[name] for name in HELD_INPUTS}
        bench = Bench(self.fmu, self._quiet(commands, course.step), step=course.step)
        earth = compute_earth_rate(self.device, course.each("axis_up"), course.table_angle)
        moving = {"angularRate": course.rate + earth + added, "caseTemperature": course.temperature}
        with bench.power_on(source, start_angle) as gyro:
            return record_rows(gyro, moving, commands, course.step, LOOP_OUTPUTS, at_end)

    def _find_amplitude(self, source: str, course: Course, start_angle: float) -> Array:
        """(n, m) amplitude of the vibration, by the energy of both its axes, linear between the
        rows' ends, without a rate that depends on it."""
        axes = self._simulate(source, course, start_angle, np.zeros((1, 1)), AXES)
        ends = np.hypot(axes["amplitude"], axes["quadrature"])
        return interpolate_rows(np.append(ends[:1], ends), course.share)

    def _quiet(self, commands: Mapping[str, Array], step: float) -> Device:
        """The device without noise, with its first commands from time 0 on."""
        first = {HELD_INPUTS[name]: float(values[0]) for name, values in commands.items()}
        quiet = self.device.without_noise()
        period = {} if self.fmu.is_sampled else {"samplePeriod": step}
        model = {**quiet.model, **self.disturbance.model, **first, **period}
        return replace(quiet, quantization_step=0.0, model=model)


def draw_rate_noise(
    device: Device, count: int, step: float, generator: np.random.Generator
) -> Array:
    """(count,) input-referred rate noise of a device, rad/s, each value the mean over a step, s.

    Densities are those of IEEE Std 952, annex C: N^2, B^2/(2 pi f), K^2/(2 pi f)^2. The same
    numbers are drawn whatever the coefficients are.
    """
    white, coloured, steps = generator.standard_normal((3, 2 * count))
    rate = device.angle_random_walk / math.sqrt(step) * white[:count]
    if device.bias_instability:
        rate += device.bias_instability * _flicker(coloured, step)[:count]
    walk = np.cumsum(steps[:count]) - steps[:count] / 2
    return np.asarray(rate + device.rate_random_walk * math.sqrt(step) * walk)


def _flicker(white: Array, step: float) -> Array:
    """Flicker of unit coefficient, by shaping white noise in frequency. The period is twice the
    record, so that start and end are not correlated."""
    length = next_fast_len(len(white), real=True)
    frequency = rfftfreq(length, step)
    frequency[0] = frequency[1] / 2
    padded = np.concatenate((white, white[: length - len(white)]))
    shaped = rfft(padded) / np.sqrt(2 * math.pi * frequency * step)
    return np.asarray(irfft(shaped, length))
