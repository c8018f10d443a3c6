"""Drift learnt from triads whose drift is known."""

from dataclasses import replace

import numpy as np

from ins_eval.study.gyro_map import TERMS
from ins_eval.study.predictors.knowledge import bench_knowledge
from ins_eval.study.predictors.map_drift import MapDrift, learnt, map_size
from ins_eval.study.triads import Triads
from tests.ins_eval.study.predictors import cases


def _learnt(training: Triads) -> MapDrift:
    bench = bench_knowledge(training)
    return learnt(bench, training.started, training.warming, training.start_angle)


def test_drift_is_found_apart_from_the_fits_uncertainty() -> None:
    """Of 6000 gyros whose drift goes with their size, seed 1; of 784 products the worst was 0.11
    off in five seeds. A variance too small to be told from none counts as the little it may be."""
    training = cases.triads(seed=1, count=2000)
    found = _learnt(training)
    assert found.gyros == 6000
    power = np.median(map_size(bench_knowledge(training)) ** 2)
    true = cases.DRIFT**2 * power
    sigmas = np.sqrt(true + np.concatenate([cases.FIT**2, np.zeros(2 * TERMS)]))
    error = (found.common + found.relative * power - np.diag(true)) / np.outer(sigmas, sigmas)
    assert np.max(np.abs(error)) < 0.15
    assert np.max(np.diag(found.common) / sigmas**2) < 0.1


def test_drift_of_its_own_size_is_found_common() -> None:
    """The same drift in every gyro, large and small; the worst was 13 % off in five seeds."""
    training = cases.triads(seed=1, count=2000, exact_fit=True)
    same = np.median(map_size(bench_knowledge(training))) * cases.DRIFT[: 2 * TERMS]
    normal = np.random.default_rng(2).normal(size=training.known.shape)
    still = np.zeros_like(training.start_angle)
    drifted = training.known + same[:, None] * normal
    found = _learnt(replace(training, started=drifted, start_angle=still))
    half = np.diag(found.common)[: 2 * TERMS]
    np.testing.assert_allclose(half, same**2, rtol=0.15)


def test_a_fit_that_doubts_too_much_leaves_no_negative_variance() -> None:
    training = cases.triads(seed=1, count=20)
    found = _learnt(replace(training, covariance=1e4 * training.covariance))
    for part in (found.common, found.relative):
        scale = np.sqrt(np.maximum(np.diag(part), 1e-300))
        assert np.linalg.eigvalsh(part / np.outer(scale, scale)).min() > -1e-9
