"""Noise of channels as planted: by length of rows, with outliers, without any noise at all."""

from collections.abc import Mapping
from dataclasses import replace

import numpy as np
import pytest
from numpy.typing import NDArray

from pyhrg.common.units import ARCSEC
from pyhrg.device.device import Device
from pyhrg.gap.replay.observations import CHANNELS, Observed, observed
from pyhrg.gap.whitening.channel_noise import RESOLVED, angle_noise, believed_noise
from pyhrg.records.campaign import Test
from tests.pyhrg.records.made_up import made_up_log

N = 2000
DEVICE = Device(frequency_per_kelvin=8.5e-5, pickoff_noise=0.04 * ARCSEC)


def watched(kelvin: float = 0.0) -> list[Observed]:
    """Two tests, rows of 1 s and of 0.5 s."""
    log = made_up_log(N)
    generator = np.random.default_rng(2)
    read = 298.15 + kelvin * generator.normal(size=N)
    fine = replace(log, interval=0.5, time=log.time / 2, temperature=read)
    logs = (replace(log, temperature=read), fine)
    return [observed(Test(str(i), "static", "fit", x), DEVICE) for i, x in enumerate(logs)]


def residuals(*scales: float) -> list[Mapping[str, NDArray[np.float64]]]:
    generator = np.random.default_rng(3)
    return [{name: s * generator.normal(size=N) for name in CHANNELS} for s in scales]


def test_each_length_of_row_has_its_own() -> None:
    found = believed_noise(DEVICE, watched(), residuals(1e-6, 3e-6))
    for name in RESOLVED:
        assert found.white[name][1.0] == pytest.approx(1e-6, rel=0.06), name
        assert found.white[name][0.5] == pytest.approx(3e-6, rel=0.06), name
    tests = watched()
    assert found.of("amplitude", tests[1]).white == found.white["amplitude"][0.5]
    # a length that was never seen has the nearest one's
    other = replace(tests[0], inputs=replace(tests[0].inputs, log=made_up_log(10)))
    assert found.of("amplitude", other).white == found.white["amplitude"][1.0]


def test_slow_signals_and_outliers_are_no_noise() -> None:
    given = [dict(r) for r in residuals(1e-6, 1e-6)]
    given[0]["amplitude"] = given[0]["amplitude"] + 1e-4 * np.sin(np.arange(N) / 200)
    given[0]["amplitude"][::200] += 1e-3
    found = believed_noise(DEVICE, watched(), given)
    assert found.white["amplitude"][1.0] == pytest.approx(1e-6, rel=0.1)


def test_records_without_noise_are_compared_no_closer_than_replays() -> None:
    found = believed_noise(DEVICE, watched(), residuals(0.0, 0.0))
    assert all(set(found.white[name].values()) == {least} for name, least in RESOLVED.items())
    assert set(found.temperature.values()) == {0.0}


def test_a_channel_that_is_not_there() -> None:
    tests = watched()
    none = np.zeros(N, dtype=bool)
    blind = [replace(t, rows={**t.rows, "amplitude": none}) for t in tests]
    found = believed_noise(DEVICE, blind, residuals(1e-6, 1e-6))
    assert found.white["amplitude"][1.0] == RESOLVED["amplitude"]


def test_the_thermometer_s_noise_is_known() -> None:
    found = believed_noise(DEVICE, watched(5e-3), residuals(1e-4, 1e-4))
    assert found.temperature["0"] == pytest.approx(5e-3, rel=0.06)


def test_a_believed_quantum_is_noise() -> None:
    counted = replace(DEVICE, pickoff_noise=0.0, angle_quantum=0.6)
    assert angle_noise(counted).white == pytest.approx(0.6 / np.sqrt(12))


def test_an_angle_of_which_no_noise_is_stated_has_some() -> None:
    """So that a gap can be weighed against it."""
    assert angle_noise(Device()).white > 0
