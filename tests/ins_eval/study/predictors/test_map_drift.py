"""Drift learnt from triads whose drift is known."""

import numpy as np

from ins_eval.study.gyro_map import TERMS
from ins_eval.study.predictors.knowledge import bench_knowledge
from ins_eval.study.predictors.map_drift import learnt
from tests.ins_eval.study.predictors import cases


def test_drift_is_found_apart_from_the_fits_uncertainty() -> None:
    """Of 1500 gyros, seed 1, within five sigmas: variances, and nothing correlated."""
    training = cases.triads(seed=1, count=500)
    found = learnt(
        bench_knowledge(training), training.started, training.warming, training.start_angle
    )
    assert found.gyros == 1500
    fit = np.concatenate([cases.FIT, np.zeros(2 * TERMS)]) / cases.SPREAD[0]
    sigmas = np.hypot(cases.DRIFT, fit)
    error = (found.relative - np.diag(cases.DRIFT**2)) / np.outer(sigmas, sigmas)
    assert np.all(np.abs(error) < 5 * np.sqrt(2 / 1500))


def test_a_fit_that_doubts_too_much_leaves_no_negative_variance() -> None:
    training = cases.triads(seed=1, count=20)
    bench = bench_knowledge(training)
    doubting = type(bench)(**{**vars(bench), "covariance": 1e4 * bench.covariance})
    found = learnt(doubting, training.started, training.warming, training.start_angle)
    scale = np.sqrt(np.maximum(np.diag(found.relative), 1e-300))
    assert np.linalg.eigvalsh(found.relative / np.outer(scale, scale)).min() > -1e-9
