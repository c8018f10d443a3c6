"""What noise leaves, against closed forms; whiteness of white and of other residuals."""

from dataclasses import replace

import numpy as np
import pytest

from pyhrg.device.device import Device
from pyhrg.gap.closing.verification import distance, floor, whiteness
from pyhrg.gap.replay.observations import Observed, observed
from pyhrg.gap.whitening.noise_draws import drawn
from pyhrg.gap.whitening.whitening import SlowNoise
from pyhrg.records.campaign import Test
from tests.pyhrg.records.made_up import made_up_log

WHITE, WALK, N = 0.3, 0.02, 1000
NOISE = SlowNoise(WHITE, walk=WALK)


def watched(n: int) -> Observed:
    return observed(Test(str(n), "static", "holdout", made_up_log(n)), Device())


def test_the_floor_is_that_of_white_noise_and_a_walk() -> None:
    """Mean square of the angle white^2 + walk^2 T/2; of the rate (2 white^2 + 100 walk^2)/100^2."""
    tests = [watched(N) for _ in range(40)]
    found = floor(tests, NOISE, seed=1)
    assert found.angle.value == pytest.approx(np.sqrt(WHITE**2 + WALK**2 * N / 2), rel=0.08)
    rate = np.sqrt(2 * WHITE**2 + 100 * WALK**2) / 100
    assert found.rate.value == pytest.approx(rate, rel=0.02)
    assert found.rate.interval[0] < rate < found.rate.interval[1]


def test_residuals_of_noise_are_as_far_as_the_floor_says() -> None:
    """19 of 20 within 95 %, at least 15: a chance of 0.9997."""
    within = 0
    for seed in range(20):
        tests = [watched(400), watched(600)]
        generator = np.random.default_rng(100 + seed)
        own = distance(tests, [drawn(NOISE, len(t.log.time), 1.0, generator) for t in tests])
        low, high = floor(tests, NOISE, seed=2).angle.interval
        within += low <= own.angle <= high
    assert within >= 15


def test_rows_that_miss_are_left_out() -> None:
    test = watched(N)
    residual = np.full(N, 2.0)
    residual[10:20] = np.nan
    assert distance([test], [residual]).angle == pytest.approx(2.0)


def test_a_short_test_has_no_rate_over_100_s() -> None:
    test = watched(60)
    assert np.isnan(distance([test], [np.zeros(60)]).rate)


def test_whiteness() -> None:
    test = watched(N)
    generator = np.random.default_rng(4)
    p = [whiteness([test], [drawn(NOISE, N, 1.0, generator)], NOISE) for _ in range(20)]
    assert min(p) > 1e-4
    assert max(p) > 0.3
    drifting = drawn(NOISE, N, 1.0, generator) + 2 * np.sin(np.arange(N) / 5)
    assert whiteness([test], [drifting], NOISE) < 1e-6
    assert whiteness([test], [drawn(NOISE, N, 1.0, generator)], replace(NOISE, walk=0.0)) < 1e-6
