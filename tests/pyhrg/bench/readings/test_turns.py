"""Stretches of steady turning."""

from dataclasses import replace

import numpy as np
import pytest

from pyhrg.bench.bench import Bench, PowerOn
from pyhrg.bench.outcome import BenchError
from pyhrg.bench.programme import Programme
from pyhrg.bench.readings.turns import find_turns, list_short_turns
from pyhrg.common.site import EARTH_RATE, Site
from pyhrg.common.units import DEG
from pyhrg.device.ready_devices import Device
from pyhrg.fmu import GyroFmu
from pyhrg.records import Log

SITE = Site()


def course(bench: Bench) -> Programme:
    return bench.programme(0.1).rest(5.0).spin(20 * DEG, 50.0).spin(-50 * DEG, 15.0).rest(3.0)


@pytest.fixture(scope="module")
def log(slow_fmu: GyroFmu) -> Log:
    bench = Bench(slow_fmu, Device(), step=0.1)
    return bench.log(PowerOn("turning", "rate", course(bench))).log


def test_each_rate_is_one_turn(log: Log) -> None:
    found = find_turns(log, SITE)
    assert [turn.table_rate / DEG for turn in found] == pytest.approx([20.0, -50.0])
    assert found[0].time[0] > 7.0
    assert found[0].periods == pytest.approx(
        0.277 * 20 / 90 * (found[0].time[-1] - found[0].time[0]), rel=1e-3
    )


def test_earth_belongs_to_the_input(log: Log) -> None:
    earth = EARTH_RATE * np.sin(SITE.latitude)
    for turn in find_turns(log, SITE):
        assert turn.input_rate - turn.table_rate == pytest.approx(earth, rel=1e-9)


def test_whole_periods_end_where_the_pattern_is_again(log: Log) -> None:
    turn = find_turns(log, SITE)[1]
    time, angle, _ = turn.whole_periods(each=1)
    assert len(time) == int(turn.periods) + 1
    assert np.diff(angle) == pytest.approx(-90 * DEG / 0.277, rel=1e-5)


def test_a_gap_parts_a_turn(log: Log, monkeypatch: pytest.MonkeyPatch) -> None:
    """Rows 270 to 273 are lost: no turn spans them, and each part settles anew."""
    output = log.gyro_angle.copy()
    output[270:274] = np.nan
    parts = [slice(0, 270), slice(274, len(log.time))]
    monkeypatch.setattr(Log, "stretches", lambda self, *fields: parts)
    found = find_turns(replace(log, gyro_angle=output), SITE)
    assert all(np.isfinite(turn.excess).all() for turn in found)
    assert len(found) == 3
    assert found[0].time[-1] == pytest.approx(27.0)
    assert found[1].time[0] == pytest.approx(29.5)


def test_a_short_turn_is_excluded_with_a_reason(log: Log) -> None:
    """Drive off from 20 s on: the first turn has 13 s left, 72 deg of pattern."""
    off = np.where((log.time > 20.0) & (log.time < 55.0), 0.0, 1.0)
    cut = replace(log, drive_on=off)
    assert len(find_turns(cut, SITE)) == 1
    (text,) = list_short_turns(cut, SITE)
    assert text.startswith("turning: 7.")
    assert "at 20 deg/s left out" in text
    assert not list_short_turns(log, SITE)


def test_too_little_turning_is_refused(log: Log) -> None:
    still = replace(log, table_angle=np.zeros_like(log.table_angle))
    with pytest.raises(BenchError, match=r"turning: no stretch .* 90 deg.* the longest .* 0 deg"):
        find_turns(still, SITE)


def test_an_unsteady_table_is_refused(log: Log) -> None:
    swinging = replace(log, table_angle=np.sin(3 * log.time))
    with pytest.raises(BenchError, match="no stretch at a steady rate"):
        find_turns(swinging, SITE)
