"""A quantization step is found where there is one, and only there."""

from dataclasses import replace

import numpy as np
import pytest

from pyhrg.common.units import ARCSEC, DEG, DEG_PER_H
from pyhrg.device.device import Device
from pyhrg.gap.evidence.noise.quantization import (
    find_quantization,
    find_quantization_step,
    put_quantization,
)
from pyhrg.gap.replay.observations import ObservedTest, observe_test
from pyhrg.gap.whitening.smoothing import is_coarsely_quantized
from pyhrg.records.campaign import Test
from tests.pyhrg.records.made_up import made_up_log


def at_rest(
    step: float, rate: float = 9.67 * DEG_PER_H, jump: float = 0.0, toggle: float = 0.0
) -> ObservedTest:
    """An hour of a gyro at rest whose rate changes once, on a table whose encoder flickers; noise
    of 0.04 arcsec and a walk."""
    log = made_up_log(3600)
    generator = np.random.default_rng(6)
    noise = np.cumsum(generator.normal(0, 0.02, 3600)) + generator.normal(0, 0.04, 3600)
    angle = rate * log.time + jump * np.maximum(log.time - 1800, 0) + noise * ARCSEC
    if step:
        angle = step * np.round(angle / step)
    still = np.zeros(3600)
    table = toggle * generator.integers(0, 2, 3600)
    given = replace(log, gyro_angle=angle, table_angle=table, virtual_rotation=still)
    return observe_test(Test("still", "static", "fit", given), Device())


@pytest.mark.parametrize("arcsec", [0.1, 0.3, 1.0])
def test_a_step_is_found(arcsec: float) -> None:
    found = find_quantization_step([at_rest(arcsec * ARCSEC)])
    assert found is not None
    assert found[0] == pytest.approx(arcsec * ARCSEC, abs=3 * found[1])
    assert found[1] < 1e-4 * found[0]


def test_the_encoder_s_last_digit_hides_no_step() -> None:
    found = find_quantization_step([at_rest(0.3 * ARCSEC, toggle=1e-5 * DEG)])
    assert found is not None
    assert found[0] == pytest.approx(0.3 * ARCSEC, rel=1e-4)


def test_no_step_is_found_where_there_is_none() -> None:
    assert find_quantization_step([at_rest(0.0)]) is None
    assert find_quantization_step([]) is None


def test_a_change_of_rate_is_no_step() -> None:
    assert find_quantization_step([at_rest(0.0, jump=15 * ARCSEC)] * 2) is None


def test_a_step_that_is_stated_is_no_gap() -> None:
    step = 0.3 * ARCSEC
    found = find_quantization([at_rest(step)], 0.0)
    assert found is not None
    assert found.effect.name == "angle_quantisation"
    assert found.interval[0] < step < found.interval[1]
    assert find_quantization([at_rest(step)], step) is None
    assert find_quantization([at_rest(step)], 0.0, []) is None
    assert find_quantization([at_rest(0.0)], 0.0) is None


@pytest.mark.parametrize(("arcsec", "is_coarse"), [(0.0, False), (0.07, False), (0.1, True)])
def test_a_step_of_more_than_twice_the_noise_is_coarse(arcsec: float, is_coarse: bool) -> None:
    device = Device(angle_white_noise=0.04 * ARCSEC)
    found = find_quantization([at_rest(arcsec * ARCSEC)], 0.0)
    assert is_coarsely_quantized(put_quantization(device, found)) == is_coarse
