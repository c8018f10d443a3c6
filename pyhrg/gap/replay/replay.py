"""A test's inputs, as its log has them, put to the simulated gyro."""

import math
from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from pyhrg.bench.bench import FORCES, INPUTS, between, earth_rate, middles, recorded
from pyhrg.common.robust import robust_deviation
from pyhrg.device.device import LOOPS, Device
from pyhrg.fmu import GyroFmu
from pyhrg.gap.replay.table_motion import TableMotion, table_motion
from pyhrg.gap.replay.thermometer import toggling
from pyhrg.records import COLUMNS, Log

Array = NDArray[np.float64]

HELD = tuple(name for name in INPUTS if name not in ("vibration", "bias_voltage"))
LEAST = 10
"""Readings below which a thermometer's noise can't be told."""
ROUNDED = 1e-9
"""Of a step, that is none."""
STEADY = 2.0
"""Spread of a thermometer's readings, over their noise, that is no change of temperature."""


@dataclass(frozen=True)
class Replayable:
    """The inputs of a log, ready for any simulated gyro.

    start_angle: true pattern angle at power-on, rad.
    table: its motion.
    temperatures: (n + 1,) of the case at the rows' bounds, K.
    begun: angle of the table at power-on, rad.
    """

    log: Log
    start_angle: float
    table: TableMotion
    temperatures: Array
    begun: float = 0.0

    def table_angle(self, steps: int) -> Array:
        """(n, steps) at the middles of equal steps of each row, rad."""
        begun = np.concatenate(([self.begun], self.log.table_angle[:-1]))[:, None]
        return begun + self.table.turned_in(steps)

    def section(self, rows: slice, start_angle: float) -> "Replayable":
        """The inputs of some rows alone, if power came on at their begin, with the pattern at an
        angle, rad."""
        columns: dict[str, Any] = {c.field: getattr(self.log, c.field)[rows] for c in COLUMNS}
        return Replayable(
            replace(self.log, **columns),
            start_angle,
            self.table.section(rows),
            self.temperatures[rows.start : rows.stop + 1],
            float(self.log.table_angle[rows.start - 1]) if rows.start else self.begun,
        )

    def first(self, rows: int) -> "Replayable":
        """The inputs of the first rows alone."""
        return self.section(slice(0, rows), self.start_angle)


def replayable(log: Log, believed: Device) -> Replayable:
    """Inputs of a log whose rows are complete.

    Args:
        log: of one power-on, from its start.
        believed: its Bryan factor is used.
    """
    return Replayable(
        log,
        start_angle(log, believed.bryan_factor),
        table_motion(log.table_angle, log.interval),
        _told(np.append(log.temperature[0], log.temperature)),
    )


def _told(temperature: Array) -> Array:
    """A log's temperature; its mean where it shows no more than the thermometer's noise, which
    effects of temperature would else be fitted to."""
    noise = robust_deviation(np.diff(temperature, 2)) / np.sqrt(6)
    noise = max(noise, toggling(temperature) / np.sqrt(12))
    if len(temperature) < LEAST or np.std(temperature) > STEADY * noise:
        return temperature
    return np.full(len(temperature), np.mean(temperature))


def tells_start(log: Log) -> bool:
    """Whether `start_angle` has rows with both angles."""
    return bool(np.isfinite(log.wave_angle + log.gyro_angle).any())


def start_angle(log: Log, bryan_factor: float) -> float:
    """True pattern angle at power-on, rad: what the output's definition leaves of wave angle and
    commanded rotation."""
    commanded = bryan_factor * np.cumsum(log.virtual_rotation) * log.interval
    return float(np.nanmean(log.wave_angle + bryan_factor * log.gyro_angle - commanded))


def replayed(fmu: GyroFmu, device: Device, inputs: Replayable, step: float) -> dict[str, Array]:
    """What the simulated gyro, without noise, answers to a log's inputs.

    Args:
        fmu: `HRG`, or `HRGSlow` for loops that are at rest.
        device: the gyro, its mounting, and where it stands.
        step: longest communication step, s; rows are multiples of the one that is taken.

    Returns:
        (n,) SI by field of a log: angle, amplitude, forces and frequency.

    Raises:
        GyroError: parameters or inputs that the FMU refuses.
    """
    steps = max(1, math.ceil(inputs.log.interval / step - ROUNDED))
    step = inputs.log.interval / steps
    held = {name: getattr(inputs.log, name) for name in HELD}
    first = {INPUTS[name]: float(values[0]) for name, values in held.items()}
    first["caseTemperature"] = float(inputs.temperatures[0])
    parameters = {**_parameters(fmu, device, step), **first}
    with fmu.power_on(parameters, seed=0, start_angle=inputs.start_angle) as on:
        return recorded(on, _moving(device, inputs, steps), held, step, FORCES)


def _parameters(fmu: GyroFmu, device: Device, step: float) -> Mapping[str, float]:
    values = replace(device.without_noise(), angle_quantum=0.0).fmu_parameters()
    if fmu.is_sampled:
        return values
    at_rest = {name: value for name, value in values.items() if name not in LOOPS}
    return {**at_rest, "samplePeriod": step}


def _moving(device: Device, inputs: Replayable, steps: int) -> dict[str, Array]:
    up = inputs.log.axis_up[:, None]
    earth = earth_rate(device, up, inputs.table_angle(steps))
    return {
        "angularRate": inputs.table.rates_in(steps) + earth,
        "caseTemperature": between(inputs.temperatures, middles(steps)),
    }
