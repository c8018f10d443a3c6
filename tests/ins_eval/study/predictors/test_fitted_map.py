"""The fitted map's distribution against flights of triads that are what it believes."""

from dataclasses import replace

import numpy as np
import pytest
from scipy.stats import binom

from ins_eval.mission_model.gyro_map import undo_start
from ins_eval.study.predictors import fitted_map, true_parameters
from ins_eval.study.predictors import prediction_columns as block
from ins_eval.study.predictors.bench_figures import collect_bench_figures
from ins_eval.study.predictors.parts.map_drift import NO_DRIFT
from ins_eval.study.predictors.prediction import Prediction
from ins_eval.study.predictors.unpredictable import compute_unpredictable_covariance
from tests.ins_eval.study.predictors import cases, flights

COUNT = 1000
WEIGHTS = cases.mission(seed=5)
TRIADS = cases.triads(seed=2, count=COUNT)
TRAINING = cases.triads(seed=1, count=1000)
LEARNT = block.train(TRAINING, *cases.SHEETS)
RULES = cases.class_ratios(cases.triads(seed=1, count=50), WEIGHTS)


@pytest.fixture(scope="module")
def predicted() -> dict[str, Prediction]:
    return block.predict_all(WEIGHTS, TRIADS, LEARNT, RULES, seed=3)


@pytest.mark.parametrize("key", ["fitted_map", "fitted_map_any_angle", "true_parameters"])
@pytest.mark.parametrize("share", [0.05, 0.5, 0.95])
def test_quantiles_hold_their_share(
    predicted: dict[str, Prediction], key: str, share: float
) -> None:
    """Of 1000 triads, each once: binomial, one in 10^5 outside."""
    inside = int(np.sum(flights.radial(TRIADS, WEIGHTS) <= predicted[key].radius(share)))
    assert binom.ppf(5e-6, COUNT, share) <= inside <= binom.isf(5e-6, COUNT, share)


def test_a_blind_predictor_would_fail_these_tests() -> None:
    """Without the drift that it learnt, the fitted map is too sure."""
    bench = collect_bench_figures(TRIADS)
    rest = compute_unpredictable_covariance(WEIGHTS, bench.noise, *cases.SHEETS)
    sure = fitted_map.predict(bench, WEIGHTS, NO_DRIFT, rest, TRIADS.start_angle, 3)
    radial = flights.radial(TRIADS, WEIGHTS)
    inside = np.sum((sure.radius(0.05) <= radial) & (radial <= sure.radius(0.95)))
    assert inside < binom.ppf(5e-6, COUNT, 0.9)


def test_unknown_angles_are_known_angles_averaged() -> None:
    """Mean square radius: of the draws, and of `predict` over a grid of angles, within 5 %."""
    one = cases.triads(seed=4, count=1)
    bench = collect_bench_figures(one)
    rest = compute_unpredictable_covariance(WEIGHTS, bench.noise, *cases.SHEETS)
    drawn = fitted_map.predict_any_angle(bench, WEIGHTS, LEARNT.drift, rest, seed=1)
    axis = np.pi * np.arange(9) / 9
    grid = np.stack(np.meshgrid(axis, axis, axis), axis=-1).reshape(-1, 3)
    many = collect_bench_figures(one.select([0] * len(grid)))
    others = np.repeat(rest, len(grid), axis=0)
    known = fitted_map.predict(many, WEIGHTS, LEARNT.drift, others, grid, 1)
    power = np.mean(np.sum(known.samples**2, axis=-1))
    assert np.mean(np.sum(drawn.samples**2, axis=-1)) == pytest.approx(power, rel=0.05)


def test_with_the_true_map_and_no_drift_it_is_that_of_the_true_parameters() -> None:
    known = collect_bench_figures(TRIADS)
    bench = replace(
        known,
        maps=undo_start(TRIADS.in_flight, TRIADS.start_angle),
        variance=np.zeros_like(known.variance),
    )
    rest = compute_unpredictable_covariance(WEIGHTS, TRIADS.noise, *cases.SHEETS)
    found = fitted_map.predict(bench, WEIGHTS, NO_DRIFT, rest, TRIADS.start_angle, 3)
    best = true_parameters.predict(WEIGHTS, TRIADS.in_flight, rest)
    middle = found.expected - best.expected
    sigma = np.sqrt(np.trace(best.covariance, axis1=-2, axis2=-1) / len(found.samples[0]))
    assert np.max(np.abs(middle) / sigma[..., None]) < 5
    np.testing.assert_allclose(found.radius(0.95), best.radius(0.95), rtol=0.1)


def test_only_true_parameters_see_what_is_true_of_the_flights() -> None:
    few, other = cases.triads(seed=4, count=20), cases.triads(seed=9, count=20)
    swapped = replace(
        few,
        in_flight=other.in_flight,
        turning=other.turning,
        accelerometers=other.accelerometers,
        noise=2 * few.noise,
    )
    before, after = (block.predict_all(WEIGHTS, t, LEARNT, RULES, seed=3) for t in (few, swapped))
    for key, prediction in before.items():
        same = np.array_equal(prediction.radius(0.5), after[key].radius(0.5))
        assert same != (key == "true_parameters"), key
