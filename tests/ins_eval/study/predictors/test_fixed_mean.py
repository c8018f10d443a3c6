"""The fixed position's mean bias: exact where the bias is constant, and blind to the harmonics."""

from dataclasses import replace

import numpy as np

from ins_eval.mission_model.gyro_map import start_maps
from ins_eval.mission_model.position_errors import compute_expected_error
from ins_eval.study.predictors import fixed_mean
from ins_eval.study.predictors.bench_figures import collect_bench_figures
from tests.ins_eval.study.predictors import cases

WEIGHTS = cases.mission(seed=5)
TRIADS = cases.triads(seed=2, count=50)
NONE = np.zeros((50, 1, 2, 2))


def predict() -> fixed_mean.NormalPrediction:
    return fixed_mean.predict(collect_bench_figures(TRIADS), WEIGHTS, NONE)


def test_constant_bias_is_predicted_whatever_the_start_angle() -> None:
    maps = np.zeros_like(TRIADS.in_flight)
    maps[:, fixed_mean.CONSTANT_BIAS] = TRIADS.fixed_bias
    flown = compute_expected_error(WEIGHTS, start_maps(maps, TRIADS.start_angle))
    np.testing.assert_allclose(predict().expected, flown, rtol=1e-9)


def test_spread_is_that_of_the_repeatability() -> None:
    """Errors of biases that scatter by it, 3000 draws: variances within 12 %."""
    scatter = np.random.default_rng(3).normal(size=(3000, *TRIADS.fixed_repeatability.shape))
    carried = WEIGHTS.maps[0, :, fixed_mean.CONSTANT_BIAS]
    errors = (scatter * TRIADS.fixed_repeatability) @ carried.T
    variance = np.diagonal(predict().covariance[:, 0], axis1=-2, axis2=-1)
    np.testing.assert_allclose(errors.var(axis=0), variance, rtol=0.12)


def test_nothing_but_the_fixed_position_is_used() -> None:
    """Other maps and another circumference give the same prediction."""
    other = replace(
        TRIADS,
        fitted_map=2 * TRIADS.fitted_map,
        circumference_stability=2 * TRIADS.circumference_stability,
        start_angle=TRIADS.start_angle + 1,
    )
    found = fixed_mean.predict(collect_bench_figures(other), WEIGHTS, NONE)
    np.testing.assert_array_equal(found.expected, predict().expected)
    np.testing.assert_array_equal(found.covariance, predict().covariance)
