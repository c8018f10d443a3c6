"""True coefficients of a gyro in flight, measured by simulation of the FMU `HRGSlow`."""

from collections.abc import Mapping
from dataclasses import replace

import numpy as np

from ins_eval.mission_model.gyro_map import (
    FAST,
    SLOW,
    TERMS,
    Sweep,
    list_coefficients,
    measure_gyro_map,
    start_maps,
)
from ins_eval.mission_model.pattern_drift import TURNING_TERMS
from ins_eval.mission_model.signals import STEADY, WARMING, slice_coefficients
from pyhrg.common.arrays import Array
from pyhrg.device.device import Device
from pyhrg.device.fmu_parameters import LOOP_FREQUENCIES
from pyhrg.fmu import GyroFmu

SOAKED_LAG = 1.0
"""Thermal lag of a gyro whose map is measured at another temperature, s: it follows at once."""
ISOLATED_LAG = 1e6
"""Thermal lag of a gyro whose resonator stays cool while its case heats, s."""
READING_FORCE = 10.0
"""Specific force at which the sensitivity to it is measured, m/s^2. Chosen: about 1 g."""
READING_TEMPERATURE_RATE = 0.01
"""Rate of the case's temperature at which the sensitivity to it is measured, K/s. Chosen."""
FAST_SAMPLE_PERIOD = 0.01
"""Sample period of the FMU while the gyro turns fast, s. Chosen."""
REFERENCE_TEMPERATURE = "resonator.environment.referenceTemperature"


def soak_gyro(device: Device, rise: float) -> Device:
    """The gyro in a chamber that is warmer than its reference temperature by `rise`, K, after it
    has reached that temperature."""
    reference = device.reference_temperature - rise
    return replace(
        device, model={**device.model, REFERENCE_TEMPERATURE: reference}, thermal_lag=SOAKED_LAG
    )


def read_flight_coefficients(fmu: GyroFmu, device: Device, rise: float) -> Array:
    """(signals.COUNT,) coefficients over the pattern angle of a gyro that warms by `rise`, K.

    The map is measured cool, half warm and warm; under specific force along either axis; while the
    case heats; and turning fast.
    """
    cool, half, warm = (
        _read_coefficients(fmu, soak_gyro(device, share * rise)) for share in (0.0, 0.5, 1.0)
    )
    curving = 2 * (cool + warm) - 4 * half
    across, along = (
        (
            _read_coefficients(
                fmu, soak_gyro(device, 0.0), {name: np.full(SLOW.rows, READING_FORCE)}
            )
            - cool
        )
        / READING_FORCE
        for name in ("accelerationX", "accelerationZ")
    )
    ramp = device.reference_temperature + READING_TEMPERATURE_RATE * SLOW.interval * np.arange(
        float(SLOW.rows)
    )
    unmoved = replace(device, thermal_lag=ISOLATED_LAG)
    heating = (
        _read_coefficients(fmu, unmoved, {"caseTemperature": ramp}) - cool
    ) / READING_TEMPERATURE_RATE
    quick = soak_gyro(
        replace(device, model={**device.model, "samplePeriod": FAST_SAMPLE_PERIOD}), 0.0
    )
    squared = (_read_coefficients(fmu, quick, sweep=FAST) - cool) / FAST.rate**2
    warming = warm - cool - curving
    return np.concatenate([cool, warming, curving, rise * heating, across, along, squared])


def start_at(coefficients: Array, angle: float) -> Array:
    """(n TERMS,) coefficients of one gyro over the pattern's turn from an angle, rad."""
    return start_maps(coefficients[:, None], np.array([angle]))[:, 0]


def compute_turning_bias(device: Device, coefficients: Array, angle: float) -> Array:
    """(TURNING_TERMS,) bias that turns the pattern of the warm gyro, from an angle, rad/s: the bias
    that the electronics subtract from the output, and the residual one."""
    warm = slice_coefficients(slice(STEADY.start, WARMING.stop))
    residual = coefficients[warm].reshape(3, -1).sum(axis=0)
    return start_at(residual[:TERMS] + list_coefficients(device.bias_map), angle)[
        list(TURNING_TERMS)
    ]


def list_slow_parameters(device: Device) -> Mapping[str, float]:
    """Parameters of `HRGSlow` for a gyro without noise."""
    parameters = device.without_noise().fmu_parameters()
    return {name: value for name, value in parameters.items() if name not in LOOP_FREQUENCIES}


def _read_coefficients(
    fmu: GyroFmu,
    device: Device,
    inputs: Mapping[str, Array] | None = None,
    sweep: Sweep = SLOW,
) -> Array:
    return measure_gyro_map(fmu, list_slow_parameters(device), inputs, sweep)
