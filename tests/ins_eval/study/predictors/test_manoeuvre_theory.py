"""The manoeuvre's theory against maps of random phase."""

from dataclasses import replace

import numpy as np
import pytest

from ins_eval.mission_model.gyro_map import TERMS
from ins_eval.mission_model.position_errors import compute_map_errors
from ins_eval.study.predictors import manoeuvre_theory
from pyhrg.common.units import DEG_PER_H
from tests.ins_eval.study.predictors import cases

NONE = np.zeros((1, 1, 2, 2))


def test_covariance_is_that_of_random_phases() -> None:
    """20 000 maps of the fourth and the eighth harmonic, seed 1; sigmas of a fourth moment."""
    weights, n = cases.mission(seed=3), 20_000
    stability = np.array([[0.1, 0.2, 0.05]]) * DEG_PER_H
    shares = np.array([0.0, 0.7, 0.0, 0.3])
    phases = np.random.default_rng(1).uniform(0, 2 * np.pi, (n, 2, 3))
    amplitude = np.sqrt(2 * shares[[1, 3], None]) * stability
    maps = np.zeros((n, 2 * TERMS, 3))
    maps[:, [3, 7]], maps[:, [4, 8]] = amplitude * np.cos(phases), amplitude * np.sin(phases)
    errors = compute_map_errors(weights.gyros, maps)[:, 0]
    found = manoeuvre_theory.predict(stability, weights, NONE, shares).covariance[0, 0]
    scatter = np.sqrt(np.var(errors[:, :, None] * errors[:, None, :], axis=0) / n)
    assert np.all(np.abs(errors.T @ errors / n - found) < 4 * scatter)


def test_it_knows_the_manoeuvre() -> None:
    """A pattern that doesn't turn leaves nothing where bias itself is calibrated out."""
    weights = cases.mission(seed=3)
    still = replace(weights, maps=np.zeros_like(weights.maps))
    found = manoeuvre_theory.predict(np.full((1, 3), DEG_PER_H), still, NONE)
    assert float(found.radius(0.95)[0, 0]) == 0.0


def test_shares_of_harmonics() -> None:
    maps = np.zeros((2, 2 * TERMS, 3))
    maps[:, 3], maps[:, 8], maps[:, TERMS + 1] = 3.0, 4.0, 100.0
    found = manoeuvre_theory.estimate_harmonic_shares(maps)
    assert found == pytest.approx(np.array([0.0, 0.36, 0.0, 0.64]))
