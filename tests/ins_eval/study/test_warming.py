"""A gyro that warms at rest, against its maps."""

from dataclasses import replace

import numpy as np
import pytest

from ins_eval.study.drift import Flight, slow_parameters, true_maps
from ins_eval.study.gyro_map import HARMONICS, terms
from ins_eval.study.missions import STILL, WARM_UP
from ins_eval.study.warming import warmth
from pyhrg.device import Device
from pyhrg.fmu import GyroFmu
from pyhrg.units import DEG_PER_H

ANGLE = 0.35


@pytest.mark.parametrize("moving", [True, False])
def test_gyro_at_rest_reads_its_map_as_it_warms(slow_fmu: GyroFmu, moving: bool) -> None:
    """Within 2 % of the drift; not without the moving of the detected angle."""
    device = Device(
        damping_anisotropy=2e-6,
        damping_anisotropy_per_kelvin=5e-3,
        decay_time_per_kelvin=-3e-3,
        pickoff_gain_per_kelvin=3e-6,
        thermal_lag=WARM_UP,
    )
    flown = Flight(device, device.reference_temperature + 10, ANGLE)
    maps = true_maps(slow_fmu, flown)
    with slow_fmu.power_on(slow_parameters(flown.warming), 0, ANGLE) as gyro:
        rate = np.diff(gyro.drive(np.zeros(1200), 1.0))[20:]
    warm = warmth(np.arange(21, 1200) + 0.5 - STILL)
    bias = [m.bias @ terms(np.array(ANGLE)) for m in (maps.started, maps.warming, maps.curving)]
    expected = bias[0] + warm * bias[1] + warm**2 * bias[2]
    if moving:
        growth = (1 - warm) / WARM_UP
        expected = expected + growth * angle_error(maps.warming.scale)
        expected = expected + 2 * warm * growth * angle_error(maps.curving.scale)
    apart = float(np.abs(rate - expected).max() / np.ptp(rate))
    assert (apart < 0.02) is moving


def angle_error(scale: np.ndarray) -> float:
    total = 0.0
    for place, h in enumerate(HARMONICS):
        cos, sin = scale[1 + 2 * place : 3 + 2 * place]
        total += (sin * np.cos(h * ANGLE) - cos * np.sin(h * ANGLE)) / (h * 0.277)
    return total


def test_flight_that_stays_cool_gains_nothing(slow_fmu: GyroFmu) -> None:
    device = replace(Device(damping_anisotropy=2e-6), decay_time_per_kelvin=-3e-3)
    maps = true_maps(slow_fmu, Flight(device, device.reference_temperature, ANGLE))
    assert np.abs(maps.warming.bias).max() < 1e-6 * DEG_PER_H
