"""`hrg validate` from the command line."""

import csv
import json
from pathlib import Path

import pytest

from fmu_build.cli import main
from tests.ins_eval.trajectories.test_recorded_drive import made_up_drive, written


def test_validate_writes_what_it_promises(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    out = tmp_path / "result"
    arguments = ["validate", "--seed", "3", "--hours", "0.1", "--triads", "6"]
    assert main([*arguments, "--out", str(out)]) == 0
    document = json.loads((out / "validation.json").read_text())
    assert document["seed"] == 3
    assert document["hours"] == pytest.approx(0.1)
    assert document["flown"]["n"] == 6
    for test in ("fixed_position", "full_circumference"):
        assert document["bench"][test]["bias_stability_deg_per_h"] > 0
        assert document["predicted"][test]["radial_error_nmi"] > 0
    assert document["flown"]["radial_error_nmi"] > 0
    rows = list(csv.DictReader((out / "position_error.csv").read_text().splitlines()))
    assert len(rows) == 6
    assert {"time_s", "flown_median_m", "triad_006_m"} <= set(rows[0])
    assert (out / "validation.png").read_bytes().startswith(b"\x89PNG")
    assert document["verdict"] in capsys.readouterr().out
    assert list(tmp_path.iterdir()) == [out]


def test_recorded_drive_is_flown(tmp_path: Path) -> None:
    drive = written(tmp_path, made_up_drive())
    out = tmp_path / "result"
    arguments = ["validate", "--trajectory", str(drive), "--hours", "0.1", "--triads", "6"]
    assert main([*arguments, "--out", str(out)]) == 0
    document = json.loads((out / "validation.json").read_text())
    assert document["mission"] == "drive.csv"


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (["--seed", "-1"], "--seed -1: expected a whole number from 0 to"),
        (["--seed", "abc"], "--seed abc: expected a whole number"),
        (["--hours", "0"], "--hours 0: expected a number from 0.1 to 24, in whole minutes"),
        (["--hours", "nan"], "--hours nan: expected a number"),
        (["--hours", "1e9"], "--hours 1e9: expected a number"),
        (["--triads", "5"], "--triads 5: expected a whole number from 6 to 10000"),
        (["--trajectory", "nowhere.csv"], "nowhere.csv: can't be read: No such file"),
        (["--bogus"], "unrecognized arguments: --bogus"),
    ],
)
def test_mistake_is_one_line_and_status_2(
    tmp_path: Path,
    capsys: pytest.CaptureFixture[str],
    arguments: list[str],
    message: str,
) -> None:
    out = tmp_path / "result"
    try:
        status = main(["validate", "--out", str(out), *arguments])
    except SystemExit as stop:
        status = int(str(stop.code))
    error = capsys.readouterr().err
    assert status == 2
    assert message in error
    assert error.count("\n") == 1
    assert list(tmp_path.iterdir()) == []


def test_file_in_the_way_of_a_result_is_found_before_the_work(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "validation.json").mkdir()
    assert main(["validate", "--out", str(tmp_path)]) == 2
    assert "validation.json is a folder" in capsys.readouterr().err


def test_output_folder_that_cannot_be_written(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "file").write_text("in the way")
    for out in ("file", "file/below"):
        assert main(["validate", "--out", str(tmp_path / out)]) == 2
        error = capsys.readouterr().err
        assert error.startswith(f"hrg: can't write {tmp_path / out}: ")
        assert error.count("\n") == 1
    assert (tmp_path / "file").read_text() == "in the way"
    assert [path.name for path in tmp_path.iterdir()] == ["file"]
