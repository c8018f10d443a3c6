"""Drift learnt from triads whose drift is known."""

from dataclasses import replace

import numpy as np
import pytest
from scipy.stats import kurtosis

from ins_eval.mission_model.gyro_map import TERMS
from ins_eval.mission_model.position_errors import TriadBlock
from ins_eval.mission_model.signals import SIGNALS
from ins_eval.study.predictors.bench_figures import collect_bench_figures
from ins_eval.study.predictors.parts.map_drift import MapDrift, compute_map_size, estimate_map_drift
from tests.ins_eval.study.predictors import cases


def _learnt(training: TriadBlock) -> MapDrift:
    bench = collect_bench_figures(training)
    return estimate_map_drift(bench, training.in_flight, training.start_angle)


def test_drift_is_found_apart_from_the_fits_uncertainty() -> None:
    """Of 6000 gyros whose drift goes with their size, seed 1: variance at the median size."""
    training = cases.triads(seed=1, count=2000, fit=0.1 * cases.SPREAD)
    found = _learnt(training)
    power = np.median(compute_map_size(collect_bench_figures(training)) ** 2)
    variance = found.common + found.relative * power
    np.testing.assert_allclose(variance, cases.DRIFT**2 * power, rtol=0.15)
    assert np.mean(found.common / variance) < 0.05


def test_drift_of_its_own_size_is_found_common() -> None:
    """The same drift in every gyro, large and small."""
    training = cases.triads(seed=1, count=2000, fit=cases.EXACT)
    same = np.median(compute_map_size(collect_bench_figures(training))) * cases.DRIFT[: 2 * TERMS]
    normal = np.random.default_rng(2).normal(size=training.fitted_map.shape)
    drifted = training.in_flight.copy()
    drifted[:, : 2 * TERMS] = training.fitted_map + same[:, None] * normal
    still = np.zeros_like(training.start_angle)
    found = _learnt(replace(training, in_flight=drifted, start_angle=still))
    np.testing.assert_allclose(found.common[: 2 * TERMS], same**2, rtol=0.15)


def test_what_occurs_together_stays_together() -> None:
    """Warming that follows the drift at power-on, and tails that are not normal."""
    training = cases.triads(seed=1, count=500, fit=cases.EXACT)
    random = np.random.default_rng(2)
    drifted = cases.SPREAD[:, None] * random.standard_t(6, size=training.fitted_map.shape)
    still = np.zeros_like(training.start_angle)
    in_flight = np.tile(drifted, (1, len(SIGNALS), 1)) + collect_bench_figures(training).maps
    found = _learnt(replace(training, in_flight=in_flight, start_angle=still))
    start, warm = np.split(found.standard, len(SIGNALS), axis=1)[:2]
    assert np.corrcoef(start[:, 3], warm[:, 3])[0, 1] > 0.99
    assert np.mean(kurtosis(found.standard)) > 1
    assert np.mean(found.standard**2) == pytest.approx(1, abs=0.05)


def test_a_fit_that_doubts_too_much_leaves_no_negative_variance() -> None:
    training = cases.triads(seed=1, count=20)
    found = _learnt(replace(training, map_variance=1e4 * training.map_variance))
    assert np.all(found.common >= 0)
    assert np.all(found.relative >= 0)
    assert np.all(found.common[: 2 * TERMS] == 0)
    assert np.all(np.isfinite(found.standard))
