"""The recursive estimate on synthetic rows: consistent, robust, and honest about its model."""

import numpy as np
import pytest
from scipy.stats import chi2

from pyhrg.common.arrays import Array
from pyhrg.witness.filter import filter_rows

STATES, ROWS, NOISE = 4, 600, np.array([0.5, 2.0])


def draw_problem(generator: np.random.Generator) -> tuple[Array, Array, Array]:
    """Sensitivities, values and the true states, whose prior is standard normal."""
    design = generator.normal(0.0, 0.2, (ROWS, 2, STATES))
    truth = generator.standard_normal(STATES)
    return design, design @ truth + NOISE * generator.standard_normal((ROWS, 2)), truth


def normalize(error: Array, covariance: Array) -> float:
    return float(error @ np.linalg.solve(covariance, error))


def test_it_is_the_batch_estimate(generator: np.random.Generator) -> None:
    design, values, _ = draw_problem(generator)
    values = np.clip(values, -1e9, 1e9)
    found = filter_rows(design, values, NOISE, np.eye(STATES))
    scaled = (design / NOISE[:, None]).reshape(-1, STATES)
    information = np.eye(STATES) + scaled.T @ scaled
    batch = np.linalg.solve(information, scaled.T @ (values / NOISE).ravel())
    assert found.mean == pytest.approx(batch, abs=3e-2)
    assert found.covariance == pytest.approx(np.linalg.inv(information), rel=0.05, abs=1e-4)


@pytest.mark.parametrize("bursts", [False, True])
def test_nees_is_in_its_band(generator: np.random.Generator, bursts: bool) -> None:
    """99 % band of chi-square, over 60 problems; a burst of fifty times the noise in a tenth of the
    rows does not leave it."""
    values = []
    for _ in range(60):
        design, measured, truth = draw_problem(generator)
        if bursts:
            measured[100:160] += 50 * NOISE * generator.standard_normal((60, 2))
        found = filter_rows(design, measured, NOISE, np.eye(STATES))
        values.append(normalize(found.mean - truth, found.covariance))
    degrees = 60 * STATES
    assert chi2.ppf(0.005, degrees) < sum(values) < chi2.ppf(0.995, degrees)


def test_what_the_states_do_not_make_is_noticed(generator: np.random.Generator) -> None:
    design, values, _ = draw_problem(generator)
    assert filter_rows(design, values, NOISE, np.eye(STATES)).p_value > 1e-3
    drifting = values + NOISE * np.sin(np.arange(ROWS) / 60)[:, None]
    assert filter_rows(design, drifting, NOISE, np.eye(STATES)).p_value < 1e-6
