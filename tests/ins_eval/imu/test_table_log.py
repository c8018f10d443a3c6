"""Logs as CSV and Parquet: read, refused."""

from pathlib import Path

import numpy as np
import pandas as pd
import pytest

from ins_eval.flights import sources
from pyhrg.common.errors import HrgError
from pyhrg.records.imu.log import ACCELEROMETERS, GYROS, Increments, Quantity
from tests.ins_eval.imu.logs import frame, resting, saved

RANDOM = Increments(
    1 / 300, *np.random.default_rng(1).normal(0, [[[1e-5]], [[1e-3]]], (2, 500, 3)), start=12.5
)


@pytest.mark.parametrize("name", ["log.csv", "log.csv.gz", "log.parquet"])
def test_what_was_written_reads_back_to_the_same_bits(tmp_path: Path, name: str) -> None:
    path = tmp_path / name
    sources.write_record(RANDOM, path)
    back = sources.read_record(path).increments
    np.testing.assert_array_equal(back.rotation, RANDOM.rotation)
    np.testing.assert_array_equal(back.velocity, RANDOM.velocity)
    assert back.interval == pytest.approx(RANDOM.interval, rel=1e-12)
    assert back.start == pytest.approx(12.5, abs=1e-12)
    first = path.read_bytes()
    sources.write_record(RANDOM, path)
    assert path.read_bytes() == first


def test_another_ending_is_refused_and_nothing_is_left(tmp_path: Path) -> None:
    for name in ("log.xls", "log.parquet.gz", "log"):
        with pytest.raises(HrgError, match=r"expected .csv, .csv.gz or .parquet"):
            sources.write_record(RANDOM, tmp_path / name)
    assert list(tmp_path.iterdir()) == []


def test_numbers_without_a_header_are_said_to_be_that(tmp_path: Path) -> None:
    path = tmp_path / "imu.txt"
    path.write_text("1e-7 2e-7 -3e-7 0.01 0.02 9.8 0.01\n" * 20)
    with pytest.raises(HrgError, match="row 1: found numbers, expected a header"):
        sources.read_record(path)


@pytest.mark.parametrize("gyros", GYROS, ids=lambda kind: kind.column("x"))
@pytest.mark.parametrize("forces", ACCELEROMETERS, ids=lambda kind: kind.column("x"))
def test_every_kind_of_column_gives_the_same_increments(
    tmp_path: Path, gyros: Quantity, forces: Quantity
) -> None:
    truth = resting(40.0)
    log = sources.read_record(saved(frame(truth, gyros, forces), tmp_path))
    np.testing.assert_allclose(log.increments.rotation, truth.rotation, rtol=1e-12)
    np.testing.assert_allclose(log.increments.velocity, truth.velocity, rtol=1e-12)
    assert (log.position, log.attitude) == (None, None)


def test_other_columns_are_ignored_and_order_is_free(tmp_path: Path) -> None:
    table = frame(resting()).assign(state="good")
    plain = sources.read_record(saved(table, tmp_path)).increments
    turned = sources.read_record(
        saved(table[table.columns[::-1]], tmp_path, "turned.csv")
    ).increments
    np.testing.assert_array_equal(turned.rotation, plain.rotation)


def with_cell(row: int, column: str, value: object) -> pd.DataFrame:
    table = frame(resting()).astype(object)
    table.loc[row, column] = value
    return table


GYRO_Y = "gyro_y_rad_s"
TABLE = frame(resting())


@pytest.mark.parametrize(
    ("table", "message"),
    [
        (with_cell(7, GYRO_Y, "x"), r"log\.csv: row 9, gyro_y_rad_s: found 'x', expected a number"),
        (with_cell(7, GYRO_Y, ""), "row 9, gyro_y_rad_s: found nothing, expected a number"),
        (with_cell(7, GYRO_Y, np.inf), "row 9, gyro_y_rad_s: found inf, expected a finite number"),
        (with_cell(7, GYRO_Y, "nan"), "row 9, gyro_y_rad_s: found nan, expected a finite number"),
        (
            with_cell(7, GYRO_Y, 1e300),
            r"row 9, gyro_y_rad_s: found 1e\+300, expected at most 1e\+12",
        ),
        (with_cell(7, GYRO_Y, "1,2"), r"row 9: found 8 fields, expected 7: time_s, gyro_x"),
        (with_cell(7, "time_s", 0.07), r"row 9, time_s: found 0.07 after 0.07, .* each time once"),
        (with_cell(7, "time_s", 0.01), "row 9, time_s: found 0.01 after 0.07, .* to increase"),
        (with_cell(7, "time_s", 0.0802), r"found 0.0802 after 0.07, .* even to 1%"),
        (TABLE.drop(index=range(7, 10)), "row 9, time_s: found 0.11 after 0.07, .* 3 rows missing"),
        (TABLE.assign(time_s=TABLE.time_s * 1e3), "found steps of 10 s, expected 0.0001 s to 1 s"),
        (TABLE[:5], "found 5 rows of values, expected at least 10"),
        (TABLE.drop(columns="time_s"), "found no column time_s among gyro_x_rad_s, "),
        (TABLE.drop(columns=GYRO_Y), "found no column gyro_y_rad_s, expected it among time_s"),
        (TABLE.drop(columns=TABLE.columns[4:]), "found no column velocity_x_m_s or accel"),
        (TABLE.assign(rotation_x_rad=0), "found columns rotation_x_rad and gyro_x_rad_s"),
    ],
)
def test_what_is_wrong_is_named(tmp_path: Path, table: pd.DataFrame, message: str) -> None:
    path = tmp_path / "log.csv"
    path.write_text(table.to_csv(index=False).replace('"', ""))
    with pytest.raises(HrgError, match=message):
        sources.read_record(path)


@pytest.mark.parametrize(
    ("data", "message"),
    [
        (b"", "found an empty file, expected a header"),
        (b"\xff\xfe\x00", "found what is no text"),
        (b"\x1f\x8b\x08damaged gzip", "found what is no whole gzipped data"),
        (b"PAR1damaged", "found what is no Parquet"),
        (b"time_s,time_s\n", "column time_s: found more than once|found no column"),
    ],
)
def test_a_file_that_is_none_is_refused(tmp_path: Path, data: bytes, message: str) -> None:
    path = tmp_path / "log"
    path.write_bytes(data)
    with pytest.raises(HrgError, match=message):
        sources.read_record(path)


def test_a_parquet_file_is_held_to_the_same(tmp_path: Path) -> None:
    path = tmp_path / "log.parquet"
    table = TABLE.copy()
    table.loc[7, GYRO_Y] = np.nan
    table.to_parquet(path)
    with pytest.raises(HrgError, match="row 8, gyro_y_rad_s: found nan, expected a finite number"):
        sources.read_record(path)
    with_cell(7, GYRO_Y, "x").astype({GYRO_Y: str}).to_parquet(path)
    with pytest.raises(HrgError, match=r"column gyro_y_rad_s: found .*, expected numbers"):
        sources.read_record(path)


def test_a_missing_file_is_named(tmp_path: Path) -> None:
    with pytest.raises(HrgError, match=r"none\.csv: can't be read: No such file"):
        sources.read_record(tmp_path / "none.csv")


def test_pattern_angles_are_read_where_the_log_has_them(tmp_path: Path) -> None:
    table = frame(resting())
    degrees = {f"pattern_{axis}_deg": np.arange(len(table)) + i for i, axis in enumerate("xyz")}
    found = sources.read_record(saved(table.assign(**degrees), tmp_path)).pattern_angle
    np.testing.assert_allclose(found, np.deg2rad(np.array(list(degrees.values())).T))
    assert sources.read_record(saved(table, tmp_path, "plain.csv")).pattern_angle is None
    with pytest.raises(HrgError, match="no column pattern_z_deg"):
        sources.read_record(saved(table.assign(pattern_x_deg=1, pattern_y_deg=1), tmp_path))
