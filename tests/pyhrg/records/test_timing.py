"""Rows that came twice, time that runs back, gaps."""

from pathlib import Path

import numpy as np
import pytest

from pyhrg.records import COLUMNS, LogError, read_log
from pyhrg.records.table import Table
from pyhrg.records.timing import drop_wrong_rows
from tests.pyhrg.records.made_up import Rows, made_up_log, place, spoilt

TIME = place("time_s")


def test_repeated_rows_are_dropped_and_said(tmp_path: Path) -> None:
    def twice(rows: Rows) -> None:
        rows[6:6] = [list(row) for row in rows[3:6]]

    log = read_log(spoilt(tmp_path, twice))
    assert log.exclusions == ("rows 7-9: an earlier row again, left out",)
    assert np.array_equal(log.time, np.arange(1.0, 13.0))
    assert log.stretches("gyro_angle") == [slice(0, 12)]


def test_repeated_rows_with_the_same_nan_are_the_same(tmp_path: Path) -> None:
    def twice(rows: Rows) -> None:
        rows[4][place("amplitude")] = "nan"
        rows.insert(5, list(rows[4]))

    log = read_log(spoilt(tmp_path, twice))
    assert log.exclusions[0] == "row 6: an earlier row again, left out"


def test_one_time_with_two_values_is_an_error(tmp_path: Path) -> None:
    def twice(rows: Rows) -> None:
        rows.insert(5, list(rows[4]))
        rows[5][place("wave_angle_deg")] = "1.5"

    message = "row 6, wave_angle_deg: differs from row 5 at the same time"
    with pytest.raises(LogError, match=message):
        read_log(spoilt(tmp_path, twice))


def test_reversed_time_is_an_error(tmp_path: Path) -> None:
    message = r"log.csv: row 7, time_s: 5 after 6; expected time to increase"
    with pytest.raises(LogError, match=message):
        read_log(spoilt(tmp_path, lambda rows: rows.insert(5, rows.pop(6))))


def test_a_few_rows_out_of_order_are_left_out() -> None:
    """Rows 100 and 101 came the other way round, and rows 300 to 303 with one between: which of
    them is wrong is not known. A hundred are another recorder's log."""
    log = made_up_log(2000)
    columns = {c.field: getattr(log, c.field) for c in COLUMNS}
    order = np.arange(2000)
    order[[100, 101]] = order[[101, 100]]
    order[[300, 303]] = order[[303, 300]]
    table = Table("log", np.arange(2, 2002), {f: v[order] for f, v in columns.items()})
    kept = drop_wrong_rows(table)
    assert kept.notes == ("rows 102-103, 302-305: out of order, left out",)
    assert np.array_equal(kept.columns["time"], np.delete(log.time, [100, 101, *range(300, 304)]))
    order[500:600] = order[500:600][::-1]
    with pytest.raises(LogError, match="expected time to increase"):
        drop_wrong_rows(Table("log", table.rows, {f: v[order] for f, v in columns.items()}))


def test_two_rows_of_one_time_are_left_out() -> None:
    log = made_up_log(2000)
    columns = {c.field: getattr(log, c.field).copy() for c in COLUMNS}
    columns["time"][700] = columns["time"][699]
    kept = drop_wrong_rows(Table("log", np.arange(2, 2002), columns))
    assert kept.notes == ("rows 701-702: two rows of one time, left out",)
    assert len(kept.rows) == 1998


def test_row_without_time_is_left_out(tmp_path: Path) -> None:
    log = read_log(spoilt(tmp_path, lambda rows: rows[4].__setitem__(TIME, "")))
    assert log.exclusions[0] == "row 5: no time_s, left out"
    assert len(log.time) == 11


def test_log_without_times_is_an_error(tmp_path: Path) -> None:
    with pytest.raises(LogError, match="0 rows with a time"):
        read_log(spoilt(tmp_path, lambda rows: [row.__setitem__(TIME, "nan") for row in rows[1:]]))


def test_gaps_are_said_and_split(tmp_path: Path) -> None:
    def lose(rows: Rows) -> None:
        del rows[9]
        del rows[3:6]

    log = read_log(spoilt(tmp_path, lose), interval_s=1.0)
    assert log.exclusions == ("rows 4, 7: a gap before each, 4 rows missing in all",)
    assert log.stretches("gyro_angle") == [slice(0, 2), slice(2, 5), slice(5, 8)]


def test_row_too_soon_is_said_and_splits(tmp_path: Path) -> None:
    log = read_log(spoilt(tmp_path, lambda rows: rows[5].__setitem__(TIME, "4.2")))
    assert "row 6: less than half an interval after the row before" in log.exclusions
    assert log.stretches("time") == [slice(0, 4), slice(4, 5), slice(5, 12)]


def test_interval_is_found_or_held_to(tmp_path: Path) -> None:
    path = spoilt(tmp_path, lambda rows: None)
    assert read_log(path).interval == 1.0
    assert read_log(path, interval_s=1.001).interval == 1.001
    with pytest.raises(LogError, match=r"time_s steps by 1; expected 0\.1"):
        read_log(path, interval_s=0.1)


def test_jitter_is_no_gap(tmp_path: Path) -> None:
    late = np.random.default_rng(2).uniform(0, 0.3, 600)

    def jitter(rows: Rows) -> None:
        for row, by in zip(rows[1:], late, strict=True):
            row[TIME] = f"{float(row[TIME]) + by:.3f}"

    log = read_log(spoilt(tmp_path, jitter, made_up_log(600)), interval_s=1.0)
    assert log.exclusions == ()
    assert log.stretches("gyro_angle") == [slice(0, 600)]


@pytest.mark.parametrize("step", [1e-12, 1e-7, 1e7])
def test_no_log_has_such_an_interval(step: float, tmp_path: Path) -> None:
    def stretch(rows: Rows) -> None:
        for i, row in enumerate(rows[1:], 1):
            row[0] = repr(i * step)

    with pytest.raises(LogError, match=r"steps by .*; expected 1e-06 to 1e\+06"):
        read_log(spoilt(tmp_path, stretch))


def test_a_log_of_gaps_alone_is_refused(tmp_path: Path) -> None:
    def move_last(rows: Rows) -> None:
        rows[-1][0] = "1e9"

    with pytest.raises(LogError, match=r"12 rows span 1e\+09 times 1 s; expected at most 1e\+06"):
        read_log(spoilt(tmp_path, move_last))
