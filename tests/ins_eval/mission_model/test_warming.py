"""Closed forms of warming against the FMU's own lag."""

import numpy as np

from ins_eval.mission_model.missions import STILL, WARM_UP
from ins_eval.mission_model.signals import (
    compute_case_warming_rate,
    compute_case_warmth,
    compute_resonator_warming_rate,
    compute_resonator_warmth,
)
from ins_eval.study.gyros.true_maps import list_slow_parameters
from pyhrg.device.device import Device
from pyhrg.fmu import GyroFmu

TIME = np.linspace(-STILL, 3600.0, 40_001)


def test_rates_are_derivatives() -> None:
    for value, rate in (
        (compute_resonator_warmth, compute_resonator_warming_rate),
        (compute_case_warmth, compute_case_warming_rate),
    ):
        found = np.gradient(value(TIME), TIME)
        np.testing.assert_allclose(found[1:-1], rate(TIME)[1:-1], atol=1e-8)
        assert value(TIME[:1])[0] == 0.0


def test_resonator_follows_the_case(slow_fmu: GyroFmu) -> None:
    """By its frequency, the thermometer, within 0.1 % of the rise."""
    device = Device(frequency_per_kelvin=85e-6, thermal_lag=WARM_UP)
    time = np.arange(1800.0)
    case = device.reference_temperature + 10 * compute_case_warmth(time - STILL)
    with slow_fmu.power_on(list_slow_parameters(device), 0, 0.0) as gyro:
        inputs = {"angularRate": np.zeros((1800, 1)), "caseTemperature": case[:, None]}
        ends, _ = gyro.record(inputs, {}, 1.0, ["frequencyOffset"])
    rise = ends[:, 0] / (device.frequency * device.frequency_per_kelvin)
    assert np.max(np.abs(rise - 10 * compute_resonator_warmth(time + 0.5 - STILL))) < 0.02
