"""Files that are no logs: the message names file, row, column, what was found and expected."""

import gzip
import re
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

from pyhrg.common.errors import HrgError
from pyhrg.records import read_log, write_log
from pyhrg.records.table import describe_rows, fold_absent_columns, merge_sources
from tests.pyhrg.records.made_up import Rows, made_up_log, place, spoilt

GYRO = place("gyro_angle_deg")


def put(row: int, column: str, text: str) -> Callable[[Rows], object]:
    return lambda rows: rows[row - 1].__setitem__(place(column), text)


@pytest.mark.parametrize(
    ("spoil", "message"),
    [
        (put(5, "amplitude", "1,0"), "row 5: 18 fields; expected 17"),
        (put(5, "amplitude", "high"), "row 5, amplitude: 'high'; expected a number"),
        (put(7, "gyro_angle_deg", "inf"), "row 7, gyro_angle_deg: inf; expected -1e+12 to 1e+12"),
        (put(4, "temperature_degC", "298.15"), "temperature_degC: 298.15; expected -100 to 150"),
        (put(4, "axis_up", "9.8"), "row 4, axis_up: 9.8; expected -1 to 1"),
        (put(1, "gyro_angle_deg", "gyro_angle_rad"), "gyro_angle_rad; expected gyro_angle_deg"),
        (put(1, "wave_angle_deg", "gyro_angle_deg"), "gyro_angle_deg stands there more than once"),
        (put(1, "time_s", "clock"), "column time_s is missing; found clock, table_angle_deg"),
        (lambda rows: rows[-1].pop(), "row 13: 16 fields; expected 17"),
        (lambda rows: rows.__delitem__(slice(2, None)), "1 rows of values; expected at least 2"),
        (lambda rows: rows.__delitem__(slice(1, None)), "0 rows of values"),
        (lambda rows: rows.clear(), "column time_s is missing"),
    ],
)
def test_wrong_field_is_named(
    tmp_path: Path, spoil: Callable[[Rows], object], message: str
) -> None:
    with pytest.raises(HrgError, match=re.escape(message)) as caught:
        read_log(spoilt(tmp_path, spoil))
    assert "log.csv" in str(caught.value)


def test_unreadable_files_are_named(tmp_path: Path) -> None:
    path = tmp_path / "log.csv.gz"
    write_log(made_up_log(12), path)
    path.write_bytes(path.read_bytes()[:100])
    with pytest.raises(HrgError, match=r"log\.csv\.gz: found what is no whole gzipped data"):
        read_log(path)
    path.write_bytes(gzip.compress(b"\xff\xfe\x00"))
    with pytest.raises(HrgError, match="found what is no text"):
        read_log(path)
    with pytest.raises(HrgError, match="No such file"):
        read_log(tmp_path / "none.csv")


@pytest.mark.parametrize("text", ["", " ", "nan", "NaN"])
def test_missing_values_are_counted(tmp_path: Path, text: str) -> None:
    def spoil(rows: Rows) -> None:
        for row in (3, 6, 7, 8):
            rows[row - 1][GYRO] = text

    log = read_log(spoilt(tmp_path, spoil))
    assert log.exclusions == ("rows 3, 6-8: gyro_angle_deg missing",)
    assert list(np.flatnonzero(np.isnan(log.gyro_angle)) + 2) == [3, 6, 7, 8]
    assert log.stretches("gyro_angle") == [slice(0, 1), slice(2, 4), slice(7, 12)]
    assert log.stretches("wave_angle") == [slice(0, 12)]


def test_missing_column_is_asked_for_by_name(tmp_path: Path) -> None:
    log = read_log(spoilt(tmp_path, lambda rows: [row.pop(GYRO) for row in rows]))
    assert log.exclusions == ("no column gyro_angle_deg",)
    assert np.isnan(log.gyro_angle).all()
    log.require("wave_angle", "time")
    with pytest.raises(HrgError, match=r"log\.csv: column gyro_angle_deg is missing or has no"):
        log.require("wave_angle", "gyro_angle")
    with pytest.raises(HrgError, match="gyro_angle_deg is missing"):
        log.stretches("gyro_angle")


def test_column_without_values_is_missing_too(tmp_path: Path) -> None:
    log = read_log(spoilt(tmp_path, lambda rows: [row.__setitem__(GYRO, "") for row in rows[1:]]))
    assert log.exclusions == ("rows 2-13: gyro_angle_deg missing",)
    with pytest.raises(HrgError, match="gyro_angle_deg is missing or has no values"):
        log.require("gyro_angle")


def test_unknown_column_is_ignored_and_said(tmp_path: Path) -> None:
    log = read_log(spoilt(tmp_path, lambda rows: [row.append("7") for row in rows]))
    assert log.exclusions == ("column 7: not known, ignored",)


def test_blank_lines_and_foreign_text_do_not_shift_rows(tmp_path: Path) -> None:
    def spoil(rows: Rows) -> None:
        for row in rows:
            row.append("remark")
        rows[5][GYRO] = ""
        rows.insert(3, [])

    log = read_log(spoilt(tmp_path, spoil))
    assert log.exclusions == ("column remark: not known, ignored", "row 7: gyro_angle_deg missing")
    assert len(log.time) == 12


def test_line_ends_do_not_matter(tmp_path: Path) -> None:
    path = spoilt(tmp_path, lambda rows: None)
    plain = read_log(path)
    path.write_bytes(path.read_bytes().replace(b"\n", b"\r\n"))
    assert np.array_equal(read_log(path).gyro_angle, plain.gyro_angle)


def test_many_rows_are_only_counted() -> None:
    assert describe_rows(np.array([4])) == "row 4"
    assert describe_rows(np.array([4, 5, 9])) == "rows 4-5, 9"
    assert (
        describe_rows(np.arange(2, 42, 2))
        == "rows 2, 4, 6, 8, 10, 12, 14, 16 and more, 20 rows in all"
    )


def test_one_sentence_tells_all_absent_columns() -> None:
    notes = ("no column valid", "column x: not known, ignored", "no column amplitude")
    assert fold_absent_columns(notes) == ["no column valid, amplitude", notes[1]]


def test_a_sentence_on_several_sources_is_said_once() -> None:
    sentences = ("a.csv: no column valid", "b.csv: rows 2-3: missing", "b.csv: no column valid")
    merged = ["a.csv, b.csv: no column valid", "b.csv: rows 2-3: missing", "no test is held out"]
    assert merge_sources((*sentences, "no test is held out")) == merged
