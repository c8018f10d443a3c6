"""The noise floor against closed forms; p-values of white and of coloured residuals."""

from dataclasses import replace

import numpy as np
import pytest

from pyhrg.device.device import Device
from pyhrg.gap.closing.verification import (
    compute_gap_figures,
    compute_whiteness,
    draw_angles,
    estimate_noise_floor,
    measure_areas,
    measure_distance,
)
from pyhrg.gap.replay.observations import ObservedTest, observe_test
from pyhrg.gap.whitening.whitening import NoiseModel, draw_noise
from pyhrg.records.campaign import Test
from tests.pyhrg.records.made_up import made_up_log

WHITE, WALK, N = 0.3, 0.02, 1000
NOISE = NoiseModel(WHITE, angle_random_walk=WALK)


def watched(n: int) -> ObservedTest:
    return observe_test(Test(str(n), "static", "holdout", made_up_log(n)), Device())


def test_the_floor_is_that_of_white_noise_and_a_walk() -> None:
    """Mean square of the angle white^2 + walk^2 T/2; of the rate (2 white^2 + 100 walk^2)/100^2."""
    tests = [watched(N) for _ in range(40)]
    low, median, high = estimate_noise_floor(tests, draw_angles(tests, NOISE))
    assert median[0] == pytest.approx(np.sqrt(WHITE**2 + WALK**2 * N / 2), rel=0.08)
    rate = np.sqrt(2 * WHITE**2 + 100 * WALK**2) / 100
    assert median[1] == pytest.approx(rate, rel=0.02)
    assert low[1] < rate < high[1]


def test_residuals_of_noise_are_within_the_floor() -> None:
    """Of 20, 19 are expected within the 95 % interval; 15 or more have a chance of 0.9997."""
    within = 0
    for seed in range(20):
        tests = [watched(400), watched(600)]
        generator = np.random.default_rng(100 + seed)
        draws = [draw_noise(NOISE, len(t.log.time), 1.0, generator) for t in tests]
        low, _, high = estimate_noise_floor(tests, draw_angles(tests, NOISE, seed=2))[:, 0]
        within += low <= measure_distance(tests, draws)[0] <= high
    assert within >= 15


def test_areas_between_distributions_are_closed_forms() -> None:
    """Of white noise s and itself, moved by d: d; and twice as large: s sqrt(2 / pi)."""
    test, generator = watched(4000), np.random.default_rng(5)
    white = generator.normal(0.0, WHITE, 4000)
    white[:5] = np.nan
    draws = draw_angles([test], NoiseModel(WHITE))
    areas = measure_areas([[white + 2.0], [2 * white], [white]], draws)
    moved, doubled, same, low, median, high = areas[:, 0]
    assert moved == pytest.approx(2.0, abs=0.02)
    assert doubled == pytest.approx(WHITE * np.sqrt(2 / np.pi), rel=0.05)
    assert low < same < high < 0.06 * WHITE
    assert low < median < high


def test_a_held_out_test_without_a_compared_angle_has_no_figures() -> None:
    """An amplitude that never settles: nothing can be said of the held-out gap."""
    held_out, fitted = (
        watched(N),
        observe_test(Test("fitted", "static", "fit", made_up_log(N)), Device()),
    )
    none, residual = np.full(N, np.nan), np.zeros(N)
    gap = compute_gap_figures([fitted, held_out], [residual, none], [residual, none], NOISE)
    assert np.isfinite(gap.fit_angle_arcsec.floor)
    assert gap.holdout_angle_arcsec is None
    assert gap.whiteness is None


def test_missing_rows_are_left_out() -> None:
    test = watched(N)
    residual = np.full(N, 2.0)
    residual[10:20] = np.nan
    assert measure_distance([test], [residual])[0] == pytest.approx(2.0)


def test_a_short_test_has_no_rate_over_100_s() -> None:
    test = watched(60)
    assert np.isnan(measure_distance([test], [np.zeros(60)])[1])


def test_whiteness() -> None:
    test = watched(N)
    generator = np.random.default_rng(4)
    p = [
        compute_whiteness([test], [draw_noise(NOISE, N, 1.0, generator)], NOISE) for _ in range(20)
    ]
    assert min(p) > 1e-4
    assert max(p) > 0.3
    drifting = draw_noise(NOISE, N, 1.0, generator) + 2 * np.sin(np.arange(N) / 5)
    assert compute_whiteness([test], [drifting], NOISE) < 1e-6
    assert (
        compute_whiteness(
            [test], [draw_noise(NOISE, N, 1.0, generator)], replace(NOISE, angle_random_walk=0.0)
        )
        < 1e-6
    )
