"""A laboratory's instruments, and the replay that undoes what they read wrongly."""

from dataclasses import replace

import numpy as np
import pytest

from pyhrg.challenge.campaigns.laboratory import LEVELS, Laboratory, draw_laboratory
from pyhrg.common.units import HZ
from pyhrg.device.device import Device
from pyhrg.gap.effects.catalogue import KNOWN
from pyhrg.gap.replay.inputs.inputs import prepare_inputs
from pyhrg.gap.replay.recorder import read_change
from tests.pyhrg.records.made_up import made_up_log

ROWS = 1500
RAMP = 298.15 + np.interp(np.arange(1, ROWS + 1), [300, 900], [0.0, 12.0])
NONE = dict.fromkeys([field for known in KNOWN for field in known.fields], 0.0)


def test_a_thermometer_lags_and_the_replay_undoes_it() -> None:
    log = replace(made_up_log(ROWS), temperature=RAMP)
    lab = Laboratory(1.0, {**NONE, "thermometer_lag": 40.0, "thermometer_offset": 0.3})
    read = lab.read(log, 298.15)
    assert read.temperature[800] - RAMP[800] == pytest.approx(0.3 - 40.0 * 0.02, rel=1e-3)
    device = Device(thermometer_lag=40.0, thermometer_offset=0.3)
    case = prepare_inputs(read, device).find_case_temperatures(device)[1:]
    away = np.abs(case - RAMP)[20:-20]
    assert away.max() < 0.1
    assert abs((case - RAMP)[20:-20].mean()) < 1e-3


@pytest.mark.parametrize("level", ["good-lab", "rough-lab"])
def test_errors_are_within_their_tolerances_and_no_lag_is_negative(level: str) -> None:
    told, size = Device(), LEVELS[level]
    for seed in range(20):
        errors = draw_laboratory(told, size, np.random.default_rng(seed)).errors
        for known in KNOWN:
            assert abs(errors[known.fields[0]]) <= size * known.tolerance_of(told)
        assert errors["thermometer_lag"] >= 0


def test_a_resonator_is_detuned_in_proportion_to_its_own_frequency() -> None:
    """As the gyro of a laboratory that was told another frequency, heated by 12 K."""
    told, error, by_kelvin = Device(), 3 * HZ, 8e-5
    lab = Laboratory(1.0, {**NONE, "frequency_error": error})
    warm = by_kelvin * (RAMP - RAMP[0])
    log = replace(made_up_log(ROWS), frequency_offset=lab.true_device(told).frequency * warm)
    read = lab.read(log, 298.15).frequency_offset
    rows = {"frequency_offset": told.frequency * warm}
    off, half = (replace(told, frequency_error=share * error) for share in (1.0, 0.5))
    for start in (told, half):
        begun = rows["frequency_offset"] + read_change(rows, told, start, log)["frequency_offset"]
        change = read_change({"frequency_offset": begun}, start, off, log)["frequency_offset"]
        assert np.abs(begun + change - read).max() < 1e-7 * HZ
