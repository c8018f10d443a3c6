"""Fits of rows whose noise is known."""

from dataclasses import replace

import numpy as np
import pytest
from scipy.fft import dst
from scipy.stats import binom

from pyhrg.bench.estimation.row_fit import Part, _Problem, compute_inflations, fit_rows

INTERVAL = 0.5


def noisy(seed: int, rate: float, angle: float, slope: float = 2.0, n: int = 200) -> Part:
    """Increments of an angle that drifts, with white rate and white angle noise."""
    generator = np.random.default_rng(seed)
    readings = generator.normal(0.0, angle, n + 1)
    walk = generator.normal(0.0, rate * np.sqrt(INTERVAL), n)
    one = np.full(n, INTERVAL)
    wave = INTERVAL * np.sin(np.linspace(0.0, 9.0, n))
    values = slope * one + 3.0 * wave + walk + np.diff(readings)
    return Part({"slope": one, "wave": wave}, values, INTERVAL)


@pytest.mark.parametrize(("rate", "angle"), [(1.0, 0.0), (0.0, 1.0), (0.05, 1.0), (0.3, 1.0)])
def test_intervals_hold_the_truth(rate: float, angle: float) -> None:
    """200 repeats: as many inside as a binomial of 95 % lets fall below once in 10 000."""
    repeats = 200
    inside = 0
    for seed in range(repeats):
        low, high = fit_rows([noisy(seed, rate, angle)], ["slope", "wave"]).interval("slope")
        inside += low <= 2.0 <= high
    assert inside >= binom.ppf(1e-4, repeats, 0.95)


def test_too_small_a_noise_is_found_out() -> None:
    """Negative control: increments taken for independent have intervals far too wide here."""
    part = noisy(1, 0.0, 1.0)
    reach = np.diff(fit_rows([part], ["slope", "wave"]).interval("slope"))[0] / 2
    independent = 1.96 * np.std(part.values) / np.sqrt(len(part)) / INTERVAL
    assert reach < independent / 4


def test_exact_values_are_fitted_exactly() -> None:
    fit = fit_rows([noisy(1, 0.0, 0.0)], ["slope", "wave"])
    assert fit.value("slope") == pytest.approx(2.0, rel=1e-12)
    assert fit.value("wave") == pytest.approx(3.0, rel=1e-12)


def test_channels_have_their_own_noise() -> None:
    """A coarse channel beside a fine one changes nothing of what the fine one tells."""
    fine, coarse = noisy(1, 1e-3, 1e-3), noisy(2, 1.0, 1.0)
    both = [fine, Part(coarse.columns, coarse.values, INTERVAL, "coarse")]
    alone, together = fit_rows([fine], ["slope", "wave"]), fit_rows(both, ["slope", "wave"])
    assert together.value("slope") == pytest.approx(alone.value("slope"), abs=1e-5)


def test_dependent_terms_are_refused() -> None:
    part = noisy(1, 1.0, 0.0)
    twice = Part({**part.columns, "again": part.columns["slope"]}, part.values, INTERVAL)
    assert compute_inflations([twice], ["slope", "wave", "again"])["slope"] == np.inf
    with pytest.raises(ValueError, match="can't be separated"):
        fit_rows([twice], ["slope", "wave", "again"])


def test_too_few_rows_are_refused() -> None:
    part = noisy(1, 1.0, 0.0, n=3)
    with pytest.raises(ValueError, match="3 rows"):
        fit_rows([part], ["slope", "wave"])


@pytest.mark.parametrize(("rows", "least", "most"), [(12, 1.03, 1.5), (1000, 1.0, 1.003)])
def test_estimated_weights_cost_precision(rows: int, least: float, most: float) -> None:
    """Two channels whose noise is known from a few rows are weighed wrongly; not so of many."""
    parts = [replace(noisy(seed, 1.0, 0.0, n=rows), channel=str(seed)) for seed in (5, 6)]
    matrix = dst(np.stack([part.columns["slope"] for part in parts]), type=1, norm="ortho")
    values = dst(np.stack([part.values for part in parts]), type=1, norm="ortho")
    components = np.kron(np.eye(2), INTERVAL * np.ones(rows))
    problem = _Problem(values.ravel(), matrix.reshape(-1, 1), components)
    densities, spread = problem.average_positive(problem.estimate_densities())
    covariance = problem.solve(densities)[1]
    wider = problem.widen(covariance, densities, spread)
    assert least <= np.sqrt(wider[0, 0] / covariance[0, 0]) <= most
    assert problem.widen(covariance, densities, 0 * spread) == pytest.approx(covariance)
