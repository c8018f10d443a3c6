"""The simulated gyro's outputs for the inputs of a log."""

import math
from collections.abc import Sequence
from contextlib import ExitStack
from dataclasses import replace
from functools import lru_cache

import numpy as np

from pyhrg.bench.bench import LOOP_OUTPUTS, OUTPUTS_AT_END, compute_earth_rate, record_rows_together
from pyhrg.bench.programme import HELD_INPUTS, compute_step_middles, interpolate_rows
from pyhrg.common.arrays import Array
from pyhrg.device.device import Device
from pyhrg.device.fmu_parameters import LOOP_FREQUENCIES
from pyhrg.fmu import WIDE, GyroFmu
from pyhrg.gap.replay.inputs.inputs import ReplayInputs
from pyhrg.gap.replay.recorder import read_change

HELD_COLUMNS = tuple(name for name in HELD_INPUTS if name not in ("vibration", "bias_voltage"))
"""Inputs that a row of a log holds constant."""
READ_AT_END = {**OUTPUTS_AT_END, "quadrature": "quadrature"}
START_TEMPERATURE = "resonator.environment.startTemperature"
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
