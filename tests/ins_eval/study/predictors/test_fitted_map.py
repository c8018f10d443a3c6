"""The fitted map's distribution against flights of triads that are what it believes."""

from dataclasses import replace

import numpy as np
import pytest
from scipy.stats import binom, chi2

from ins_eval.study.predictors import block, fitted_map, oracle
from ins_eval.study.predictors.knowledge import bench_knowledge
from ins_eval.study.predictors.map_drift import NO_DRIFT
from ins_eval.study.predictors.prediction import Normal
from ins_eval.study.predictors.turned_maps import unstarted
from ins_eval.study.predictors.unpredictable import unpredictable
from tests.ins_eval.study.predictors import cases, flights

COUNT = 1000
WEIGHTS = cases.mission(seed=5)
TRIADS = cases.triads(seed=2, count=COUNT)
LEARNT = block.learnt(cases.triads(seed=1, count=1000), cases.ACCELEROMETER_BIAS)
PREDICTED = block.predictions(WEIGHTS, TRIADS, LEARNT, seed=3)


def test_errors_are_normal_about_the_expected_with_its_covariance() -> None:
    """Squared distances in units of the covariance are chi-square: mean of n within four sigmas."""
    found = PREDICTED["fitted_map"]
    assert isinstance(found, Normal)
    missed = (flights.errors(TRIADS, WEIGHTS) - found.expected)[:, 0]
    squared = np.einsum("ri,rij,rj->r", missed, np.linalg.inv(found.covariance[:, 0]), missed)
    assert abs(squared.mean() - 2) < 4 * np.sqrt(4 / COUNT)
    assert abs(np.mean(squared < chi2.ppf(0.9, 2)) - 0.9) < 4 * np.sqrt(0.09 / COUNT)


@pytest.mark.parametrize(
    "key", ["fitted_map", "fitted_map_any_angle", "oracle", "oracle_any_angle"]
)
@pytest.mark.parametrize("share", [0.05, 0.5, 0.95])
def test_quantiles_hold_their_share(key: str, share: float) -> None:
    """Of 1000 triads, each once: binomial, one in 10^5 outside."""
    inside = int(np.sum(flights.radial(TRIADS, WEIGHTS) <= PREDICTED[key].radius(share)))
    assert binom.ppf(5e-6, COUNT, share) <= inside <= binom.isf(5e-6, COUNT, share)


def test_a_blind_predictor_would_fail_these_tests() -> None:
    """Without the drift that it learnt, the fitted map is too sure."""
    bench = bench_knowledge(TRIADS)
    rest = unpredictable(WEIGHTS, bench.noise, cases.ACCELEROMETER_BIAS)
    sure = fitted_map.predict(bench, WEIGHTS, NO_DRIFT, rest, TRIADS.start_angle)
    radial = flights.radial(TRIADS, WEIGHTS)
    inside = np.sum((sure.radius(0.05) <= radial) & (radial <= sure.radius(0.95)))
    assert inside < binom.ppf(5e-6, COUNT, 0.9)


def test_unknown_angles_are_known_angles_averaged() -> None:
    """Mean square radius: of the draws, and of `predict` over a grid of angles, within 5 %."""
    one = cases.triads(seed=4, count=1)
    bench = bench_knowledge(one)
    rest = unpredictable(WEIGHTS, bench.noise, cases.ACCELEROMETER_BIAS)
    drawn = fitted_map.predict_any_angle(bench, WEIGHTS, LEARNT.drift, rest, seed=1)
    axis = np.pi * np.arange(9) / 9
    grid = np.stack(np.meshgrid(axis, axis, axis), axis=-1).reshape(-1, 3)
    known = [fitted_map.predict(bench, WEIGHTS, LEARNT.drift, rest, angle[None]) for angle in grid]
    power = [np.sum(p.expected**2) + np.trace(p.covariance[0, 0]) for p in known]
    assert np.mean(np.sum(drawn.draws**2, axis=-1)) == pytest.approx(np.mean(power), rel=0.05)


def test_with_the_true_map_and_no_drift_it_is_the_oracle() -> None:
    still = replace(TRIADS, warming=np.zeros_like(TRIADS.warming))
    bench = replace(
        bench_knowledge(still),
        maps=unstarted(still.started, still.start_angle),
        covariance=np.zeros_like(still.covariance),
    )
    rest = unpredictable(WEIGHTS, still.noise, cases.ACCELEROMETER_BIAS)
    found = fitted_map.predict(bench, WEIGHTS, NO_DRIFT, rest, still.start_angle)
    best = oracle.predict(WEIGHTS, still.started, still.warming, rest)
    np.testing.assert_allclose(found.expected, best.expected, rtol=1e-9, atol=1e-6)
    np.testing.assert_allclose(found.covariance, best.covariance)


def test_only_oracles_see_what_is_true_of_the_flights() -> None:
    few, other = cases.triads(seed=4, count=20), cases.triads(seed=9, count=20)
    swapped = replace(
        few,
        started=other.started,
        warming=other.warming,
        accelerometers=other.accelerometers,
        noise=2 * few.noise,
    )
    before, after = (block.predictions(WEIGHTS, t, LEARNT, seed=3) for t in (few, swapped))
    for key, prediction in before.items():
        same = np.array_equal(prediction.radius(0.5), after[key].radius(0.5))
        assert same != key.startswith("oracle"), key
