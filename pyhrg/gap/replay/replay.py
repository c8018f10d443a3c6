"""A test's inputs, as its log has them, put to the simulated gyro."""

import math
from collections.abc import Mapping, Sequence
from contextlib import ExitStack
from dataclasses import dataclass, replace
from functools import lru_cache
from typing import Any

import numpy as np

from pyhrg.bench.bench import LOOP_OUTPUTS, OUTPUTS_AT_END, compute_earth_rate, record_rows_together
from pyhrg.bench.programme import HELD_INPUTS, compute_step_middles, interpolate_rows
from pyhrg.common.arrays import Array
from pyhrg.common.robust import estimate_robust_deviation
from pyhrg.device.device import Device
from pyhrg.device.fmu_parameters import LOOP_FREQUENCIES
from pyhrg.fmu import WIDE, GyroFmu
from pyhrg.gap.replay.soak import is_soaked
from pyhrg.gap.replay.table_motion import TableMotion, estimate_table_motion
from pyhrg.gap.replay.thermometer import correct_temperatures, estimate_toggling_step
from pyhrg.records import COLUMNS, Log

HELD_COLUMNS = tuple(name for name in HELD_INPUTS if name not in ("vibration", "bias_voltage"))
"""Inputs that a row of a log holds constant."""
MIN_READINGS = 10
"""Fewest readings from which an instrument's noise is estimated. Chosen."""
ANGLES = ("gyro_angle", "wave_angle")
"""Fields of a log that are read at the end of a row."""
READ_AT_END = {**OUTPUTS_AT_END, "quadrature": "quadrature"}
START_TEMPERATURE = "resonator.environment.startTemperature"
CLOCK_FIELDS = ("clock_latency", "clock_rate")
"""Fields of a device that state by how much later angles are read."""
STEP_ROUNDING = 1e-9
"""Excess of a row over a whole number of steps, in steps, that is rounding. Chosen."""
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
        columns: dict[str, Any] = {c.field: getattr(self.log, c.field)[rows] for c in COLUMNS}
        return ReplayInputs(
            replace(self.log, **columns),
            start_angle,
            self.table.section(rows),
            self.temperatures[rows.start : rows.stop + 1],
            float(self.log.table_angle[rows.start - 1]) if rows.start else self.start_table_angle,
            self.is_soaked,
        )


def prepare_inputs(log: Log, nominal: Device, encoder_noise: float = 0.0) -> ReplayInputs:
    """Inputs of a log of one power-on, from its start, whose rows are complete; `encoder_noise` is
    the standard deviation of the table encoder's readings, rad."""
    temperature = np.append(log.temperature[0], log.temperature)
    step = estimate_toggling_step(list_measured_temperatures(log))
    log = replace(log, table_angle=_average_steady(log.table_angle))
    temperatures = _average_steady(temperature, step / math.sqrt(12))
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


def replay_inputs(
    fmu: GyroFmu, device: Device, inputs: ReplayInputs, step: float
) -> dict[str, Array]:
    """Noise-free outputs of the simulated gyro for a log's inputs, (n,) SI by field of a log:
    angles, amplitude, forces and frequency; and `quadrature`, the quadrature amplitude.

    The FMU is `HRG`, or `HRGSlow` for quasi-steady loops. The longest communication step, s, is
    shortened to a whole fraction of a row. A `GyroError` where the FMU refuses parameters or
    inputs.
    """
    return replay_together(fmu, [(device, inputs)], step)[0]


def replay_together(
    fmu: GyroFmu, runs: Sequence[tuple[Device, ReplayInputs]], step: float
) -> list[dict[str, Array]]:
    """`replay_inputs` of several devices, all with the inputs of one log but for the start
    angle."""
    return [
        outputs
        for first in range(0, len(runs), WIDE)
        for outputs in _replay_few(fmu, runs[first : first + WIDE], step)
    ]


def _replay_few(
    fmu: GyroFmu, runs: Sequence[tuple[Device, ReplayInputs]], step: float
) -> list[dict[str, Array]]:
    log = runs[0][1].log
    steps = max(1, math.ceil(log.interval / step - STEP_ROUNDING))
    step = log.interval / steps
    held = {name: getattr(log, name) for name in HELD_COLUMNS}
    starts = {HELD_INPUTS[name]: float(values[0]) for name, values in held.items()}
    if not fmu.is_sampled:
        starts["samplePeriod"] = step
    with ExitStack() as stack:
        gyros, varying = [], []
        for device, inputs in runs:
            temperatures = inputs.find_case_temperatures(device)
            parameters = _list_parameters(fmu, device) | starts
            parameters["caseTemperature"] = float(temperatures[0])
            if inputs.is_soaked:
                parameters[START_TEMPERATURE] = temperatures[0] - device.reference_temperature
            angle = _find_start_angle(device, inputs)
            gyros.append(stack.enter_context(fmu.power_on(parameters, seed=0, start_angle=angle)))
            varying.append(_list_moving_inputs(fmu, device, inputs, temperatures, steps))
        recorded = record_rows_together(
            gyros, varying, [held] * len(gyros), step, LOOP_OUTPUTS, READ_AT_END
        )
    ideal = Device()
    changes = [read_change(r, ideal, d, log) for r, (d, _) in zip(recorded, runs, strict=True)]
    for change, (device, inputs) in zip(changes, runs, strict=True):
        if device.filter_delay and not fmu.is_sampled:
            _read_at_end(change, device, inputs, steps)
    return [
        {name: values + change[name] for name, values in rows.items()}
        for rows, change in zip(recorded, changes, strict=True)
    ]


def _read_at_end(
    change: dict[str, Array], device: Device, inputs: ReplayInputs, steps: int
) -> None:
    """Change angles to those that a filter shows at the rate of a row's end, for the mean rate of
    the row's last step, which quasi-steady loops follow."""
    table = inputs.table
    behind = device.filter_delay * (table.rates[1:] - table.compute_rates(steps)[:, -1])
    change["gyro_angle"] = change["gyro_angle"] - behind
    change["wave_angle"] = change["wave_angle"] + device.bryan_factor * behind


@lru_cache(maxsize=256)
def _list_parameters(fmu: GyroFmu, device: Device) -> dict[str, float]:
    """Parameters of the FMU, without noise. A device runs in all tests of a campaign."""
    silent = replace(device.without_noise(), quantization_step=0.0)
    unknown = () if fmu.is_sampled else LOOP_FREQUENCIES
    return {name: v for name, v in silent.fmu_parameters().items() if name not in unknown}


def _list_moving_inputs(
    fmu: GyroFmu, device: Device, inputs: ReplayInputs, temperatures: Array, steps: int
) -> dict[str, Array]:
    """(n, steps) inputs that change within a row, with the case's (n + 1,) temperatures at the
    rows' bounds, K."""
    angle = inputs.table_angle(steps)
    earth = compute_earth_rate(device, inputs.log.axis_up[:, None], angle)
    eccentric = device.encoder_eccentricity * np.cos(angle + device.encoder_eccentricity_phase)
    moving = {
        "angularRate": inputs.table.compute_rates(steps) * (1 + eccentric) + earth,
        "caseTemperature": interpolate_rows(temperatures, compute_step_middles(steps)),
    }
    if "tableAngle" in fmu.references:  # the FMU of a diagnosis with a term of the table angle
        moving["tableAngle"] = angle
    return moving


def _find_start_angle(device: Device, inputs: ReplayInputs) -> float:
    """Pattern angle at power-on, rad, of a device that reads angles late."""
    late = device.clock_latency + device.clock_rate * inputs.log.time
    turned = device.bryan_factor * float(np.mean(late * inputs.log.virtual_rotation))
    return inputs.start_angle - turned


def list_read_out_fields(log: Log) -> tuple[str, ...]:
    """Fields of a device that change what a recorder reads of this test, and not what the gyro
    does. A pattern that is turned by command starts elsewhere if its angle was read later."""
    clock = () if log.virtual_rotation.any() else CLOCK_FIELDS
    return ("frequency_error", "amplitude_latency", *clock)


def read_change(rows: Mapping[str, Array], old: Device, new: Device, log: Log) -> dict[str, Array]:
    """(n,) by field of a log: what another recorder makes of the same outputs. It reads angles
    or the amplitude later, and counts the frequency from another one (docs/methods/replay.md,
    "Rows that are compared")."""
    late = new.clock_latency - old.clock_latency + (new.clock_rate - old.clock_rate) * log.time
    change = {name: np.zeros(len(log.time)) for name in rows}
    for name in ANGLES if late.any() else ():
        change[name] = late * np.gradient(rows[name], log.interval)
    later = new.amplitude_latency - old.amplitude_latency
    if later:  # the slope before the reading, as the drive may go off at the row's end
        change["amplitude"] = later * np.diff(rows["amplitude"], prepend=rows["amplitude"][0])
        change["amplitude"] /= log.interval
    detuned = (rows["frequency_offset"] - old.frequency_error) / (
        old.frequency_error + new.frequency
    )
    change["frequency_offset"] += (new.frequency_error - old.frequency_error) * (1 + detuned)
    return change
