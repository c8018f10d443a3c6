"""Which resonators of a campaign had settled before their logs began."""

from dataclasses import replace

import numpy as np

from pyhrg.device.device import Device
from pyhrg.gap.preparation import observe_tests
from pyhrg.records.campaign import Test
from tests.pyhrg.records.made_up import made_up_log

DEVICE = Device(frequency_per_kelvin=8.5e-5)
ROWS = 600


def log_warmth(start: float, is_settled: bool) -> Test:
    """A log whose case begins at a departure from the reference, K, and warms by 0.3 K; its
    resonator begins there too, or at the reference."""
    case = start + 0.3 * (1 - np.exp(-np.arange(ROWS) / 300))
    warmth = np.empty(ROWS)
    last = start if is_settled else 0.0
    for i in range(ROWS):
        last += (case[i] - last) / DEVICE.thermal_lag
        warmth[i] = last
    slope = DEVICE.frequency * DEVICE.frequency_per_kelvin
    temperature = DEVICE.reference_temperature + case
    log = replace(made_up_log(ROWS), temperature=temperature, frequency_offset=slope * warmth - 3.0)
    return Test(f"{start}", "static", "fit", log)


def find_settled(*tests: Test) -> list[bool]:
    return [test.inputs.is_soaked for test in observe_tests(tests, DEVICE)]


def test_a_laboratory_that_waits_before_one_log_waits_before_others() -> None:
    far, near, cold = log_warmth(-1.4, True), log_warmth(-0.9, True), log_warmth(-0.9, False)
    assert find_settled(near, cold) == [False, False]
    assert find_settled(far, near, cold) == [True, True, False]
