"""The simulated gyro's outputs for the inputs of a log."""

import math
from collections.abc import Mapping, Sequence
from contextlib import ExitStack
from dataclasses import replace
from functools import lru_cache
from typing import Any

import numpy as np

from pyhrg.bench.bench import LOOP_OUTPUTS, OUTPUTS_AT_END, compute_earth_rate, record_rows_together
from pyhrg.bench.programme import HELD_INPUTS, compute_step_middles, interpolate_rows
from pyhrg.common.arrays import Array
from pyhrg.device.device import Device
from pyhrg.device.fmu_parameters import LOOP_FREQUENCIES
from pyhrg.fmu import WIDE, GyroFmu
from pyhrg.gap.replay.inputs.inputs import ReplayInputs
from pyhrg.records import Log

HELD_COLUMNS = tuple(name for name in HELD_INPUTS if name not in ("vibration", "bias_voltage"))
"""Inputs that a row of a log holds constant."""
ANGLES = ("gyro_angle", "wave_angle")
"""Fields of a log that are read at the end of a row."""
READ_AT_END = {**OUTPUTS_AT_END, "quadrature": "quadrature"}
START_TEMPERATURE = "resonator.environment.startTemperature"
SCALES = {
    "amplitude": "amplitude_scale",
    "amplitude_force": "amplitude_force_scale",
    "quadrature_force": "quadrature_force_scale",
}
"""Field of a device that states the relative error of a recorded channel."""
CLOCK_FIELDS = ("clock_latency", "clock_rate")
"""Fields of a device that state by how much later angles are read."""
STEP_ROUNDING = 1e-9
"""Excess of a row over a whole number of steps, in steps, that is rounding. Chosen."""


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
    return ("frequency_error", "amplitude_latency", *SCALES.values(), *clock)


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


def scale_channels(values: Mapping[str, Array], device: Device) -> dict[str, Array]:
    """Values by channel as a device's recorder reads them, whose channels have wrong scales."""
    scales = {name: 1 + getattr(device, field) for name, field in SCALES.items()}
    return {name: own * scales.get(name, 1.0) for name, own in values.items()}


def list_scale_steps(old: Device, new: Device) -> dict[str, float]:
    """Change of each channel's scale from one device to another, without those that are the
    same."""
    steps = {name: getattr(new, own) - getattr(old, own) for name, own in SCALES.items()}
    return {name: step for name, step in steps.items() if step}


@lru_cache(maxsize=16)
def take_out_scales(device: Device) -> Device:
    """The device with exact scales of its channels; the same object for equal devices."""
    exact: dict[str, Any] = dict.fromkeys(SCALES.values(), 0.0)
    return replace(device, **exact)
