"""What the maker takes out, and what the bench then knows."""

import numpy as np
import pytest

from ins_eval.mission_model.gyro_map import TERMS, characterised
from ins_eval.study.gyros.bench_plan import WARMER, BenchPlan
from ins_eval.study.gyros.knowledge import knowledge
from ins_eval.study.gyros.maker import METHODS, Method, calibrated_gyro
from ins_eval.study.gyros.population import RAW
from ins_eval.study.gyros.true_maps import slow_parameters, soaked
from pyhrg.device.device import Device
from pyhrg.fmu import GyroFmu


@pytest.fixture(scope="module")
def raw() -> Device:
    return RAW.draw(np.random.default_rng(5))


@pytest.mark.parametrize("method", METHODS)
def test_maker_takes_out_what_he_should(slow_fmu: GyroFmu, raw: Device, method: Method) -> None:
    before = characterised(slow_fmu, slow_parameters(raw))
    device = calibrated_gyro(slow_fmu, raw, method, seed=1)
    left = characterised(slow_fmu, slow_parameters(device))
    for was, now in ((before.bias, left.bias), (before.scale, left.scale)):
        assert abs(now[0]) < 0.1 * np.linalg.norm(was)
        harmonics = np.linalg.norm(now[1:]) / np.linalg.norm(was[1:])
        assert harmonics < 0.05 if method == "map" else 0.95 < harmonics < 1.05


def test_bench_knows_the_gyro(slow_fmu: GyroFmu, raw: Device) -> None:
    """Every coefficient within 4.5 standard deviations of the map that the FMU has."""
    device = calibrated_gyro(slow_fmu, raw, "map", seed=1)
    true = characterised(slow_fmu, slow_parameters(device))
    known = knowledge(slow_fmu, device, BenchPlan(), seed=2)
    deviation = np.sqrt(known.variance)
    assert np.all(np.abs(known.map.coefficients - true.coefficients) < 4.5 * deviation)
    assert known.walk == pytest.approx(device.angle_random_walk, rel=0.3)
    spread = np.linalg.norm(true.bias[1:]) / np.sqrt(2)
    assert known.circumference_stability > 0.8 * spread
    assert deviation.shape == (2 * TERMS,)


def test_bench_knows_what_the_map_gains(slow_fmu: GyroFmu, raw: Device) -> None:
    """Every coefficient's gain within 4.5 standard deviations of that which the FMU has; the gain
    of the bias is seen, far above them."""
    device = calibrated_gyro(slow_fmu, raw, "map", seed=1)
    cool, warm = (
        characterised(slow_fmu, slow_parameters(soaked(device, rise))).coefficients
        for rise in (0.0, WARMER)
    )
    known = knowledge(slow_fmu, device, BenchPlan(), seed=2)
    true, deviation = (warm - cool) / WARMER, np.sqrt(known.variance) / WARMER
    assert np.all(np.abs(known.gain.coefficients - true) < 4.5 * deviation)
    assert np.max(np.abs(true[:TERMS])) > 5 * deviation[0]


def test_one_power_on_shows_no_scatter(slow_fmu: GyroFmu, raw: Device) -> None:
    with pytest.raises(ValueError, match="found 1 power-on of each test, expected 2 or more"):
        knowledge(slow_fmu, raw, BenchPlan(runs=1), seed=2)
