"""A fast log joined to longer rows is what the same gyro would have logged in them."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from pyhrg.bench.bench import Bench, PowerOn
from pyhrg.bench.programme import Programme
from pyhrg.common.units import DEG, HZ
from pyhrg.device.device import Device
from pyhrg.fmu import GyroFmu
from pyhrg.records import COLUMNS, Log, LogError
from pyhrg.records.campaign_import import import_campaign
from pyhrg.records.campaign_import.joining import join_rows
from tests.pyhrg.records.campaign_import.labs import HEAD, entry_of
from tests.pyhrg.records.made_up import made_up_log

GYRO = Device(
    damping_anisotropy=1e-4,
    damping_axis=20 * DEG,
    frequency_split=5e-3 * HZ,
    stiffness_axis=65 * DEG,
    frequency_per_kelvin=8.5e-5,
)

CLOSE = {"amplitude": 2e-7, "frequency_offset": 1e-4}
"""SI, below their noise: the bench takes an amplitude a control period before a row's end from two
rows' ends, and steps that see less of a transient."""
FIRST = 1
"""Row from which loops have settled after power-on."""


def _course(programme: Programme) -> Programme:
    programme.rest(10).heat(GYRO.reference_temperature + 2, 20).attitude(0.5).rest(10)
    programme.command(virtual_rotation=1 * DEG).rest(10)
    return programme.command(virtual_rotation=0.0, drive_on=0.0).rest(30)


def recorded(fmu: GyroFmu, interval: float) -> Log:
    bench = Bench(fmu, GYRO)
    return bench.log(PowerOn("one", "rate", _course(bench.programme(interval)))).log


def test_joined_rows_are_those_of_a_slower_recorder(fmu: GyroFmu) -> None:
    slow, found = recorded(fmu, 1.0), join_rows(recorded(fmu, 0.05), 1.0)
    assert found.interval == 1.0
    assert found.exclusions == ()
    for column in COLUMNS:
        fast, own = getattr(found, column.field), getattr(slow, column.field)
        close = CLOSE.get(column.field, 1e-9)
        np.testing.assert_allclose(fast[FIRST:], own[FIRST:], 1e-9, close, err_msg=column.field)


def fast_log(rows: int = 100) -> Log:
    log = made_up_log(rows)
    return replace(log, interval=0.1, time=np.round(log.time / 10, 6))


def without(log: Log, *rows: int) -> Log:
    columns = {c.field: np.delete(getattr(log, c.field), rows) for c in COLUMNS}
    return replace(log, **columns)


def test_rows_that_are_not_whole_are_left_out() -> None:
    found = join_rows(without(fast_log(95), 34, 35), 1.0)
    np.testing.assert_allclose(found.time, [1, 2, 3, 5, 6, 7, 8, 9])
    assert found.exclusions == ("13 rows that are not part of a whole 1 s: left out",)


def test_a_value_that_is_missing_stays_missing() -> None:
    log = fast_log()
    for field in ("gyro_angle", "quadrature_force"):
        values = getattr(log, field).copy()
        values[[12, 29]] = np.nan
        log = replace(log, **{field: values})
    found = join_rows(log, 1.0)
    assert np.flatnonzero(np.isnan(found.quadrature_force)).tolist() == [1, 2]
    assert np.flatnonzero(np.isnan(found.gyro_angle)).tolist() == [2]


def test_what_can_not_be_joined_is_refused() -> None:
    log = fast_log()
    with pytest.raises(LogError, match=r"rows of 0\.1 s; expected rows_s, 0\.25, to be a multiple"):
        join_rows(log, 0.25)
    with pytest.raises(LogError, match="rows_s, 0\\.01, to be a multiple"):
        join_rows(log, 0.01)
    with pytest.raises(LogError, match="0 times 20 s without a missing row; expected 2"):
        join_rows(log, 20.0)
    changed = np.where(np.arange(100) < 35, 1.0, 0.0)
    message = r"drive_on changes between time_s 3\.1 and 4; expected it to be the same in a row"
    for drive_on in (changed, np.where(np.arange(100) == 31, np.nan, changed)):
        with pytest.raises(LogError, match=message):
            join_rows(replace(log, drive_on=drive_on), 1.0)


@pytest.mark.parametrize("clock", [1.0, 1 + 2e-5, 1 - 2e-5])
def test_a_clock_that_is_off_loses_no_row(clock: float) -> None:
    log = fast_log(20000)
    late = np.where(np.arange(20000) % 1000 == 500, 0.005, 0.0)
    found = join_rows(replace(log, time=clock * log.time + late), 1.0)
    assert len(found.time) == 2000
    assert found.exclusions == ()


def test_a_rate_that_is_rounded_is_a_whole_one() -> None:
    log = fast_log(600)
    found = join_rows(replace(log, interval=0.016667, time=np.round(log.time / 6, 6)), 1.0)
    np.testing.assert_array_equal(found.time, np.arange(1, 11))


@pytest.mark.parametrize(
    ("head", "entry", "rows"), [("rows_s = 1", "", 6), ("rows_s = 1", "rows_s = 2", 3)]
)
def test_a_mapping_asks_for_rows(tmp_path: Path, head: str, entry: str, rows: int) -> None:
    lines = [f"{0.5 * (i + 1)},{0.1 * (i + 1)},{i}" for i in range(12)]
    (tmp_path / "one.csv").write_text("\n".join(lines))
    columns = """
[tests.columns]
time = { column = 1, unit = "s" }
gyro_angle = { column = 2, unit = "deg" }
quadrature_force = { column = 3, unit = "1/s" }
axis_up = 1
"""
    text = f"{head}\n{HEAD}[layout]\nheader = false\n{entry_of('one', 'static', 'fit', 'one.csv')}"
    (tmp_path / "mapping.toml").write_text(f"{text}{entry}\n{columns}")
    (test,) = import_campaign(tmp_path / "mapping.toml").tests
    count = 12 // rows
    assert test.logged.interval == 0.5 * count
    np.testing.assert_allclose(test.logged.gyro_angle / DEG, 0.1 * count * np.arange(1, rows + 1))
    means = np.arange(12.0).reshape(rows, count).mean(axis=1)
    np.testing.assert_allclose(test.logged.quadrature_force, means)
