"""Maps that the mechanisms tell, against those of the simulated gyro and of a simulated flight."""

from dataclasses import replace

import numpy as np
import pytest

from ins_eval.mission_model.gyro_map import TERMS
from ins_eval.mission_model.missions import STILL
from ins_eval.mission_model.signals import ENVIRONMENT, compute_case_warmth, slice_coefficients
from ins_eval.study.gyros.true_maps import read_flight_coefficients
from ins_eval.study.witness.estimated_map import (
    EstimatedMap,
    compute_angle_errors,
    compute_estimated_map,
)
from pyhrg.common.units import DEG_PER_H, STANDARD_GRAVITY
from pyhrg.fmu import GyroFmu
from pyhrg.witness.mechanisms import COUNT, change_device, find, read_values
from pyhrg.witness.responses import Responses, measure_responses
from tests.pyhrg.witness.flights import GYRO, PRIOR, draw_changes, weave

RISE, STEP = 8.0, 0.01
FLOWN = replace(
    change_device(GYRO, draw_changes(PRIOR, np.random.default_rng(2))).without_noise(),
    bias_per_temperature_rate=1e-4,
    bias_per_acceleration=0.02 * DEG_PER_H / STANDARD_GRAVITY,
    pickoff_gain_per_acceleration=2e-5 / STANDARD_GRAVITY,
)


@pytest.fixture(scope="module")
def estimated(slow_fmu: GyroFmu) -> EstimatedMap:
    """The maps by the true changes."""
    responses: Responses = measure_responses(slow_fmu, GYRO)
    changes = read_values(FLOWN) - read_values(GYRO)
    changes[find("bias per rate of temperature")] = FLOWN.bias_per_temperature_rate
    return compute_estimated_map(slow_fmu, GYRO, changes, np.zeros((COUNT, COUNT)), responses, RISE)


def test_they_are_those_of_the_gyro(slow_fmu: GyroFmu, estimated: EstimatedMap) -> None:
    """Bias at power-on, its change while the gyro warms, and by heating, to 0.1 % of the largest
    or 1e-5 deg/h."""
    true = read_flight_coefficients(slow_fmu, FLOWN, RISE)
    warm = slice_coefficients(slice(0, ENVIRONMENT.start + 1))
    bias = np.arange(warm.stop) % (2 * TERMS) < TERMS
    found, expected = estimated.mean[warm][bias], true[warm][bias]
    for signal in np.split(np.arange(len(found)), ENVIRONMENT.start + 1):
        tolerance = max(1e-3 * np.abs(expected[signal]).max(), 1e-5 * DEG_PER_H)
        assert found[signal] == pytest.approx(expected[signal], abs=tolerance)


def test_a_flight_is_corrected(fmu: GyroFmu, estimated: EstimatedMap) -> None:
    """What the maps make of the increments of ten minutes of a warming gyro that weaves and sways,
    and what is left: a hundredth."""
    time = STEP * np.arange(60_001) - STILL
    rate = weave(time[:-1] + STILL)
    sway = np.sin(2 * np.pi * (time[:-1] + STILL) / 150)
    force = STANDARD_GRAVITY * np.stack([0.3 * sway, 0 * sway, 1 + 0.1 * sway], axis=1)
    moving = {
        "angularRate": rate[:, None],
        "caseTemperature": GYRO.reference_temperature
        + RISE * compute_case_warmth(time[:-1])[:, None],
    }
    with fmu.power_on(FLOWN.fmu_parameters(), 0, 0.7) as gyro:
        held = {f"acceleration{name}": force[:, i] for i, name in enumerate("XYZ")}
        ends, _ = gyro.record(moving, held, STEP, ["gyroAngle", "patternAngle"])
    pattern = np.concatenate([[0.7], ends[:, 1]])
    rotation = np.diff(ends[:, 0], prepend=0.0)
    errors = compute_angle_errors(estimated, pattern, time, rotation, force)
    begin = round(100 / STEP)
    error = np.cumsum((rotation - STEP * rate)[begin:])
    left = error - np.cumsum(errors[begin:])
    assert np.std(left) < 0.02 * np.std(error)
