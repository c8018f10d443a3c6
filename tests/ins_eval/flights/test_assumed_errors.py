"""What the linear model assumes of IMUs."""

import math

import numpy as np
import pytest

from ins_eval.error_model.effects import misalignment
from ins_eval.error_model.motion import sample_motion
from ins_eval.flights.assumed_errors import (
    ASSUMED_FLICKER_TIMES,
    assume_errors,
)
from ins_eval.imu import specification
from ins_eval.imu.imu import Imu
from ins_eval.imu.sensor_error_model import AxisConstants, SensorErrorModel
from ins_eval.imu.stated_gyros import StatedGyros
from ins_eval.trajectories import catalogue
from pyhrg.noise.coefficients import compute_process_variance


def allan_variance(correlation_time: float, time: float) -> float:
    """Of a Gauss-Markov process of variance 1 (IEEE Std 952-2020, C.1)."""
    x = time / correlation_time
    return 2 / x * (1 - (3 - 4 * math.exp(-x) + math.exp(-2 * x)) / (2 * x))


@pytest.mark.parametrize("time", [100.0, 200.0, 500.0, 1e3, 2e3, 5e3, 1e4, 3e4])
def test_processes_a_decade_apart_have_flickers_allan_deviation(time: float) -> None:
    variance = compute_process_variance(1.0) * sum(
        allan_variance(each, time) for each in ASSUMED_FLICKER_TIMES
    )
    assert math.sqrt(variance) == pytest.approx(math.sqrt(2 * math.log(2) / math.pi), rel=0.05)


def test_simple_imu_is_assumed_as_its_file_says() -> None:
    imu = specification.load_imu("simple")
    assumed = assume_errors(imu)
    sizes = dict(zip((e.name for e in assumed.effects), assumed.deviations[:, 0], strict=True))
    assert sizes["gyro bias"] == imu.errors.gyro_bias
    process = math.sqrt(compute_process_variance(imu.errors.gyro_bias_instability))
    assert sizes["gyro bias instability"] == process
    assert sizes["accelerometer bias"] == imu.accelerometers.bias.deviation
    assert sizes["accelerometer scale factor"] == imu.accelerometers.scale_factor.deviation
    assert all("instability" not in effect.name for effect in assumed.constant.effects)


def test_ideal_imu_has_no_effects() -> None:
    assert assume_errors(specification.load_imu("ideal")).effects == ()


def test_calibrated_whole_angle_gyros_have_a_map() -> None:
    names = [effect.name for effect in assume_errors(specification.load_imu("typical-hrg")).effects]
    assert sum(name.startswith("bias map") for name in names) == 2
    assert sum(name.startswith("pick-off map") for name in names) == 2


def test_stated_biases_stay_on_their_axes() -> None:
    """Not spread over all three, as they were."""
    stated = AxisConstants((2e-8, 0.0, -1e-8), 1e-8)
    misaligned = AxisConstants((1e-5, 2e-5, 3e-5, 4e-5, 5e-5, 6e-5))
    triad = SensorErrorModel(bias=stated, misalignment=misaligned)
    assumed = assume_errors(Imu(gyros=StatedGyros(triad), accelerometers=triad))
    sizes = dict(zip((e.name for e in assumed.effects), assumed.deviations, strict=True))
    expected = np.hypot([2e-8, 0.0, 1e-8], 1e-8)
    np.testing.assert_allclose(sizes["gyro bias"], expected)
    np.testing.assert_allclose(sizes["accelerometer bias"], expected)
    np.testing.assert_allclose(sizes["gyro misalignment, next axis"], [1e-5, 4e-5, 5e-5])
    np.testing.assert_allclose(sizes["gyro misalignment, axis after"], [2e-5, 3e-5, 6e-5])


def test_misalignment_feels_the_other_axes() -> None:
    motion = sample_motion(catalogue.load_trajectory("car", 60.0), 0.0, 1.0, 60)
    following, after = (effect.regressor(motion) for effect in misalignment("accelerometer"))
    np.testing.assert_array_equal(following[:, 0], motion.force[:, 1])
    np.testing.assert_array_equal(after[:, 0], motion.force[:, 2])
    np.testing.assert_array_equal(following[:, 2], motion.force[:, 0])
