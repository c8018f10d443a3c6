"""Simulated sensor errors have the stated sizes; intervals are 3.5 sigma unless stated
otherwise."""

import numpy as np
import pytest

from ins_eval.imu.sensor_error_model import AxisConstants, SensorErrorModel, quantize
from pyhrg.noise.coefficients import draw_flicker, half_integral_response

INTERVAL = 0.01
ONES = np.ones((10, 3))


def draw_units(model: SensorErrorModel, count: int, truth: np.ndarray = ONES) -> np.ndarray:
    """(count, n, 3) increments of `count` units."""
    generator = np.random.default_rng(1)
    return np.array([model.measure(truth, INTERVAL, generator) for _ in range(count)])


def test_an_ideal_model_hands_the_truth_over() -> None:
    np.testing.assert_array_equal(
        SensorErrorModel().measure(ONES, INTERVAL, np.random.default_rng(1)), ONES
    )


def test_bias_and_white_noise_are_as_stated() -> None:
    """2000 units of ten intervals."""
    errors = (
        draw_units(SensorErrorModel(bias=AxisConstants(deviation=2e-3), random_walk=1e-4), 2000) - 1
    )
    bias = errors.mean(axis=1).std() / INTERVAL
    assert bias == pytest.approx(np.hypot(2e-3, 1e-4 / np.sqrt(0.1)), rel=3.5 / np.sqrt(12_000))
    noise = np.diff(errors, axis=1).std() / np.sqrt(2 * INTERVAL)
    assert noise == pytest.approx(1e-4, rel=3.5 * np.sqrt(1.5 / (2000 * 9 * 3)))


def test_constants_have_a_given_and_a_drawn_part() -> None:
    """3000 units: mean and deviation of the scale factor, axis by axis."""
    model = SensorErrorModel(scale_factor=AxisConstants((1e-4, 0.0, -2e-4), deviation=3e-5))
    factors = draw_units(model, 3000, ONES[:1])[:, 0] - 1
    spread = 3e-5 / np.sqrt(3000)
    np.testing.assert_allclose(factors.mean(axis=0), [1e-4, 0, -2e-4], rtol=0, atol=3.5 * spread)
    np.testing.assert_allclose(factors.std(axis=0), 3e-5, rtol=3.5 / np.sqrt(6000))
    assert model.scale_factor.size == pytest.approx(np.sqrt(9e-10 + 5e-8 / 3))


def test_misalignments_are_the_six_off_the_diagonal() -> None:
    model = SensorErrorModel(misalignment=AxisConstants((1.0, 2.0, 3.0, 4.0, 5.0, 6.0)))
    felt = model.measure(np.eye(3), INTERVAL, np.random.default_rng(1))
    np.testing.assert_array_equal(felt.T, [[1, 1, 2], [3, 1, 4], [5, 6, 1]])


def test_switching_an_error_on_leaves_the_others_as_they_were() -> None:
    plain = draw_units(SensorErrorModel(bias=AxisConstants(deviation=1.0)), 1)
    more = SensorErrorModel(
        bias=AxisConstants(deviation=1.0), bias_instability=1e-9, quantization_step=1e-9
    )
    np.testing.assert_allclose(draw_units(more, 1), plain, rtol=0, atol=1e-8)


def test_the_sum_of_quantised_increments_is_never_off_by_more_than_half_a_count() -> None:
    """A million increments of a third of a count: a quantiser without memory would lose all."""
    increments = np.full((1_000_000, 1), 0.1 / 3) + np.random.default_rng(1).normal(0, 0.01, (1, 1))
    counted = quantize(increments, 0.1)
    off = np.cumsum(counted / 0.1) * 0.1 - np.cumsum(increments)
    assert np.max(np.abs(off)) <= 0.05 * (1 + 1e-6)
    np.testing.assert_array_equal(counted, 0.1 * np.rint(counted / 0.1))
    assert np.std(off) == pytest.approx(0.1 / np.sqrt(12), rel=0.02)


def allan_variance(rate: np.ndarray, cluster: int) -> np.ndarray:
    """(channels,) overlapping, of means over intervals."""
    angle = np.concatenate([np.zeros((1, rate.shape[1])), np.cumsum(rate, axis=0)])
    second = angle[2 * cluster :] - 2 * angle[cluster:-cluster] + angle[: -2 * cluster]
    return np.mean((second / cluster) ** 2, axis=0) / 2


@pytest.mark.parametrize("cluster", [8, 32, 128])
def test_the_allan_floor_of_flicker_is_0664_b(cluster: int) -> None:
    """200 channels of 8192 intervals: mean Allan variance within 3.5 standard errors and 1 %, which
    is what the density's sine takes at the shortest cluster; twice B is far outside."""
    noise = draw_flicker(2.0, (8192, 200), np.random.default_rng(1))
    variance = allan_variance(noise, cluster)
    floor = 2 * np.log(2) / np.pi * 2.0**2
    tolerance = 3.5 * variance.std() / np.sqrt(200) + 0.01 * floor
    assert variance.mean() == pytest.approx(floor, abs=tolerance)
    assert tolerance < 0.1 * floor


def test_the_response_of_half_an_integral_taken_twice_is_an_integral() -> None:
    half = half_integral_response(100)
    np.testing.assert_allclose(np.convolve(half, half)[:100], np.ones(100))
