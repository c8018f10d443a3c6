"""Programme of a power-on: what the bench does to the gyro, row by row and step by step."""

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from operator import itemgetter

import numpy as np

from pyhrg.bench.outcome import BenchError
from pyhrg.common.arrays import Array

HELD_INPUTS = {
    "acceleration_x": "accelerationX",
    "acceleration_y": "accelerationY",
    "acceleration_z": "accelerationZ",
    "virtual_rotation": "virtualRotation",
    "amplitude_setpoint": "amplitudeSetpoint",
    "phase_offset": "phaseOffset",
    "drive_on": "driveOn",
    "vibration": "vibration",
    "bias_voltage": "biasVoltage",
}
"""The FMU's names of its inputs that are constant within a row, by their name in a programme."""
COMMANDS = ("axis_up", *HELD_INPUTS)
"""Quantities that are constant within a row. Case temperature and table rate are not among them:
they change linearly within a row."""
LOGGED_COMMANDS = tuple(name for name in COMMANDS if name not in ("vibration", "bias_voltage"))
"""Quantities of a programme that a log has as columns."""
MAX_ROWS = 500_000
"""Largest number of rows of a programme. Chosen: ten times those of the longest test; with the
inputs of their communication steps they take about 1 GB."""


class Programme:
    """Rows of equal length, appended manoeuvre by manoeuvre.

    At the beginning the table rests, the input axis points up and the drive is on. The methods that
    append or command return the programme, so that calls can be chained.
    """

    def __init__(self, interval: float, gravity: float, temperature: float = 298.15) -> None:
        """Make an empty programme.

        The interval is that of a row, s; gravity at the site in m/s2; temperature of the case at
        power-on in K.
        """
        self.interval = interval
        self.gravity = gravity
        self._commands = dict.fromkeys(COMMANDS, 0.0)
        self._commands.update(axis_up=1.0, acceleration_z=gravity)
        self._commands.update(amplitude_setpoint=1.0, drive_on=1.0, bias_voltage=1.0)
        self._rates = [0.0]
        self._temperatures = [temperature]
        self._rows: list[dict[str, float]] = []

    def __len__(self) -> int:
        return len(self._rows)

    @property
    def time(self) -> float:
        """Duration so far, s."""
        return len(self) * self.interval

    def command(self, **quantities: float) -> "Programme":
        """Set quantities (`COMMANDS`), SI, for the rows that follow."""
        unknown = quantities.keys() - self._commands.keys()
        if unknown:
            raise ValueError(f"no such command: {', '.join(sorted(unknown))}")
        self._commands.update(quantities)
        return self

    def override(self, **quantities: Array) -> "Programme":
        """Replace quantities (`COMMANDS`) of the n rows so far, (n,) each, SI."""
        for name, series in quantities.items():
            if name not in self._commands or len(series) != len(self):
                raise ValueError(f"{name}: expected a command and {len(self)} values")
            values = zip(self._rows, series.tolist(), strict=True)
            self._rows = [{**row, name: value} for row, value in values]
        return self

    def current(self, name: str) -> float:
        """Value of a quantity (`COMMANDS`) for the rows that follow, SI."""
        return self._commands[name]

    def attitude(self, axis_up: float, across: float = 0.0) -> "Programme":
        """Tilt the input axis towards east: Earth's rate on it is then axis_up W_E sin L.

        `axis_up` is the cosine of the angle between the input axis and local up; `across` the angle
        about the input axis from the vertical plane to the x electrodes, rad.
        """
        level = self.gravity * math.sqrt(max(0.0, 1 - axis_up**2))
        return self.command(
            axis_up=axis_up,
            acceleration_x=level * math.cos(across),
            acceleration_y=level * math.sin(across),
            acceleration_z=self.gravity * axis_up,
        )

    def rest(self, duration: float) -> "Programme":
        """Rest the table for a time, s."""
        return self.spin(0.0, duration)

    def spin(self, rate: float, duration: float) -> "Programme":
        """Turn the table at a rate, rad/s, that it reaches within the first row, for a time, s."""
        rows = self._count(duration)
        return self._append([rate] * rows, self._temperatures[-1:] * rows)

    def turn(self, angle: float, rate: float) -> "Programme":
        """Turn the table by an angle, rad, no faster than `rate`, rad/s, and stop it."""
        rows = max(2, math.ceil(abs(angle) / (abs(rate) * self.interval)) + 1)
        peak = angle / ((rows - 1) * self.interval)
        return self.spin(peak, (rows - 1) * self.interval).spin(0.0, self.interval)

    def heat(self, temperature: float, duration: float) -> "Programme":
        """Change the case's temperature linearly to one in K within a time, s, at rest."""
        rows = self._count(duration)
        begin = self._temperatures[-1]
        heated = [begin + (temperature - begin) * row / rows for row in range(1, rows + 1)]
        return self._append([0.0] * rows, heated)

    def set_temperatures(self, temperatures: Array) -> "Programme":
        """Replace the case's temperature at the bounds of the n rows so far, (n + 1,), K."""
        if len(temperatures) != len(self) + 1:
            raise ValueError(f"expected {len(self) + 1} temperatures, found {len(temperatures)}")
        self._temperatures = temperatures.tolist()
        return self

    def values(self, name: str) -> Array:
        """(n,) values of a quantity (`COMMANDS`) in each row, SI."""
        return np.fromiter(map(itemgetter(name), self._rows), float, len(self))

    @property
    def temperature(self) -> Array:
        """(n + 1,) temperature of the case at the bounds of the rows, K."""
        return np.array(self._temperatures)

    @property
    def table_rate(self) -> Array:
        """(n + 1,) rate of the table at the bounds of the rows, rad/s; linear between them."""
        return np.array(self._rates)

    @property
    def table_angle(self) -> Array:
        """(n,) angle of the table at the ends of the rows, rad."""
        rate = self.table_rate
        return np.asarray(np.cumsum((rate[1:] + rate[:-1]) / 2) * self.interval)

    def _count(self, duration: float) -> int:
        if len(self) + duration / self.interval > MAX_ROWS:
            raise BenchError(
                f"a plan of {self.time + duration:g} s: expected at most {MAX_ROWS} rows of "
                f"{self.interval:g} s"
            )
        rows = round(duration / self.interval)
        if rows < 0 or abs(rows * self.interval - duration) > 1e-6 * max(duration, self.interval):
            raise ValueError(f"{duration:g} s is no multiple of the rows' {self.interval:g} s")
        return rows

    def _append(self, rates: Sequence[float], temperatures: Sequence[float]) -> "Programme":
        self._rates += rates
        self._temperatures += temperatures
        self._rows += [dict(self._commands)] * len(rates)
        return self


@dataclass(frozen=True)
class Course:
    """A test of n rows of m communication steps each; SI. Arrays by step are (n, m), at the
    steps' middles."""

    interval: float
    """Length of a row, s."""
    step: float
    """Communication step, s."""
    table_rate: Array
    """(n + 1,) at the rows' bounds, linear between them."""
    case_temperature: Array
    """(n + 1,) at the rows' bounds, linear between them."""
    held: Mapping[str, Array]
    """(n,) commands and attitude that hold over a row, by their names in a programme."""

    def __len__(self) -> int:
        return len(self.table_rate) - 1

    @property
    def steps(self) -> int:
        """Communication steps in a row."""
        return round(self.interval / self.step)

    @cached_property
    def share(self) -> Array:
        """(m,) share of a row that is over at the middle of each step."""
        return compute_step_middles(self.steps)

    @cached_property
    def time(self) -> Array:
        """(n, m) time since power-on, s."""
        return (np.arange(len(self))[:, None] + self.share) * self.interval

    @cached_property
    def rate(self) -> Array:
        """(n, m) rate of the table, rad/s."""
        return interpolate_rows(self.table_rate, self.share)

    @cached_property
    def table_angle_at_ends(self) -> Array:
        """(n,) angle of the table at the rows' ends, rad."""
        means = (self.table_rate[1:] + self.table_rate[:-1]) / 2
        return np.asarray(np.cumsum(means) * self.interval)

    @cached_property
    def table_angle(self) -> Array:
        """(n, m) angle of the table, rad; 0 at the start."""
        begun = np.concatenate(([0.0], self.table_angle_at_ends[:-1]))[:, None]
        return begun + self.interval * self.share * interpolate_rows(
            self.table_rate, self.share / 2
        )

    @cached_property
    def temperature(self) -> Array:
        """(n, m) temperature of the case, K."""
        return interpolate_rows(self.case_temperature, self.share)

    def each(self, name: str) -> Array:
        """(n, m) a command or attitude that holds over each row."""
        return np.broadcast_to(self.held[name][:, None], (len(self), self.steps))

    def integrate(self, rate: Array) -> Array:
        """Integral of a rate, from the start to the middle of each step."""
        total = np.cumsum(rate.ravel()) * self.step
        return np.asarray((total - rate.ravel() * self.step / 2).reshape(rate.shape))


def make_course(programme: Programme, step: float) -> Course:
    """The course of a programme, whose rows are multiples of the step, s."""
    steps = round(programme.interval / step)
    if steps < 1 or abs(steps * step - programme.interval) > 1e-9:
        raise ValueError(f"rows of {programme.interval:g} s are no multiple of the step {step:g} s")
    held = {name: programme.values(name) for name in ("axis_up", *HELD_INPUTS)}
    return Course(programme.interval, step, programme.table_rate, programme.temperature, held)


def compute_step_middles(steps: int) -> Array:
    """(m,) middles of the m equal steps of a row, as shares of the row."""
    return np.asarray((np.arange(steps) + 0.5) / steps)


def interpolate_rows(bounds: Array, share: Array) -> Array:
    """(n, m) values within n rows, linear between their bounds."""
    return np.asarray(bounds[:-1, None] + np.diff(bounds)[:, None] * share)
