"""A gyro at rest, as it warms and heats and feels gravity, against its coefficients."""

from dataclasses import replace

import numpy as np
import pytest

from ins_eval.mission_model.gyro_map import HARMONICS, TERMS, evaluate_terms
from ins_eval.mission_model.missions import STILL, WARM_UP
from ins_eval.mission_model.signals import (
    COUNT,
    SIGNALS,
    compute_case_warming_rate,
    compute_resonator_warming_rate,
    compute_resonator_warmth,
)
from ins_eval.study.gyros.drift import Flight
from ins_eval.study.gyros.true_maps import (
    compute_turning_bias,
    list_slow_parameters,
    read_flight_coefficients,
    start_at,
)
from pyhrg.common.units import DEG_PER_H
from pyhrg.device.device import AngleMap, Device
from pyhrg.fmu import GyroFmu
from pyhrg.theory import closed_forms as theory

ANGLE = 0.35
TIME = np.arange(1200.0) + 0.5 - STILL
DEVICE = Device(
    damping_anisotropy=2e-6,
    damping_anisotropy_per_kelvin=5e-3,
    decay_time_per_kelvin=-3e-3,
    pickoff_gain_per_kelvin=3e-6,
    bias_per_temperature_rate=0.05 * DEG_PER_H * WARM_UP / 10,
    bias_per_acceleration=1e-3 * DEG_PER_H,
    pickoff_gain_per_acceleration=1e-7,
    thermal_lag=WARM_UP,
)


def _rates(fmu: GyroFmu, flown: Flight, force: float) -> np.ndarray:
    """At rest, (1200,) rad/s."""
    case = flown.case_temperature(np.arange(1200.0) - STILL)
    inputs = {
        "angularRate": np.zeros(1200),
        "caseTemperature": case,
        "accelerationX": np.full(1200, force),
        "accelerationZ": np.full(1200, -force),
    }
    with fmu.power_on(list_slow_parameters(flown.device), 0, ANGLE) as gyro:
        moving = {name: values[:, None] for name, values in inputs.items()}
        angle = gyro.record(moving, {}, 1.0, ["gyroAngle"])[0][:, 0]
    return np.diff(angle, prepend=0.0)


@pytest.mark.parametrize("left_out", [None, "angle", "heating", "force"])
def test_gyro_at_rest_reads_its_map(slow_fmu: GyroFmu, left_out: str | None) -> None:
    """Within 2 % of the drift; not without the moving of the detected angle, heating, or force."""
    flown = Flight(DEVICE, 10.0, ANGLE)
    maps = read_flight_coefficients(slow_fmu, DEVICE, flown.rise).reshape(len(SIGNALS), 2, TERMS)
    bias = maps[:, 0] @ evaluate_terms(np.array(ANGLE))
    warm, force = compute_resonator_warmth(TIME), 5.0
    signals = np.stack([np.ones_like(warm), warm, warm**2, compute_case_warming_rate(TIME)])
    signals = np.concatenate([signals, np.full((3, len(warm)), [[force], [-force], [0.0]])])
    if left_out == "heating":
        signals[3] = 0.0
    if left_out == "force":
        signals[4:] = 0.0
    expected = bias @ signals
    if left_out != "angle":
        expected = expected + compute_resonator_warming_rate(TIME) * _angle_error(maps[1, 1])
        expected = expected + 2 * warm * compute_resonator_warming_rate(TIME) * _angle_error(
            maps[2, 1]
        )
    rate = _rates(slow_fmu, flown, force)
    apart = float(np.abs(rate - expected)[20:].max() / np.ptp(rate[20:]))
    assert (apart < 0.02) is (left_out is None)


def _angle_error(scale: np.ndarray) -> float:
    total = 0.0
    for place, h in enumerate(HARMONICS):
        cos, sin = scale[1 + 2 * place : 3 + 2 * place]
        total += (sin * np.cos(h * ANGLE) - cos * np.sin(h * ANGLE)) / (h * 0.277)
    return total


def test_flight_that_stays_cool_gains_nothing(slow_fmu: GyroFmu) -> None:
    found = read_flight_coefficients(slow_fmu, replace(DEVICE, bias_per_temperature_rate=0.0), 0.0)
    warming = found.reshape(len(SIGNALS), 2, TERMS)[1:4, 0]
    assert np.abs(warming).max() < 1e-6 * DEG_PER_H


def test_pattern_turns_by_what_the_electronics_take_out(slow_fmu: GyroFmu) -> None:
    """A gyro whose map is taken out drifts by it all the same: the FMU's own pattern, 1 %."""
    device = Device(damping_anisotropy=2e-6, bias_map=AngleMap(mean=1e-6, sin4=-1.8e-6))
    found = read_flight_coefficients(slow_fmu, device, 0.0)
    assert found.shape == (COUNT,)
    mean, cos4, _ = compute_turning_bias(device, found, ANGLE)
    with slow_fmu.power_on(list_slow_parameters(device), 0, ANGLE) as gyro:
        inputs = {"angularRate": np.zeros((100, 1))}
        pattern = gyro.record(inputs, {}, 1.0, ["patternAngle"])[0][:, 0]
    rate = -(pattern[-1] - pattern[0]) / 99 / 0.277
    assert mean + cos4 == pytest.approx(rate, rel=0.01)
    at_start = start_at(found, ANGLE).reshape(len(SIGNALS), 2, TERMS)[0, 0]
    assert abs(at_start[0] + at_start[3] - rate) > 0.1 * abs(rate)


def test_delayed_loops_make_a_bias_of_the_rate_squared(slow_fmu: GyroFmu) -> None:
    """A gain mismatch with a hold of 1 ms: the closed form, 3 %; of its harmonic, nothing else."""
    device = Device(pickoff_gain_mismatch=1e-3, control_period=1e-3, amplitude_loop=30.0)
    squared = read_flight_coefficients(slow_fmu, device, 0.0).reshape(len(SIGNALS), 2, TERMS)[-1, 0]
    lag = theory.late_ripple(1.0, 0.5e-3, device.bryan_factor, 1.0).real
    assert np.hypot(squared[3], squared[4]) == pytest.approx(lag * 1e-3, rel=0.03)
    assert np.hypot(*squared[[0, 7]]) < 0.03 * lag * 1e-3
