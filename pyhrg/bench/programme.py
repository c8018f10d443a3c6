"""What a bench does to a gyro, row by row: table, attitude, temperature, commands."""

import math

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]

HELD = (
    "axis_up",
    "acceleration_x",
    "acceleration_y",
    "acceleration_z",
    "virtual_rotation",
    "amplitude_setpoint",
    "phase_offset",
    "drive_on",
    "vibration",
    "bias_voltage",
)
"""What holds over a row; temperature is linear within it, the table's rate as well."""


class Programme:
    """Rows of equal length, appended one manoeuvre after the other; begins at rest, axis up."""

    def __init__(self, interval: float, gravity: float, temperature: float = 298.15) -> None:
        """Begin.

        Args:
            interval: length of a row, s.
            gravity: of the site, m/s2.
            temperature: of the case, K.
        """
        self.interval = interval
        self.gravity = gravity
        self._held = dict.fromkeys(HELD, 0.0)
        self._held.update(axis_up=1.0, acceleration_z=gravity)
        self._held.update(amplitude_setpoint=1.0, drive_on=1.0, bias_voltage=1.0)
        self._rates = [0.0]
        self._temperatures = [temperature]
        self._rows: list[dict[str, float]] = []

    def __len__(self) -> int:
        return len(self._rows)

    @property
    def time(self) -> float:
        """Length so far, s."""
        return len(self) * self.interval

    def command(self, **values: float) -> "Programme":
        """Set what holds from now on (`HELD`), SI."""
        unknown = values.keys() - self._held.keys()
        if unknown:
            raise ValueError(f"no such command: {', '.join(sorted(unknown))}")
        self._held.update(values)
        return self

    def override(self, **values: Array) -> "Programme":
        """Set what held over each row so far (`HELD`), (n,) each, SI."""
        for name, series in values.items():
            if name not in self._held or len(series) != len(self):
                raise ValueError(f"{name}: expected a command and {len(self)} values")
            for row, value in zip(self._rows, series.tolist(), strict=True):
                row[name] = value
        return self

    def holds(self, name: str) -> float:
        """What is commanded now, SI."""
        return self._held[name]

    def attitude(self, axis_up: float, across: float = 0.0) -> "Programme":
        """Tilt the input axis towards east, so that Earth's rate on it is axis_up W_E sin L.

        Args:
            axis_up: cosine of the angle between the input axis and local up, -1 to 1.
            across: angle about the input axis between the x electrodes and the vertical plane, rad.
        """
        level = self.gravity * math.sqrt(max(0.0, 1 - axis_up**2))
        return self.command(
            axis_up=axis_up,
            acceleration_x=level * math.cos(across),
            acceleration_y=level * math.sin(across),
            acceleration_z=self.gravity * axis_up,
        )

    def rest(self, duration: float) -> "Programme":
        """Stand still."""
        return self.spin(0.0, duration)

    def spin(self, rate: float, duration: float) -> "Programme":
        """Turn at a rate, rad/s, reached over the first row."""
        for _ in range(self._count(duration)):
            self._append(rate, self._temperatures[-1])
        return self

    def turn(self, angle: float, rate: float) -> "Programme":
        """Turn by an angle, rad, at most at `rate`, rad/s, and stop."""
        rows = max(2, math.ceil(abs(angle) / (abs(rate) * self.interval)) + 1)
        peak = angle / ((rows - 1) * self.interval)
        return self.spin(peak, (rows - 1) * self.interval).spin(0.0, self.interval)

    def heat(self, temperature: float, duration: float) -> "Programme":
        """Bring the case linearly to a temperature, K, at rest."""
        rows = self._count(duration)
        begin = self._temperatures[-1]
        for row in range(1, rows + 1):
            self._append(0.0, begin + (temperature - begin) * row / rows)
        return self

    def tempered(self, temperatures: Array) -> "Programme":
        """Set the temperature of the case at the bounds of the rows so far, (n + 1,), K."""
        if len(temperatures) != len(self) + 1:
            raise ValueError(f"expected {len(self) + 1} temperatures, found {len(temperatures)}")
        self._temperatures = temperatures.tolist()
        return self

    def held(self, name: str) -> Array:
        """(n,) values of what holds over each row."""
        return np.array([row[name] for row in self._rows])

    @property
    def temperature(self) -> Array:
        """(n + 1,) temperature of the case at the rows' bounds, K."""
        return np.array(self._temperatures)

    @property
    def table_rate(self) -> Array:
        """(n + 1,) rate of the table at the rows' bounds, rad/s; linear between them."""
        return np.array(self._rates)

    @property
    def table_angle(self) -> Array:
        """(n,) angle of the table at the rows' ends, rad."""
        rate = self.table_rate
        return np.asarray(np.cumsum((rate[1:] + rate[:-1]) / 2) * self.interval)

    def _count(self, duration: float) -> int:
        rows = round(duration / self.interval)
        if rows < 0 or abs(rows * self.interval - duration) > 1e-6 * max(duration, self.interval):
            raise ValueError(f"{duration:g} s is no multiple of the rows' {self.interval:g} s")
        return rows

    def _append(self, rate: float, temperature: float) -> None:
        self._rates.append(rate)
        self._temperatures.append(temperature)
        self._rows.append(dict(self._held))
