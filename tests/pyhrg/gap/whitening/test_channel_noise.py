"""Estimated noise of the channels against planted noise."""

from collections.abc import Mapping
from dataclasses import replace

import numpy as np
import pytest
from numpy.typing import NDArray

from pyhrg.bench.readings.first_order_lag import follow_with_lag
from pyhrg.common.units import ARCSEC
from pyhrg.device.device import Device
from pyhrg.gap.replay.inputs.thermometer import correct_temperatures
from pyhrg.gap.replay.observations import CHANNELS, ObservedTest, observe_test
from pyhrg.gap.whitening.channel_noise import (
    REPLAY_RESOLUTION,
    build_angle_noise,
    estimate_campaign_noise,
)
from pyhrg.records.campaign import Test
from tests.pyhrg.records.made_up import made_up_log

N = 2000
DEVICE = Device(frequency_per_kelvin=8.5e-5, angle_white_noise=0.04 * ARCSEC)


def observe_two_tests(kelvin: float = 0.0) -> list[ObservedTest]:
    """Two tests, with rows of 1 s and of 0.5 s, and noise of the thermometer, K."""
    log = made_up_log(N)
    generator = np.random.default_rng(2)
    temperature = 298.15 + kelvin * generator.normal(size=N)
    fine = replace(log, interval=0.5, time=log.time / 2, temperature=temperature)
    logs = (replace(log, temperature=temperature), fine)
    return [observe_test(Test(str(i), "static", "fit", x), DEVICE) for i, x in enumerate(logs)]


def draw_residuals(*scales: float) -> list[Mapping[str, NDArray[np.float64]]]:
    generator = np.random.default_rng(3)
    return [{name: s * generator.normal(size=N) for name in CHANNELS} for s in scales]


def test_each_row_length_has_its_own_noise() -> None:
    noise = estimate_campaign_noise(DEVICE, observe_two_tests(), draw_residuals(1e-6, 3e-6))
    for name in REPLAY_RESOLUTION:
        assert noise.white_noise[name][1.0] == pytest.approx(1e-6, rel=0.06), name
        assert noise.white_noise[name][0.5] == pytest.approx(3e-6, rel=0.06), name
    tests = observe_two_tests()
    assert (
        noise.get_model("amplitude", tests[1]).angle_white_noise
        == noise.white_noise["amplitude"][0.5]
    )
    # an unknown row length has the noise of the nearest one
    other = replace(tests[0], inputs=replace(tests[0].inputs, log=made_up_log(10)))
    assert (
        noise.get_model("amplitude", other).angle_white_noise == noise.white_noise["amplitude"][1.0]
    )


def test_slow_signals_and_outliers_are_not_counted() -> None:
    given = [dict(r) for r in draw_residuals(1e-6, 1e-6)]
    given[0]["amplitude"] = given[0]["amplitude"] + 1e-4 * np.sin(np.arange(N) / 200)
    given[0]["amplitude"][::200] += 1e-3
    noise = estimate_campaign_noise(DEVICE, observe_two_tests(), given)
    assert noise.white_noise["amplitude"][1.0] == pytest.approx(1e-6, rel=0.1)


def test_noise_is_at_least_the_resolution_of_replays() -> None:
    noise = estimate_campaign_noise(DEVICE, observe_two_tests(), draw_residuals(0.0, 0.0))
    assert all(
        set(noise.white_noise[name].values()) == {least}
        for name, least in REPLAY_RESOLUTION.items()
    )
    assert set(noise.temperature.values()) == {0.0}


def test_a_missing_channel() -> None:
    tests = observe_two_tests()
    none = np.zeros(N, dtype=bool)
    blind = [replace(t, rows={**t.rows, "amplitude": none}) for t in tests]
    noise = estimate_campaign_noise(DEVICE, blind, draw_residuals(1e-6, 1e-6))
    assert noise.white_noise["amplitude"][1.0] == REPLAY_RESOLUTION["amplitude"]


def test_the_noise_of_the_thermometer_is_estimated() -> None:
    noise = estimate_campaign_noise(DEVICE, observe_two_tests(5e-3), draw_residuals(1e-4, 1e-4))
    assert noise.temperature["0"] == pytest.approx(5e-3, rel=0.06)


def test_a_stated_quantization_is_noise() -> None:
    counted = replace(DEVICE, angle_white_noise=0.0, quantization_step=0.6)
    assert build_angle_noise(counted).angle_white_noise == pytest.approx(0.6 / np.sqrt(12))


def test_an_angle_without_stated_noise_has_some() -> None:
    """A gap is compared with it, so it must not be zero."""
    assert build_angle_noise(Device()).angle_white_noise > 0


def test_a_lag_that_is_undone_adds_noise_that_lasts_as_long_as_its_slope() -> None:
    """Against draws: white noise of a thermometer's readings, put right and followed by the
    resonator. Three standard errors of a variance with a thousand correlation times are 13 %."""
    device = replace(DEVICE, thermometer_lag=20.0)
    kelvin, rows, lag = 5e-3, 20_000, device.thermal_lag
    readings = kelvin * np.random.default_rng(6).standard_normal(rows)
    undone = correct_temperatures(device, device.reference_temperature + readings, 1.0)
    changes = undone - device.reference_temperature - readings
    added = follow_with_lag(changes, 1.0, lag, start=0.0)
    log = made_up_log(rows)
    warm = replace(log, temperature=298.15 + np.linspace(0, 10, rows) + readings)
    test = observe_test(Test("ramp", "thermal", "fit", warm), DEVICE)
    silent = [{name: np.zeros(rows) for name in CHANNELS}]
    noise = estimate_campaign_noise(DEVICE, [test], silent, device.thermometer_lag)
    (lasting,) = noise.get_model("frequency_offset", test).correlated
    expected = np.std(added) * noise.per_kelvin["frequency_offset"]
    assert lasting.level == pytest.approx(expected, rel=0.13)
