"""The share of noise that grows as the amplitude falls, against drawn noise."""

from dataclasses import replace

import numpy as np
import pytest

from pyhrg.device.device import Device
from pyhrg.gap.replay.noise_growth import (
    CHANNELS_PER_AMPLITUDE,
    add_noise_growth,
    estimate_growing_share,
    find_level,
)
from pyhrg.gap.replay.observations import ObservedTest, observe_test
from pyhrg.gap.whitening.channel_noise import build_angle_noise, estimate_campaign_noise
from pyhrg.records.campaign import Test
from tests.pyhrg.records.made_up import made_up_log

N = 1500
DEVICE = Device(angle_random_walk=1e-7)
SIGMA = 6e-5
DRIVEN = 60
"""Rows before the drive is off."""


def observe_ring_down(share: float, seed: int = 1) -> ObservedTest:
    """A ring-down whose frequency has noise of which this share of the variance grows."""
    log = made_up_log(N)
    level = np.exp(-np.maximum(np.arange(N) - DRIVEN, 0) / 450)
    noise = SIGMA * np.sqrt(1 - share + share / level**2)
    frequency = 1e-2 * level**2 + noise * np.random.default_rng(seed).normal(size=N)
    free = replace(
        log,
        drive_on=(np.arange(N) < DRIVEN) * 1.0,
        amplitude=level,
        frequency_offset=frequency,
    )
    return observe_test(Test("ring", "ring_down", "fit", free), DEVICE)


@pytest.mark.parametrize("share", [0.0, 0.5, 1.0])
def test_the_share_is_estimated(share: float) -> None:
    test = observe_ring_down(share)
    found = estimate_growing_share("frequency_offset", [(test, find_level(test.log, DEVICE))])
    assert found == pytest.approx(share, abs=0.15)


def test_noise_is_that_of_each_amplitude() -> None:
    (test,) = add_noise_growth([observe_ring_down(1.0)], DEVICE)
    residual = {name: np.zeros(N) for name in ("amplitude", "amplitude_force", "quadrature_force")}
    residual["frequency_offset"] = test.log.frequency_offset
    noise = estimate_campaign_noise(DEVICE, [test], [residual])
    model = noise.get_model("frequency_offset", test)
    level = find_level(test.log, DEVICE)
    np.testing.assert_allclose(model.compute_white_noise(N), SIGMA / level, rtol=0.1)


def test_a_free_amplitude_walks_once_the_drive_is_off() -> None:
    (test,) = add_noise_growth([observe_ring_down(0.0)], DEVICE)
    residual = {name: np.zeros(N) for name in test.rows if name != "temperature"}
    noise = replace(
        estimate_campaign_noise(DEVICE, [test], [residual]), angle=build_angle_noise(DEVICE)
    )
    model = noise.get_model("amplitude", test)
    assert model.angle_random_walk == pytest.approx(2 * DEVICE.bryan_factor * 1e-7)
    np.testing.assert_array_equal(model.compute_walk_growth(N), np.arange(N) >= DRIVEN)
    np.testing.assert_array_equal(model.compute_white_noise(N), model.angle_white_noise)


def test_a_steady_amplitude_says_nothing() -> None:
    test = observe_test(Test("still", "static", "fit", made_up_log(N)), DEVICE)
    own = [(test, find_level(test.log, DEVICE))]
    assert all(estimate_growing_share(name, own) == 0.0 for name in CHANNELS_PER_AMPLITUDE)
    assert add_noise_growth([test], DEVICE)[0].noise_growth == {}


def test_held_out_tests_say_nothing() -> None:
    test = observe_ring_down(1.0)
    held_out = replace(test, test=replace(test.test, role="holdout"))
    assert "frequency_offset" not in add_noise_growth([held_out], DEVICE)[0].noise_growth
    both = add_noise_growth([test, held_out], DEVICE)
    assert "frequency_offset" in both[1].noise_growth


def test_missing_amplitudes_are_interpolated() -> None:
    log = observe_ring_down(0.0).log
    gappy = replace(log, amplitude=np.where(np.arange(N) % 7 == 3, np.nan, log.amplitude))
    np.testing.assert_allclose(find_level(gappy, DEVICE), find_level(log, DEVICE), rtol=1e-4)


def test_a_log_without_any_amplitude_has_that_of_its_set_point() -> None:
    log = observe_ring_down(0.0).log
    nowhere = replace(log, drive_on=np.zeros(N), amplitude=np.full(N, np.nan))
    expected = log.amplitude_setpoint / DEVICE.amplitude
    np.testing.assert_array_equal(find_level(nowhere, DEVICE), expected)
