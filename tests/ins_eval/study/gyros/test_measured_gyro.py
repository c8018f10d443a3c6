"""What the maker takes out, and what the bench then knows."""

import numpy as np
import pytest

from ins_eval.mission_model.gyro_map import TERMS, measure_gyro_map
from ins_eval.study.gyros.bench_plan import WARM_RISE, BenchPlan
from ins_eval.study.gyros.makers_calibration import METHODS, Method, calibrate_gyro
from ins_eval.study.gyros.measured_gyro import measure_gyro
from ins_eval.study.gyros.population import RAW
from ins_eval.study.gyros.true_maps import list_slow_parameters, soak_gyro
from pyhrg.device.device import Device
from pyhrg.fmu import GyroFmu


@pytest.fixture(scope="module")
def raw() -> Device:
    return RAW.draw(np.random.default_rng(5))


@pytest.mark.parametrize("method", METHODS)
def test_maker_takes_out_what_he_should(slow_fmu: GyroFmu, raw: Device, method: Method) -> None:
    before = measure_gyro_map(slow_fmu, list_slow_parameters(raw))
    device = calibrate_gyro(slow_fmu, raw, method, seed=1)
    left = measure_gyro_map(slow_fmu, list_slow_parameters(device))
    for was, now in zip(np.split(before, 2), np.split(left, 2), strict=True):
        assert abs(now[0]) < 0.1 * np.linalg.norm(was)
        harmonics = np.linalg.norm(now[1:]) / np.linalg.norm(was[1:])
        assert harmonics < 0.05 if method == "map" else 0.95 < harmonics < 1.05


def test_bench_knows_the_gyro(slow_fmu: GyroFmu, raw: Device) -> None:
    """Every coefficient within 4.5 standard deviations of the map that the FMU has."""
    device = calibrate_gyro(slow_fmu, raw, "map", seed=1)
    true = measure_gyro_map(slow_fmu, list_slow_parameters(device))
    known = measure_gyro(slow_fmu, device, BenchPlan(), seed=2)
    deviation = np.sqrt(known.map_variance)
    assert np.all(np.abs(known.fitted_map - true) < 4.5 * deviation)
    assert known.random_walk == pytest.approx(device.angle_random_walk, rel=0.3)
    spread = np.linalg.norm(true[1:TERMS]) / np.sqrt(2)
    assert known.circumference_stability > 0.8 * spread
    assert deviation.shape == (2 * TERMS,)


def test_bench_knows_what_the_map_gains(slow_fmu: GyroFmu, raw: Device) -> None:
    """Every coefficient's gain within 4.5 standard deviations of that which the FMU has; the gain
    of the bias is seen, far above them."""
    device = calibrate_gyro(slow_fmu, raw, "map", seed=1)
    cool, warm = (
        measure_gyro_map(slow_fmu, list_slow_parameters(soak_gyro(device, rise)))
        for rise in (0.0, WARM_RISE)
    )
    known = measure_gyro(slow_fmu, device, BenchPlan(), seed=2)
    true, deviation = (warm - cool) / WARM_RISE, np.sqrt(known.map_variance) / WARM_RISE
    assert np.all(np.abs(known.map_per_kelvin - true) < 4.5 * deviation)
    assert np.max(np.abs(true[:TERMS])) > 5 * deviation[0]
