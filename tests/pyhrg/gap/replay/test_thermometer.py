"""The step of a coarse thermometer is seen, noise and rounding are none; what it hides is noise."""

from dataclasses import replace

import numpy as np
import pytest
from numpy.typing import NDArray

from pyhrg.device.device import Device
from pyhrg.gap.replay.observations import CHANNELS, observed
from pyhrg.gap.replay.thermometer import reading_steps, toggling
from pyhrg.gap.whitening.channel_noise import believed_noise
from pyhrg.records.campaign import Test
from tests.pyhrg.records.made_up import made_up_log

Array = NDArray[np.float64]
ROWS = 2000
TRUE = 298.15 + np.interp(np.arange(ROWS), [500, 1500], [0.0, 20.0])
NOISE = 5e-3


def read(step: float, seed: int = 1) -> Array:
    noisy = TRUE + NOISE * np.random.default_rng(seed).normal(size=ROWS) - 273.15
    return np.asarray((np.round(noisy / step) * step if step else noisy) + 273.15)


@pytest.mark.parametrize("step", [0.05, 0.1, 1.0])
def test_a_coarse_one_is_seen(step: float) -> None:
    logs = {"coarse": read(step), "still": np.full(ROWS, 298.15), "fine": read(0.0)}
    expected = {"coarse": step, "still": step, "fine": 0.0}
    assert reading_steps(logs) == pytest.approx(expected)


def test_one_whose_step_is_rounded_is_seen() -> None:
    printed = np.round(read(0.0625) - 273.15, 2)
    assert reading_steps({"printed": printed})["printed"] == pytest.approx(0.0625, rel=0.1)


SET = np.where(np.arange(ROWS) < 500, 298.15, 318.15)


@pytest.mark.parametrize(
    "log", [read(0.0), read(1e-3), TRUE[:9], np.full(9, np.nan), SET], ids=range(5)
)
def test_a_fine_one_is_not(log: Array) -> None:
    assert reading_steps({"fine": log}) == {"fine": 0.0}
    assert toggling(log) == 0.0


def test_a_set_point_that_changes_once_is_no_noise() -> None:
    assert toggling(TRUE) == 0.0
    assert toggling(np.where(np.arange(ROWS) < 500, 298.15, 298.25)) == 0.0
    between = np.round(read(0.0)[:400] - 273.2, 1)
    assert toggling(between) == pytest.approx(0.1)


def test_what_follows_the_temperature_is_known_to_half_a_step() -> None:
    device = Device(frequency_per_kelvin=8.5e-5, decay_time_per_kelvin=-3e-3)
    log = replace(made_up_log(ROWS), temperature=read(0.1))
    test = observed(Test("warm", "thermal", "fit", log), device)
    noise = believed_noise(device, [test], [{name: np.zeros(ROWS) for name in CHANNELS}])
    for channel in CHANNELS:
        lasting = noise.of(channel, test).correlated
        if channel in ("frequency_offset", "amplitude_force"):
            assert lasting is not None
            assert lasting.level == pytest.approx(0.05 * noise.per_kelvin[channel])
        else:
            assert lasting is None
