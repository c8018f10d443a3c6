"""What a gyro does in flight, read off the FMU `HRGSlow`: whatever mechanisms it has."""

from collections.abc import Mapping
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from ins_eval.mission_model.gyro_map import FAST, NAMES, SLOW, GyroMap, Sweep, characterised
from ins_eval.mission_model.pattern_drift import TURNING
from ins_eval.mission_model.signals import STEADY, WARMING, coefficients_of
from pyhrg.device.device import LOOPS, Device
from pyhrg.fmu import GyroFmu

Array = NDArray[np.float64]

SETTLED = 1.0
"""Thermal lag of a gyro that is read off warm, s."""
UNMOVED = 1e6
"""Thermal lag of one whose resonator stays cool while its case heats, s."""
FORCE = 10.0
"""At which sensitivity to specific force is read, m/s^2."""
HEATING = 0.01
"""Rate of the case's temperature at which sensitivity to it is read, K/s."""
QUICK = 0.01
"""Period at which the gyro is read while it turns fast, s."""
REFERENCE = "resonator.environment.referenceTemperature"


def soaked(device: Device, rise: float) -> Device:
    """The gyro in a chamber that is warmer by so many K than its parameters hold at: its resonator
    follows at once."""
    reference = device.reference_temperature - rise
    return replace(device, model={**device.model, REFERENCE: reference}, thermal_lag=SETTLED)


def coefficients(fmu: GyroFmu, device: Device, rise: float) -> Array:
    """(signals.COUNT,) of a gyro that warms by so many K, over the pattern angle itself.

    Read cool, half warm and warm; under specific force along either axis; while its case heats;
    turning fast.
    """
    cool, half, warm = (_read(fmu, soaked(device, share * rise)) for share in (0.0, 0.5, 1.0))
    curving = 2 * (cool + warm) - 4 * half
    across, along = (
        (_read(fmu, soaked(device, 0.0), {name: np.full(SLOW.rows, FORCE)}) - cool) / FORCE
        for name in ("accelerationX", "accelerationZ")
    )
    ramp = device.reference_temperature + HEATING * SLOW.interval * np.arange(float(SLOW.rows))
    unmoved = replace(device, thermal_lag=UNMOVED)
    heating = (_read(fmu, unmoved, {"caseTemperature": ramp}) - cool) / HEATING
    quick = soaked(replace(device, model={**device.model, "samplePeriod": QUICK}), 0.0)
    squared = (_read(fmu, quick, sweep=FAST) - cool) / FAST.rate**2
    warming = warm - cool - curving
    return np.concatenate([cool, warming, curving, rise * heating, across, along, squared])


def started_at(found: Array, angle: float) -> Array:
    """Coefficients (signals.COUNT,) over the pattern's turn from an angle, rad."""
    maps = found.reshape(-1, 2 * len(NAMES))
    return np.concatenate([GyroMap.of(each).started_at(angle).coefficients for each in maps])


def turning(device: Device, found: Array, angle: float) -> Array:
    """(TURNING,) of the bias that turns the pattern of the warm gyro, from an angle, rad/s: what
    the electronics take out of the output, and what is left."""
    left = found[coefficients_of(slice(STEADY.start, WARMING.stop))].reshape(3, -1).sum(axis=0)
    taken = np.array([getattr(device.bias_map, name, 0.0) for name in NAMES])
    bias = GyroMap.of(left).bias + taken
    return GyroMap(bias, np.zeros_like(bias)).started_at(angle).bias[list(TURNING)]


def slow_parameters(device: Device) -> Mapping[str, float]:
    """Of `HRGSlow`, noise apart."""
    parameters = device.without_noise().fmu_parameters()
    return {name: value for name, value in parameters.items() if name not in LOOPS}


def _read(
    fmu: GyroFmu,
    device: Device,
    inputs: Mapping[str, Array] | None = None,
    sweep: Sweep = SLOW,
) -> Array:
    return characterised(fmu, slow_parameters(device), inputs, sweep).coefficients
