"""Sums in bins against direct sums, and the band of noise against simulated noise."""

import numpy as np
import pytest
from scipy.stats import binomtest

from pyhrg.gap.report.figures.panels import Residual, compute_edges, find_extremes, sum_in_bins
from pyhrg.gap.report.figures.views import AXES, Axis

PLAIN = Axis("rate", "Rate", "deg/s", 0.01, bins=5)
ANGLE = next(axis for axis in AXES if axis.is_angle)


def residual(n: int, seed: int = 1) -> Residual:
    generator = np.random.default_rng(seed)
    return Residual(
        generator.normal(3, 1, n), generator.normal(0, 1, n), generator.normal(0, 1, (n, 200))
    )


def test_the_ends_of_a_range_are_in_the_middle_of_bins() -> None:
    bounds = compute_edges(PLAIN, -2.0, 2.0)
    assert (bounds[1:] + bounds[:-1]) / 2 == pytest.approx([-2, -1, 0, 1, 2])


def test_means_are_those_of_the_rows_in_a_bin() -> None:
    values = np.random.default_rng(2).uniform(-2, 2, 300)
    rows = residual(300)
    rows.before[7] = rows.after[7] = np.nan
    means = sum_in_bins(values, compute_edges(PLAIN, -2.0, 2.0), PLAIN, rows).means
    for centre, before, after in zip(means.centres, means.before, means.after, strict=True):
        own = (np.abs(values - centre) < 0.5) & np.isfinite(rows.before)
        assert before == pytest.approx(rows.before[own].mean())
        assert after == pytest.approx(rows.after[own].mean())


def test_angles_start_anew_after_a_turn() -> None:
    rows = residual(4)
    bins = sum_in_bins(
        np.array([5.0, 365.0, -355.0, 355.0]), compute_edges(ANGLE, 0, 0), ANGLE, rows
    )
    assert bins.counts[0] == 3
    assert bins.counts[-1] == 1


def test_bins_of_tests_add_up() -> None:
    values, rows = np.linspace(-2, 2, 100), residual(100)
    bounds = compute_edges(PLAIN, -2.0, 2.0)
    whole = sum_in_bins(values, bounds, PLAIN, rows)
    halves = [
        sum_in_bins(
            values[part],
            bounds,
            PLAIN,
            Residual(rows.before[part], rows.after[part], rows.noise[part]),
        )
        for part in (slice(0, 50), slice(50, 100))
    ]
    assert (halves[0] + halves[1]).means.before == pytest.approx(whole.means.before)


def test_empty_bins_are_left_out() -> None:
    means = sum_in_bins(
        np.array([-2.0, 2.0]), compute_edges(PLAIN, -2.0, 2.0), PLAIN, residual(2)
    ).means
    assert means.centres == pytest.approx([-2, 2])


def test_noise_alone_is_outside_its_band_in_one_bin_of_twenty() -> None:
    generator = np.random.default_rng(3)
    outside = count = 0
    for _ in range(200):
        noise = np.cumsum(generator.normal(0, 1, (400, 201)), axis=0)
        rows = Residual(noise[:, 0], noise[:, 0], noise[:, 1:])
        values = generator.uniform(0, 1, 400)
        means = sum_in_bins(values, compute_edges(PLAIN, 0.0, 1.0), PLAIN, rows).means
        # the bins of one random walk are correlated: one of them is counted
        outside += int(abs(means.before[0]) > means.band[0])
        count += 1
    low, high = binomtest(outside, count).proportion_ci(0.99)
    assert low <= 0.05 <= high


def test_an_effect_is_outside_the_band() -> None:
    means = sum_in_bins(
        np.linspace(-2, 2, 300), compute_edges(PLAIN, -2, 2), PLAIN, residual(300)
    ).means
    assert means.count_outside(means.before) == len(means.centres)


def test_extremes_keep_every_peak() -> None:
    values = np.random.default_rng(4).normal(size=5000)
    values[[17, 4000]] = 50, -60
    values[100:200] = np.nan
    rows, low, high = find_extremes(values, 300)
    assert len(rows) <= 300
    assert (np.diff(rows) > 0).all()
    assert (low.min(), high.max()) == (-60, 50)
    assert (low <= high).all()
