"""Quantization step of a coarse thermometer, and the noise that it adds to other channels."""

from dataclasses import replace

import numpy as np
import pytest
from scipy.stats import norm

from pyhrg.common.arrays import Array
from pyhrg.device.device import Device
from pyhrg.gap.replay.inputs.thermometer import (
    correct_temperatures,
    estimate_reading_steps,
    estimate_thermometer_noise,
    estimate_toggling_step,
)
from pyhrg.gap.replay.observations import CHANNELS, observe_test
from pyhrg.gap.whitening.channel_noise import estimate_campaign_noise
from pyhrg.records.campaign import Test
from tests.pyhrg.records.made_up import made_up_log

ROWS = 2000
TRUE = 298.15 + np.interp(np.arange(ROWS), [500, 1500], [0.0, 20.0])
NOISE = 5e-3


def read_thermometer(step: float, seed: int = 1) -> Array:
    noisy = TRUE + NOISE * np.random.default_rng(seed).normal(size=ROWS) - 273.15
    return np.asarray((np.round(noisy / step) * step if step else noisy) + 273.15)


@pytest.mark.parametrize("step", [0.05, 0.1, 1.0])
def test_the_step_of_a_coarse_log_is_found(step: float) -> None:
    logs = {
        "coarse": read_thermometer(step),
        "still": np.full(ROWS, 298.15),
        "fine": read_thermometer(0.0),
    }
    expected = {"coarse": step, "still": step, "fine": 0.0}
    assert estimate_reading_steps(logs) == pytest.approx(expected)


def test_a_rounded_step_is_found() -> None:
    printed = np.round(read_thermometer(0.0625) - 273.15, 2)
    assert estimate_reading_steps({"printed": printed})["printed"] == pytest.approx(0.0625, rel=0.1)


SET_POINT = np.where(np.arange(ROWS) < 500, 298.15, 318.15)


@pytest.mark.parametrize(
    "log",
    [read_thermometer(0.0), read_thermometer(1e-3), TRUE[:9], np.full(9, np.nan), SET_POINT],
    ids=range(5),
)
def test_a_fine_log_has_no_step(log: Array) -> None:
    assert estimate_reading_steps({"fine": log}) == {"fine": 0.0}
    assert estimate_toggling_step(log) == 0.0


def test_a_single_change_of_a_set_point_is_no_toggling() -> None:
    assert estimate_toggling_step(TRUE) == 0.0
    assert estimate_toggling_step(np.where(np.arange(ROWS) < 500, 298.15, 298.25)) == 0.0
    between = np.round(read_thermometer(0.0)[:400] - 273.2, 1)
    assert estimate_toggling_step(between) == pytest.approx(0.1)


def test_rounding_adds_half_a_step_to_what_follows_the_temperature() -> None:
    device = Device(frequency_per_kelvin=8.5e-5, decay_time_per_kelvin=-3e-3)
    log = replace(made_up_log(ROWS), temperature=read_thermometer(0.1))
    test = observe_test(Test("warm", "thermal", "fit", log), device)
    noise = estimate_campaign_noise(device, [test], [{name: np.zeros(ROWS) for name in CHANNELS}])
    for channel in CHANNELS:
        rounding = noise.get_model(channel, test).correlated
        if channel in ("frequency_offset", "amplitude_force"):
            assert [r.level for r in rounding] == pytest.approx([0.05 * noise.per_kelvin[channel]])
        else:
            assert not rounding


def test_noise_shakes_readings_from_step_to_step() -> None:
    """A reading between two steps whose noise is half a step is right in the mean: no error lasts
    that is as large as without noise."""
    step, shares = 0.01, (np.arange(100_000) + 0.5) / 100_000
    shakes = step / 2 * norm.ppf(shares)
    means = [np.mean(np.round((a + shakes) / step) * step - a) for a in np.linspace(0, step, 9)]
    device = Device(frequency_per_kelvin=8.5e-5, decay_time_per_kelvin=-3e-3)
    shaken = step / 2 * np.random.default_rng(2).normal(size=ROWS)
    still = 298.15 + np.round(shaken / step) * step
    log = replace(made_up_log(ROWS), temperature=still)
    test = observe_test(Test("still", "static", "fit", log), device)
    noise = estimate_campaign_noise(device, [test], [{name: np.zeros(ROWS) for name in CHANNELS}])
    level = noise.get_model("amplitude_force", test).offset / noise.per_kelvin["amplitude_force"]
    assert max(np.abs(means)) < level < 0.05 * step


def test_noise_of_the_readings_is_told_from_a_ramp() -> None:
    """It keeps three quarters of its variance; of the ramp's corners next to nothing stays."""
    white = NOISE * np.random.default_rng(3).normal(size=ROWS)
    noisy, smooth = (estimate_thermometer_noise(TRUE + noise) for noise in (white, 0.0))
    assert noisy @ white / (white @ white) == pytest.approx(1 - 177 / 693, rel=0.05)
    assert np.std(smooth) < 0.1 * NOISE


def test_a_lag_of_the_readings_is_undone() -> None:
    """A ramp in rows of 1 s, as an exact first-order lag shows it. Where the ramp bends
    the slope is a mean over 20 s; elsewhere the temperature is exact."""
    time, lag = np.arange(1.0, ROWS + 1), 60.0

    def rise(begin: float, lag: float) -> Array:
        """(n,) readings of a rise by 1 K/s from some time on."""
        since = np.clip(time - begin, 0, None)
        return np.asarray(since - lag * (1 - np.exp(-since / lag)) if lag else since)

    true = 298.15 + 0.02 * (rise(500, 0) - rise(1500, 0))
    readings = 298.15 + 0.02 * (rise(500, lag) - rise(1500, lag))
    error = (correct_temperatures(Device(thermometer_lag=lag), readings, 1.0) - true)[:-20]
    is_bend = (np.abs(time - 500) < 15) | (np.abs(time - 1500) < 15)
    assert np.abs(readings - true).max() == pytest.approx(0.02 * lag, rel=0.01)
    assert np.abs(error[~is_bend[:-20]]).max() < 0.01
    assert abs(error.mean()) < 1e-4
