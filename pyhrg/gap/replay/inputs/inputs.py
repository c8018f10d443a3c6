"""What a log says about the inputs of the gyro, ready for a replay."""

import math
from dataclasses import dataclass, replace

import numpy as np

from pyhrg.common.arrays import Array
from pyhrg.common.robust import estimate_robust_deviation
from pyhrg.device.device import Device
from pyhrg.gap.replay.inputs.soak import is_soaked
from pyhrg.gap.replay.inputs.table_motion import TableMotion, estimate_table_motion
from pyhrg.gap.replay.inputs.thermometer import correct_temperatures, estimate_toggling_step
from pyhrg.records import Log

MIN_READINGS = 10
"""Fewest readings from which an instrument's noise is estimated. Chosen."""
STEADY_RATIO = 2.0
"""An input whose spread is below this many of its instrument's noise is constant. Chosen."""


@dataclass(frozen=True)
class ReplayInputs:
    """The inputs of a log, ready for any simulated gyro.

    start_angle: physical pattern angle at power-on, rad.
    table: motion of the turntable.
    temperatures: (n + 1,) of the case at the rows' bounds, K.
    start_table_angle: of the table at power-on, rad.
    is_soaked: whether the resonator starts at the case's temperature, not at the reference.
    """

    log: Log
    start_angle: float
    table: TableMotion
    temperatures: Array
    start_table_angle: float = 0.0
    is_soaked: bool = False

    def table_angle(self, steps: int) -> Array:
        """(n, steps) at the middles of equal steps of each row, rad."""
        at_begin = np.concatenate(([self.start_table_angle], self.log.table_angle[:-1]))[:, None]
        return at_begin + self.table.compute_turns(steps)

    @property
    def is_steady(self) -> bool:
        """Whether one temperature stands for all readings."""
        return not np.ptp(self.temperatures)

    def find_case_temperatures(self, device: Device) -> Array:
        """(n + 1,) at the rows' bounds, K, as a device's thermometer reads them."""
        return correct_temperatures(device, self.temperatures, self.log.interval)

    def section(self, rows: slice, start_angle: float) -> "ReplayInputs":
        """The inputs of some rows, with power-on at their begin and the pattern at an angle,
        rad."""
        return ReplayInputs(
            self.log.section(rows),
            start_angle,
            self.table.section(rows),
            self.temperatures[rows.start : rows.stop + 1],
            float(self.log.table_angle[rows.start - 1]) if rows.start else self.start_table_angle,
            self.is_soaked,
        )


def prepare_inputs(
    log: Log, nominal: Device, encoder_noise: float = 0.0, thermometer_noise: float = 0.0
) -> ReplayInputs:
    """Inputs of a log of one power-on, from its start, whose rows are complete. `encoder_noise` is
    the standard deviation of the table encoder's readings, rad; `thermometer_noise`, K, is the
    least that the thermometer has, whatever its readings show."""
    temperature = np.append(log.temperature[0], log.temperature)
    step = estimate_toggling_step(list_measured_temperatures(log))
    log = replace(log, table_angle=_average_steady(log.table_angle))
    temperatures = _average_steady(temperature, max(step / math.sqrt(12), thermometer_noise))
    return ReplayInputs(
        log,
        estimate_start_angle(log, nominal.bryan_factor),
        estimate_table_motion(log.table_angle, log.interval, encoder_noise),
        temperatures,
        is_soaked=is_soaked(log, temperatures, nominal),
    )


def settle_inputs(inputs: ReplayInputs, nominal: Device) -> ReplayInputs:
    """Inputs of a log of a campaign in which some resonator had settled before its log began: where
    this frequency shows the same, however close the temperature is to the reference."""
    log, temperatures = inputs.log, inputs.temperatures
    return replace(inputs, is_soaked=is_soaked(log, temperatures, nominal, least_departure=0.0))


def list_measured_temperatures(log: Log) -> Array:
    """(m,) readings of the thermometer, K, without those of missing rows, which were filled in."""
    return np.asarray(log.temperature[np.isfinite(log.gyro_angle)])


def _average_steady(readings: Array, least_noise: float = 0.0) -> Array:
    """(n,) readings of an input, or their mean where they show no more than the noise of the
    instrument, which is `least_noise` at least.

    Effects of the input would otherwise be fitted to that noise.
    """
    noise = max(estimate_robust_deviation(np.diff(readings, 2)) / np.sqrt(6), least_noise)
    if len(readings) < MIN_READINGS or np.std(readings) > STEADY_RATIO * noise:
        return readings
    return np.full(len(readings), np.mean(readings))


def has_start_angle(log: Log) -> bool:
    """Whether any row has both angles, so that `estimate_start_angle` works."""
    return bool(np.isfinite(log.wave_angle + log.gyro_angle).any())


def estimate_start_angle(log: Log, bryan_factor: float) -> float:
    """Physical pattern angle at power-on, rad (docs/methods/replay.md, Eq. 1)."""
    commanded = bryan_factor * np.cumsum(log.virtual_rotation) * log.interval
    return float(np.nanmean(log.wave_angle + bryan_factor * log.gyro_angle - commanded))
