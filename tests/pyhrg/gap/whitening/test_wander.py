"""The wander of a channel in tests at a steady temperature, against draws."""

from dataclasses import replace

import numpy as np
import pytest
from numpy.typing import NDArray

from pyhrg.device.device import Device
from pyhrg.gap.replay.observations import ObservedTest, observe_test
from pyhrg.gap.whitening.channel_noise import estimate_campaign_noise
from pyhrg.gap.whitening.wander import estimate_wander
from pyhrg.gap.whitening.whitening import draw_noise, whiten
from pyhrg.records.campaign import Test
from tests.pyhrg.records.made_up import made_up_log

N = 4000
DEVICE = Device(frequency_per_kelvin=8.5e-5, thermal_lag=600.0)
WHITE = 6e-5
CHANNEL = "frequency_offset"


def observe_tests(count: int, kelvin: float = 0.01) -> list[ObservedTest]:
    """Tests at a steady temperature, with noise of the thermometer, K."""
    generator = np.random.default_rng(7)
    logs = [
        replace(made_up_log(N), temperature=298.15 + kelvin * generator.normal(size=N))
        for _ in range(count)
    ]
    return [observe_test(Test(str(i), "static", "fit", x), DEVICE) for i, x in enumerate(logs)]


def draw(walk: float, offset: float, seed: int) -> NDArray[np.float64]:
    """White noise, a random walk, and a constant error of the temperature behind the lag."""
    generator = np.random.default_rng(seed)
    warming = -np.expm1(-np.arange(1, N + 1) / DEVICE.thermal_lag)
    steps = walk * generator.normal(size=N)
    return np.cumsum(steps) + WHITE * generator.normal(size=N) + offset * warming


def wander_of(series: list[NDArray[np.float64]]) -> float:
    residuals = [{CHANNEL: values} for values in series]
    tests = observe_tests(len(series))
    assert all(test.inputs.is_steady for test in tests)
    return estimate_wander(CHANNEL, tests, residuals, {1.0: WHITE}, DEVICE.thermal_lag)


@pytest.mark.parametrize("walk", [3e-6, 3e-5])
def test_a_walk_is_found_beside_a_constant_error(walk: float) -> None:
    found = [wander_of([draw(walk, 2e-3, 10 * s + i) for i in range(5)]) for s in range(10)]
    assert np.mean(found) == pytest.approx(walk, rel=0.4)
    assert min(found) > 0.6 * walk


def test_white_noise_and_a_constant_error_are_no_wander() -> None:
    found = [wander_of([draw(0.0, 2e-3, 10 * s + i) for i in range(5)]) for s in range(10)]
    assert max(found) < 1.5e-6


def test_a_signal_in_one_of_several_tests_is_no_wander() -> None:
    series = [draw(0.0, 0.0, i) for i in range(5)]
    series[2] = series[2] + 1e-2 * np.sin(np.arange(N) / 200)
    assert wander_of(series) < 1.5e-6


def test_a_moving_temperature_is_not_searched() -> None:
    log = replace(made_up_log(N), temperature=np.linspace(290.0, 300.0, N))
    test = observe_test(Test("ramp", "static", "fit", log), DEVICE)
    assert not test.inputs.is_steady
    residuals = [{CHANNEL: draw(0.0, 0.0, 1)}]
    assert estimate_wander(CHANNEL, [test], residuals, {1.0: WHITE}, 600.0) == np.inf


def test_wander_is_at_most_what_the_thermometer_hides() -> None:
    tests = observe_tests(3)
    loud = [{name: draw(1e-2, 0.0, i) for name in tests[0].rows} for i in range(3)]
    noise = estimate_campaign_noise(DEVICE, tests, loud).get_model(CHANNEL, tests[0])
    hidden = DEVICE.frequency * DEVICE.frequency_per_kelvin * 0.01
    assert noise.lagged == pytest.approx(hidden, rel=0.1)
    assert noise.offset == pytest.approx(hidden / np.sqrt(N), rel=0.1)


def test_a_steady_test_is_white_in_its_own_noise() -> None:
    tests = observe_tests(3)
    quiet = [{name: draw(0.0, 0.0, i) for name in tests[0].rows} for i in range(3)]
    model = estimate_campaign_noise(DEVICE, tests, quiet).get_model(CHANNEL, tests[0])
    drawn = [draw_noise(model, N, 1.0, np.random.default_rng(s)) for s in range(40)]
    white = whiten(np.column_stack(drawn), np.ones(N), model).series
    assert np.mean(white**2) == pytest.approx(1.0, abs=0.02)
