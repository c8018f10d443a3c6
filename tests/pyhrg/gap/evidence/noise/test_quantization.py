"""A step of the output angle, seen where there is one and only there."""

from dataclasses import replace

import numpy as np
import pytest

from pyhrg.common.units import ARCSEC, DEG, DEG_PER_H
from pyhrg.device.device import Device
from pyhrg.gap.effects.catalogue import NOISES
from pyhrg.gap.evidence.noise.noise_search import AddedNoise, NoiseFound
from pyhrg.gap.evidence.noise.quantization import counted, is_rough, quantum
from pyhrg.gap.replay.observations import Observed, observed
from pyhrg.gap.whitening.whitening import SlowNoise
from pyhrg.records.campaign import Test
from tests.pyhrg.records.made_up import made_up_log


def at_rest(
    step: float, rate: float = 9.67 * DEG_PER_H, jump: float = 0.0, flicker: float = 0.0
) -> Observed:
    """An hour of a gyro at rest whose rate changes once, on a table whose encoder flickers; noise
    of 0.04 arcsec and a walk."""
    log = made_up_log(3600)
    generator = np.random.default_rng(6)
    noise = np.cumsum(generator.normal(0, 0.02, 3600)) + generator.normal(0, 0.04, 3600)
    angle = rate * log.time + jump * np.maximum(log.time - 1800, 0) + noise * ARCSEC
    if step:
        angle = step * np.round(angle / step)
    still = np.zeros(3600)
    table = flicker * generator.integers(0, 2, 3600)
    given = replace(log, gyro_angle=angle, table_angle=table, virtual_rotation=still)
    return observed(Test("still", "static", "fit", given), Device())


@pytest.mark.parametrize("arcsec", [0.1, 0.3, 1.0])
def test_a_step_is_found(arcsec: float) -> None:
    found = quantum([at_rest(arcsec * ARCSEC)])
    assert found is not None
    assert found[0] == pytest.approx(arcsec * ARCSEC, abs=3 * found[1])
    assert found[1] < 1e-4 * found[0]


def test_the_encoder_s_last_digit_hides_no_step() -> None:
    found = quantum([at_rest(0.3 * ARCSEC, flicker=1e-5 * DEG)])
    assert found is not None
    assert found[0] == pytest.approx(0.3 * ARCSEC, rel=1e-4)


def test_no_step_is_found_where_there_is_none() -> None:
    assert quantum([at_rest(0.0)]) is None
    assert quantum([]) is None


def test_a_change_of_rate_is_no_step() -> None:
    assert quantum([at_rest(0.0, jump=15 * ARCSEC)] * 2) is None


def test_a_step_is_told_in_place_of_its_white_noise() -> None:
    white = next(noise for noise in NOISES if noise.name == "angle_white_noise")
    level = 0.1 * ARCSEC
    found = NoiseFound(SlowNoise(level), (AddedNoise(white, level, (level, level), 9.0, -5.0),))
    step = 0.3 * ARCSEC
    (added,) = counted(found, [at_rest(step)], 0.0).added
    assert added.effect.name == "angle_quantisation"
    assert added.interval[0] < step < added.interval[1]
    assert counted(found, [at_rest(step)], step) == found
    assert counted(found, [at_rest(0.0)], 0.0) == found


@pytest.mark.parametrize(("arcsec", "rough"), [(0.0, False), (0.07, False), (0.1, True)])
def test_a_step_of_more_than_twice_the_noise_is_rough(arcsec: float, rough: bool) -> None:
    device = Device(pickoff_noise=0.04 * ARCSEC)
    found = counted(NoiseFound(SlowNoise(1.0), ()), [at_rest(arcsec * ARCSEC)], 0.0)
    assert is_rough(found, device) == rough
    believed = replace(device, angle_quantum=arcsec * ARCSEC)
    assert is_rough(NoiseFound(SlowNoise(1.0), ()), believed) == rough
