"""A gyro on a turntable, simulated: a device and inputs in, a labelled dataset of outputs out."""

import difflib
import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path

import numpy as np
import xarray as xr
from numpy.typing import ArrayLike

from fmu_build.bundle import build_fmu
from fmu_build.roots import PARTS, ROOTS
from pyhrg.common.arguments import check_number, check_whole_number
from pyhrg.common.arrays import Array
from pyhrg.common.errors import HrgError
from pyhrg.common.units import DEG, ZERO_CELSIUS
from pyhrg.device.device import Device
from pyhrg.device.fmu_parameters import LOOP_FREQUENCIES
from pyhrg.device.ready_devices import load_device
from pyhrg.fmu import GyroFmu

Signal = ArrayLike | Callable[[Array], ArrayLike]
"""An input: one number, one number a row, or a function of an array of times since power-on (s)."""


@dataclass(frozen=True)
class Input:
    """An input of the FMU as `simulate` takes it: SI value = factor * value + offset."""

    fmu_name: str
    factor: float = 1.0
    offset: float = 0.0


MOVING_INPUTS = {
    "table_rate_deg_per_s": Input("angularRate", DEG),
    "temperature_degC": Input("caseTemperature", offset=ZERO_CELSIUS),
}
"""Inputs that follow a function of time in every communication step, by argument."""
HELD_INPUTS = {
    "acceleration_x_m_s2": Input("accelerationX"),
    "acceleration_y_m_s2": Input("accelerationY"),
    "acceleration_z_m_s2": Input("accelerationZ"),
    "virtual_rotation_deg_per_s": Input("virtualRotation", DEG),
    "amplitude_setpoint": Input("amplitudeSetpoint"),
    "phase_offset_rad": Input("phaseOffset"),
    "drive_on": Input("driveOn"),
    "vibration_m_s2": Input("vibration"),
    "bias_voltage": Input("biasVoltage"),
}
"""Inputs that are constant in a row, by argument."""
OUTPUTS_AT_END = {
    "gyro_angle": "gyroAngle",
    "gyro_rate": "gyroRate",
    "pattern_angle": "patternAngle",
    "amplitude": "amplitude",
    "quadrature": "quadrature",
    "map_followed": "mapFollowed",
}
"""The FMU's names of the outputs that are read at the end of each row, by their name in results.
HRGSelfCorrecting alone has the last."""
OUTPUTS_AVERAGED = {
    "amplitude_force": "amplitudeForce",
    "quadrature_force": "quadratureForce",
    "frequency_offset": "frequencyOffset",
    "valid": "valid",
}
"""The FMU's names of the outputs that are averaged over each row, by their name in results."""
MODELS = {**ROOTS, "HRGSelfCorrecting": PARTS["HRGSelfCorrecting"]}
"""The gyros that are simulated, by the names of their FMUs."""
MAX_SEED = 2**31 - 1
"""Largest seed that the FMU takes."""
MAX_STEPS = 10**9
"""Largest number of communication steps. Chosen: the inputs of more fill any machine's memory."""
_open_fmu = lru_cache(maxsize=len(MODELS))(GyroFmu)
ROUNDING = 1e-6
"""Largest departure of a ratio of two durations from a whole number. Chosen."""


def simulate(
    device: Device | str | Path,
    *,
    duration_s: float,
    interval_s: float = 1.0,
    table_rate_deg_per_s: Signal = 0.0,
    axis_up: float = 1.0,
    temperature_degC: Signal | None = None,  # noqa: N803 (the unit's own symbol)
    pattern_angle_deg: float | None = None,
    seed: int | None = None,
    model: str = "HRG",
    step_s: float | None = None,
    **inputs: Signal,
) -> xr.Dataset:
    """Simulate a gyro on a turntable from power-on, and return its outputs row by row.

    An input is one number, one number a row, or a function of an array of times (s). Rate and
    temperature follow a function in every communication step; other inputs are constant in a row.
    The gyro feels the rate of the turntable and that of Earth at the device's site.

    Args:
        device: the gyro, the name of a ready device, or a device file.
        duration_s: duration of the simulation, a multiple of `interval_s`.
        interval_s: length of a row, a multiple of `step_s`.
        table_rate_deg_per_s: rate of the turntable about its axis.
        axis_up: projection of the turntable's axis on local up, -1 to 1.
        temperature_degC: temperature of the case; the device's reference temperature if None.
        pattern_angle_deg: physical pattern angle at power-on; the device's if None.
        seed: seed of noise and of turn-on scatter, 0 to 2^31 - 1. None simulates neither.
        model: FMU to run: HRG, HRGCarrier, HRGSlow (quasi-steady loops), or HRGSelfCorrecting.
        step_s: communication step; the model's own if None.
        inputs: other inputs of the FMU: `acceleration_x_m_s2`, `acceleration_y_m_s2`,
            `acceleration_z_m_s2`, `virtual_rotation_deg_per_s`, `amplitude_setpoint`,
            `phase_offset_rad`, `drive_on`, `vibration_m_s2`, `bias_voltage`. By default the gyro
            feels gravity, whose level part is along x, and no command; the drive is on.

    Returns:
        The FMU's outputs over `time`, the end of each row (s). Angles, rate, amplitude, quadrature
        (and `map_followed` of HRGSelfCorrecting) are those at the end of a row; forces, frequency
        and validity are means over it. Attributes: `units` (SI), `long_name`, `cell_methods`.

    Raises:
        HrgError: an argument or device can't be used, or the FMU can't be built or refuses a value.
    """
    gyro = device if isinstance(device, Device) else load_device(device)
    rows = _make_rows(duration_s, interval_s, step_s, model)
    fmu = _open_fmu(build_fmu(model))
    moving = _read_moving(fmu, gyro, rows, axis_up, table_rate_deg_per_s, temperature_degC)
    held = _read_held(fmu, gyro, rows, axis_up, inputs)
    parameters, angle = _draw_power_on(fmu, gyro, pattern_angle_deg, seed)
    first = {name: float(values.flat[0]) for name, values in {**moving, **held}.items()}
    period = {} if fmu.is_sampled else {"samplePeriod": rows.step}
    at_end = {name: own for name, own in OUTPUTS_AT_END.items() if own in fmu.references}
    with fmu.power_on({**parameters, **period, **first}, seed or 0, angle) as on:
        ends, means = on.record(
            moving, held, rows.step, list(at_end.values()), list(OUTPUTS_AVERAGED.values())
        )
    outputs = _label_outputs(fmu, rows, at_end, ends, means)
    attributes = {"device": gyro.name, "model": model, "pattern_angle_at_power_on": angle}
    return outputs.assign_attrs(attributes, seed="none" if seed is None else seed)


@dataclass(frozen=True)
class _Rows:
    """Rows of equal length. n: how many; steps: communication steps in a row; step: s."""

    n: int
    steps: int
    step: float

    @property
    def interval(self) -> float:
        """Length of a row, s."""
        return self.steps * self.step

    @property
    def row_middles(self) -> Array:
        """(n,) times since power-on, s."""
        return np.asarray((np.arange(self.n) + 0.5) * self.interval)

    @property
    def step_middles(self) -> Array:
        """(n, m) times since power-on, s."""
        middles = (np.arange(self.n * self.steps) + 0.5) * self.step
        return np.asarray(middles.reshape(self.n, self.steps))


def _make_rows(duration_s: float, interval_s: float, step_s: float | None, model: str) -> _Rows:
    if model not in MODELS:
        raise HrgError(f"model: found {model!r}, expected {' or '.join(MODELS)}")
    check_number("interval_s", interval_s, 1e-3, 1e6)
    default = min(float(MODELS[model].step), interval_s)
    step = default if step_s is None else check_number("step_s", step_s, 1e-3, interval_s)
    check_number("duration_s", duration_s, interval_s, MAX_STEPS * step)
    n = _count("duration_s", duration_s, "interval_s", interval_s)
    return _Rows(n, _count("interval_s", interval_s, "step_s", step), step)


def _count(name: str, length: float, unit_name: str, unit: float) -> int:
    """How many units a length has."""
    count = round(length / unit)
    if abs(length / unit - count) > ROUNDING:
        raise HrgError(f"{name}: found {length:g}, expected a multiple of {unit_name}, {unit:g}")
    return count


def _read_moving(
    fmu: GyroFmu,
    gyro: Device,
    rows: _Rows,
    axis_up: float,
    table_rate: Signal,
    temperature: Signal | None,
) -> dict[str, Array]:
    """(n, m) inputs in each communication step, by the FMU's names, SI."""
    check_number("axis_up", axis_up, -1.0, 1.0)
    if temperature is None:
        temperature = gyro.reference_temperature - ZERO_CELSIUS
    signals = {"table_rate_deg_per_s": table_rate, "temperature_degC": temperature}
    values = {
        place.fmu_name: _read_input(fmu, name, place, signals[name], rows.step_middles)
        for name, place in MOVING_INPUTS.items()
    }
    turned = values["angularRate"] * rows.step
    table_angle = np.cumsum(turned).reshape(turned.shape) - turned / 2
    azimuth = table_angle + gyro.misalignment_direction
    values["angularRate"] += gyro.site.compute_earth_rate(axis_up, gyro.misalignment, azimuth)
    return values


def _read_held(
    fmu: GyroFmu, gyro: Device, rows: _Rows, axis_up: float, inputs: Mapping[str, Signal]
) -> dict[str, Array]:
    """(n,) inputs that are constant in a row, by the FMU's names, SI."""
    for name in inputs:
        if name not in HELD_INPUTS:
            known = (*MOVING_INPUTS, *HELD_INPUTS)
            close = difflib.get_close_matches(name, known, n=1) or known
            raise HrgError(f"{name}: found an unknown argument, expected {' or '.join(close)}")
    gravity = gyro.site.gravity
    signals: dict[str, Signal] = {
        **dict.fromkeys(HELD_INPUTS, 0.0),
        "acceleration_x_m_s2": gravity * math.sqrt(1 - axis_up**2),
        "acceleration_z_m_s2": gravity * axis_up,
        "amplitude_setpoint": gyro.amplitude,
        "drive_on": 1.0,
        "bias_voltage": 1.0,
        **inputs,
    }
    return {
        place.fmu_name: _read_input(fmu, name, place, signals[name], rows.row_middles)
        for name, place in HELD_INPUTS.items()
    }


def _read_input(fmu: GyroFmu, name: str, place: Input, signal: Signal, times: Array) -> Array:
    """SI values of an input at times (n,) of rows or (n, m) of their steps."""
    try:
        given = np.asarray(signal(times) if callable(signal) else signal)
        if given.dtype.kind in "US":
            raise TypeError("it is text")
        values = given.astype(np.float64)
    except (TypeError, ValueError) as error:
        raise HrgError(f"{name}: found no numbers, expected one, or one a row: {error}") from error
    if values.ndim == 1 and times.ndim == 2 and len(values) == len(times):
        values = values[:, None]
    if values.ndim and values.shape not in (times.shape, (len(times), 1)):
        raise HrgError(
            f"{name}: found an array of shape {values.shape}, expected one number, one a row "
            f"({len(times)}) or a function of time"
        )
    limits = next(v for v in fmu.description.modelVariables if v.name == place.fmu_name)
    low, high = ((float(x) - place.offset) / place.factor for x in (limits.min, limits.max))
    wrong = ~((values >= low) & (values <= high))
    if wrong.any():
        raise HrgError(f"{name}: found {values[wrong].flat[0]:g}, expected {low:g} to {high:g}")
    return np.ascontiguousarray(
        np.broadcast_to(place.factor * values + place.offset, times.shape)
    ).copy()


def _draw_power_on(
    fmu: GyroFmu, gyro: Device, pattern_angle_deg: float | None, seed: int | None
) -> tuple[dict[str, float], float]:
    """The FMU's parameters by name, SI, and the pattern angle, rad, at one power-on; drawn from the
    device's scatter where there is a seed."""
    if seed is None:
        angle, values = gyro.power_on_angle, gyro.without_noise().fmu_parameters()
    else:
        generator = np.random.default_rng(check_whole_number("seed", seed, 0, MAX_SEED))
        angle = float(generator.normal(gyro.power_on_angle, gyro.power_on_scatter))
        values = gyro.draw_turn_on(generator)
    if pattern_angle_deg is not None:
        angle = check_number("pattern_angle_deg", pattern_angle_deg, -1e6, 1e6) * DEG
    missing = LOOP_FREQUENCIES - fmu.references.keys()
    return {name: v for name, v in values.items() if name not in missing}, angle


def _label_outputs(
    fmu: GyroFmu, rows: _Rows, at_end: Mapping[str, str], ends: Array, means: Array
) -> xr.Dataset:
    time = np.arange(1, rows.n + 1) * rows.interval
    about_time = {"units": "s", "long_name": "time since power-on, at the end of the row"}
    dataset = xr.Dataset(coords={"time": ("time", time, about_time)})
    variables = {v.name: v for v in fmu.description.modelVariables}
    names = {**at_end, **OUTPUTS_AVERAGED}
    for (name, fmu_name), column in zip(names.items(), [*ends.T, *means.T], strict=True):
        attributes = {
            "units": variables[fmu_name].unit or "1",
            "long_name": variables[fmu_name].description,
            "cell_methods": f"time: {'point' if name in at_end else 'mean'}",
        }
        dataset[name] = ("time", column, attributes)
    return dataset
