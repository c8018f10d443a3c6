"""Predictions as a file: what is read, what is refused by line and field."""

from pathlib import Path

import pytest

from ins_eval.study.challenge.score_predictions import read_predictions
from pyhrg.common.errors import HrgError

FLIGHTS = {(2, "car"), (3, "car"), (2, "ship"), (3, "ship")}
HEADER = "mission,triad,low_m,median_m,high_m,remark"
ROWS = ["car,3,1,2,3,", "ship,2,0,0,4.5e3,why not", "car,2,5,5,5,", "ship,3,1,2,3,"]


def write(folder: Path, *lines: str) -> Path:
    path = folder / "mine.csv"
    path.write_text("\n".join(lines) + "\n")
    return path


def test_columns_and_rows_in_any_order(tmp_path: Path) -> None:
    found = read_predictions(write(tmp_path, HEADER, *ROWS), FLIGHTS)
    assert found.values.tolist() == [
        [2, "car", 5, 5, 5],
        [2, "ship", 0, 0, 4500],
        [3, "car", 1, 2, 3],
        [3, "ship", 1, 2, 3],
    ]


@pytest.mark.parametrize(
    ("row", "message"),
    [
        ("car,2,1,2,many,", "line 4: high_m: found 'many', expected a number from median_m, 2"),
        ("car,2,,2,3,", "line 4: low_m: found '', expected a number from 0"),
        ("car,2,-1,2,3,", "line 4: low_m: found '-1', expected a number from 0"),
        ("car,2,3,2,4,", "line 4: median_m: found '2', expected a number from low_m, 3"),
        ("car,2,1,nan,4,", "line 4: median_m: found 'nan', expected a number from low_m, 1"),
        ("car,2,1,2,inf,", "line 4: high_m: found 'inf', expected"),
        ("car,2,1", "line 4: median_m: found '', expected a number from low_m, 1"),
        ("car,1,1,2,3,", "line 4: triad: found '1', expected one that is judged, 2 to 3"),
        ("car,2.0,1,2,3,", "line 4: triad: found '2.0', expected one that is judged"),
        (f"car,{'9' * 5000},1,2,3,", "line 4: triad: found '999.*999', expected one that is"),
        ("bus,2,1,2,3,", "line 4: mission: found 'bus', expected car or ship"),
        ("car,3,1,2,3,", r"line 4: triad: found \(3, 'car'\) again, expected it once"),
        ("ship,3,1,2,3,", "found no row for triad 2, mission car, expected all 4 judged flights"),
    ],
)
def test_bad_rows_are_refused(row: str, message: str, tmp_path: Path) -> None:
    rows = ROWS[:2] + [row] + ROWS[3:] * (row != ROWS[3])
    with pytest.raises(HrgError, match=f"mine.csv: {message}"):
        read_predictions(write(tmp_path, HEADER, *rows), FLIGHTS)


def test_missing_column_is_refused(tmp_path: Path) -> None:
    path = write(tmp_path, "triad,mission,median_m", "2,car,1")
    with pytest.raises(HrgError, match=r"mine.csv: found no column low_m, expected triad,"):
        read_predictions(path, FLIGHTS)
