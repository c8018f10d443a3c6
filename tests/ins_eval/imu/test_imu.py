"""A whole unit: simulated, and what a linear model should believe of it."""

from dataclasses import replace

import numpy as np
import pytest

from ins_eval.common.sensor_errors import SensorErrors
from ins_eval.imu.gyros import FmuGyros
from ins_eval.imu.imu import Imu
from ins_eval.imu.mounting import make_mounting
from ins_eval.imu.specification import list_imus, load_imu
from pyhrg.common.errors import HrgError
from pyhrg.common.units import ARCSEC, DEG_PER_H, DEG_PER_SQRT_H, MICRO_G, STANDARD_GRAVITY
from pyhrg.fmu import GyroFmu
from pyhrg.records.imu.log import Increments
from tests.ins_eval.imu.logs import resting

TRUTH = resting(10.0)


def test_an_ideal_unit_hands_the_truth_over_however_it_is_mounted() -> None:
    measured = Imu().measure(TRUTH, seed=1)
    np.testing.assert_array_equal(measured.increments.rotation, TRUTH.rotation)
    np.testing.assert_array_equal(measured.increments.velocity, TRUTH.velocity)
    assert measured.pattern_angle is None
    skewed = Imu(mounting=make_mounting([[1, 0, 1], [-1, 2, 1], [-1, -2, 1]])).measure(
        TRUTH, seed=1
    )
    np.testing.assert_allclose(skewed.increments.rotation, TRUTH.rotation, rtol=0, atol=1e-19)


@pytest.mark.parametrize("name", list_imus())
def test_one_seed_gives_the_same_bytes_and_another_others(name: str, fmu: GyroFmu) -> None:
    unit = load_imu(name)
    if isinstance(unit.gyros, FmuGyros):
        unit = replace(unit, gyros=replace(unit.gyros, fmu=fmu, calibrated=False))
    first, again, other = (unit.measure(TRUTH, seed).increments for seed in (1, 1, 2))
    assert first.rotation.tobytes() == again.rotation.tobytes()
    assert first.velocity.tobytes() == again.velocity.tobytes()
    if name != "ideal":
        assert first.rotation.tobytes() != other.rotation.tobytes()
        assert first.velocity.tobytes() != other.velocity.tobytes()


def test_increments_at_another_interval_are_refused() -> None:
    with pytest.raises(HrgError, match=r"increments over 0\.01 s, expected 0\.005 s"):
        Imu(interval=0.005).measure(TRUTH, seed=1)


def test_a_mounting_error_leaves_the_other_draws_as_they_were() -> None:
    unit = load_imu("simple")
    plain = unit.measure(TRUTH, seed=1).increments
    tilted = replace(unit, mounting_deviation=1e-3).measure(TRUTH, seed=1).increments
    np.testing.assert_array_equal(tilted.velocity, plain.velocity)
    moved = np.abs(tilted.rotation - plain.rotation).max()
    assert 0 < moved < 5e-3 * np.abs(plain.rotation).max()


def test_the_errors_to_believe_are_those_of_the_file() -> None:
    assert load_imu("ideal").errors == SensorErrors()
    expected = SensorErrors(
        gyro_bias=0.01 * DEG_PER_H,
        angle_random_walk=0.002 * DEG_PER_SQRT_H,
        gyro_bias_instability=0.003 * DEG_PER_H,
        accelerometer_bias=np.hypot(50 * MICRO_G, 5 * ARCSEC * STANDARD_GRAVITY),
        velocity_random_walk=0.006 / 60,
        accelerometer_bias_instability=10 * MICRO_G,
        velocity_quantization_step=1e-5,
    )
    for name, value in vars(expected).items():
        assert getattr(load_imu("simple").errors, name) == pytest.approx(value), name


def test_the_errors_are_those_that_units_have() -> None:
    """1000 units at rest for 10 s: bias and random walk of gyros and level accelerometers together,
    within 3.5 sigma of the linear model's; instability is left out for its own test."""
    file = load_imu("simple")
    models = [
        replace(t, bias_instability=0.0) for t in (file.gyros.error_model, file.accelerometers)
    ]  # type: ignore[attr-defined]
    unit = Imu(replace(file.gyros, error_model=models[0]), models[1])  # type: ignore[type-var]
    truth = Increments(0.01, TRUTH.rotation[:1000], TRUTH.velocity[:1000])
    flown = [unit.measure(truth, seed).increments for seed in range(1000)]
    rate = np.array([(m.rotation - truth.rotation).sum(axis=0) / 10 for m in flown])
    force = np.array([(m.velocity - truth.velocity).sum(axis=0) / 10 for m in flown])[:, :2]
    errors = unit.errors
    for errors_of_units, bias, walk in (
        (rate, errors.gyro_bias, errors.angle_random_walk),
        (force, errors.accelerometer_bias, errors.velocity_random_walk),
    ):
        assumed = np.hypot(bias, walk / np.sqrt(10))
        assert errors_of_units.std() == pytest.approx(
            assumed, rel=3.5 / np.sqrt(2 * errors_of_units.size)
        )
