"""The motion keeps the encoder's increments, and rests where the table rests."""

import numpy as np
import pytest

from pyhrg.common.arrays import Array
from pyhrg.common.units import ARCSEC, DEG
from pyhrg.gap.replay.inputs.table_motion import TableMotion, estimate_table_motion

ROWS = 600
MOVES = (40.3, 150.7, 300.1, 450.55)
"""Times at which moves begin, s."""
RATE, ACCELERATION = 20 * DEG, 10 * DEG
"""Of a move, rad/s and rad/s^2."""
DURATION = 4.1
"""From the begin of a move to the begin of its deceleration, s."""


def integrate(rates: Array, interval: float) -> Array:
    return np.asarray(np.cumsum((rates[1:] + rates[:-1]) / 2) * interval)


def assert_increments_kept(motion: TableMotion, angle: Array) -> None:
    kept = np.cumsum(motion.means) * motion.interval
    np.testing.assert_allclose(kept, angle, atol=1e-12 * np.abs(angle).max())


def make_moves(seconds: Array) -> Array:
    """(n,) angle after moves with ramps of 2 s that begin and end within rows, rad."""
    since = seconds[:, None] - np.array(MOVES)
    ramps = [_ramped(since - delay) for delay in (0.0, DURATION)]
    return np.asarray((ramps[0] - ramps[1]).sum(axis=1))


def _ramped(since: Array) -> Array:
    top = RATE / ACCELERATION
    ramp = np.clip(since, 0.0, top)
    return ACCELERATION * ramp**2 / 2 + RATE * np.maximum(since - top, 0.0)


@pytest.mark.parametrize("n", [2, 3, 5])
def test_few_rows(n: int) -> None:
    angle = integrate(0.1 * np.arange(n + 1.0), 0.5)
    assert_increments_kept(estimate_table_motion(angle, 0.5), angle)


@pytest.mark.parametrize("interval", [0.1, 1.0])
def test_a_smooth_profile_is_reproduced(interval: float) -> None:
    time = np.arange(0, 200 + interval / 2, interval)
    rates = 0.3 * np.sin(2 * np.pi * time / 50) ** 2
    motion = estimate_table_motion(integrate(rates, interval), interval)
    np.testing.assert_allclose(motion.rates, rates, atol=1e-4)
    assert_increments_kept(motion, integrate(rates, interval))


@pytest.mark.parametrize("noise", [0.01, 0.1, 1.0])
def test_noise_of_the_encoder_bends_no_ramp(noise: float) -> None:
    """The rate at each row's end is known to a few times the noise of a reading a row."""
    rates = np.tile(np.concatenate([np.zeros(600), np.full(20, 0.07)]), 8)
    generator = np.random.default_rng(7)
    angle = integrate(rates, 1.0) + noise * ARCSEC * generator.standard_normal(len(rates) - 1)
    motion = estimate_table_motion(angle, 1.0, noise * ARCSEC)
    np.testing.assert_allclose(motion.rates, rates, atol=10 * noise * ARCSEC)
    assert_increments_kept(motion, angle)


def test_a_ramp_of_one_row_is_reproduced() -> None:
    rates = np.concatenate([np.zeros(20), np.full(50, 0.09), np.zeros(30)])
    motion = estimate_table_motion(integrate(rates, 1.0), 1.0)
    np.testing.assert_allclose(motion.rates, rates, atol=1e-12)
    np.testing.assert_allclose(motion.parabola_means, 0.0, atol=1e-12)


@pytest.mark.parametrize("digits", [4, 5, 6])
def test_rounding_of_the_encoder_does_not_alternate(digits: int) -> None:
    rates = np.concatenate([np.zeros(20), np.full(21, 4.06137), np.zeros(300)] * 3) * DEG
    rounded = np.round(integrate(rates, 1.0) / DEG, digits) * DEG
    motion = estimate_table_motion(rounded, 1.0)
    step = 10.0**-digits * DEG
    np.testing.assert_allclose(motion.rates, rates, atol=2 * step)
    resting = (rates[1:] == 0) & (rates[:-1] == 0)
    np.testing.assert_allclose(motion.means[resting], 0.0, atol=1e-15)
    np.testing.assert_allclose(motion.parabola_means[resting], 0.0, atol=0.1 * step)
    assert_increments_kept(motion, rounded)


@pytest.mark.parametrize("noise", [0.0, 1e-7, 1e-6])
def test_a_table_that_moves_within_rows_comes_to_rest(noise: float) -> None:
    generator = np.random.default_rng(1)
    angle = make_moves(np.arange(1.0, ROWS + 1)) + noise * generator.normal(size=ROWS)
    motion = estimate_table_motion(angle, 1.0)
    assert_increments_kept(motion, angle)
    since = np.arange(ROWS + 1.0)[:, None] - np.array(MOVES)
    resting = ((since < -2) | (since > DURATION + 4)).all(axis=1)
    assert np.abs(motion.rates[resting]).max() < 5 * noise + 1e-9
    true = np.gradient(make_moves(np.arange(0.0, ROWS + 1, 1e-3)), 1e-3)[::1000]
    assert np.abs(motion.rates - true[: ROWS + 1]).max() < 0.15 * RATE


@pytest.mark.parametrize("steps", [1, 2, 10, 100])
def test_steps_add_up_to_rows(steps: int) -> None:
    motion = TableMotion(2.0, np.array([0.0, 0.3, 0.1]), np.array([0.05, -0.02]))
    each = motion.compute_rates(steps)
    np.testing.assert_allclose(each.mean(axis=1), motion.means)
    middles = np.cumsum(each, axis=1) - each / 2
    turned = motion.compute_turns(steps)
    assert turned.shape == (2, steps)
    if steps == 100:
        np.testing.assert_allclose(turned, middles * 2.0 / steps, atol=2e-5)
    np.testing.assert_allclose(motion.section(slice(1, 3)).compute_rates(steps), each[1:3])


def test_a_table_at_rest_has_no_rate() -> None:
    motion = estimate_table_motion(np.zeros(10), 1.0)
    assert not motion.rates.any()
    assert not motion.parabola_means.any()
