"""`hrg nav` from the command line."""

import json
from pathlib import Path

import numpy as np
import pandas as pd
import pytest
from pyarrow import csv

from ins_eval.flights import fly
from pyhrg.common.cli import main
from tests.ins_eval.flights.logs import LATITUDE_DEG, ring_laser, written
from tests.ins_eval.trajectories import test_recorded_drive as drives

LOG = ("nav.json", "flights.csv", "flights.parquet", "flights.nc", "map.png", "budget.csv")
SIMULATED = (*LOG, "growth.png", "budget.png")
SHORT = ("--hours", "0.1", "--rate-hz", "20")
BRIEF = (*SHORT, "--align-s", "60")
UNALIGNED = (*SHORT, "--start-from-truth")


def nav(out: Path, *arguments: str) -> dict:
    """Document of a run that succeeds."""
    assert main(["nav", "--out", str(out), *arguments]) == 0
    return json.loads((out / "nav.json").read_text())


def test_writes_what_it_promises(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    out = tmp_path / "result"
    document = nav(out, *BRIEF, "--seed", "3")
    assert sorted(path.name for path in out.iterdir()) == sorted(SIMULATED)
    assert list(tmp_path.iterdir()) == [out]
    for name in SIMULATED:
        if name.endswith(".png"):
            assert (out / name).read_bytes().startswith(b"\x89PNG")
    assert document["seed"] == 3
    assert document["rate_hz"] == pytest.approx(20)
    assert document["versions"]["hrg"]
    text = capsys.readouterr().out
    assert "car, 6 min, simple IMU at 20 Hz, height clamped" in text
    assert "navigator's own error, mm" in text
    assert f"{document['at_the_end']['north_error_m'][0]:.4g}" in text


def test_tables_and_document_say_the_same(tmp_path: Path) -> None:
    document = nav(tmp_path, *BRIEF, "--runs", "2")
    table = csv.read_csv(tmp_path / "flights.csv").to_pandas()
    pd.testing.assert_frame_equal(table, pd.read_parquet(tmp_path / "flights.parquet"))
    last = table[table["time_s"] == table["time_s"].max()]
    assert last["run"].tolist() == [1, 2]
    assert last["north_error_m"].tolist() == document["at_the_end"]["north_error_m"]
    assert last["time_s"].tolist() == [360.0, 360.0]
    shares = pd.read_csv(tmp_path / "budget.csv")
    parts = pd.DataFrame(document["budget_of_run_1"])
    np.testing.assert_allclose(shares["north_contribution_m"], parts["north_contribution_m"])


def test_another_flight_in_the_folder_is_kept_unless_forced(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    nav(tmp_path, *UNALIGNED)
    before = (tmp_path / "nav.json").read_bytes()
    arguments = ["nav", "--out", str(tmp_path), *UNALIGNED]
    for other, differs in (
        (["--seed", "2"], "seed: found 1, expected 2"),
        (["--imu", "ideal"], "imu: found 'simple IMU', expected 'ideal IMU'"),
    ):
        assert main([*arguments, *other]) == 2
        assert f"nav.json: another run: {differs}" in capsys.readouterr().err
    assert (tmp_path / "nav.json").read_bytes() == before
    assert nav(tmp_path, *UNALIGNED) == json.loads(before)
    assert nav(tmp_path, *UNALIGNED, "--seed", "2", "--force")["seed"] == 2


def test_budget_sums_to_the_flown_error(tmp_path: Path) -> None:
    document = nav(tmp_path, *BRIEF)
    end = document["at_the_end"]
    for component in ("north", "east"):
        parts = [share[f"{component}_contribution_m"] for share in document["budget_of_run_1"]]
        assert sum(parts) == pytest.approx(
            end[f"{component}_error_m"][0], abs=0.01 * end["radial_error_m"][0]
        )


def test_ideal_imu_shows_the_navigator_alone(tmp_path: Path) -> None:
    document = nav(tmp_path, *UNALIGNED, "--imu", "ideal", "--rate-hz", "100")
    largest = document["largest_own_error_mm"]
    assert 0 < largest < 1
    assert 1000 * document["at_the_end"]["radial_error_m"][0] <= largest
    assert document["at_the_end"]["north_sigma_m"] == 0
    assert document["alignments"] == []


def test_same_seed_same_bytes(tmp_path: Path) -> None:
    for out, seed in (("a", "5"), ("b", "5"), ("c", "6")):
        nav(tmp_path / out, *BRIEF, "--seed", seed)
    for name in SIMULATED:
        first = (tmp_path / "a" / name).read_bytes()
        assert first == (tmp_path / "b" / name).read_bytes(), name
        assert first != (tmp_path / "c" / name).read_bytes(), name


def test_first_run_is_the_same_however_many_follow(tmp_path: Path) -> None:
    one = nav(tmp_path / "one", *BRIEF)
    three = nav(tmp_path / "three", *BRIEF, "--runs", "3")
    errors = three["at_the_end"]["north_error_m"]
    assert errors[0] == one["at_the_end"]["north_error_m"][0]
    assert len(set(errors)) == 3


@pytest.mark.parametrize(
    "options",
    [
        (*BRIEF, "--height", "baro"),
        (*UNALIGNED, "--height", "free"),
        (*UNALIGNED, "--samples", "3"),
        (*UNALIGNED, "--samples", "4", "--rate-hz", "50"),
        (*BRIEF, "--trajectory", "ship"),
        (*UNALIGNED, "--trajectory", "weaving"),
        (*UNALIGNED, "--trajectory", "great-circle"),
    ],
)
def test_options_fly(tmp_path: Path, options: tuple[str, ...]) -> None:
    document = nav(tmp_path, *options)
    assert document["at_the_end"]["time_s"] == pytest.approx(360)
    assert 0 < document["at_the_end"]["radial_error_m"][0] < 2000
    assert 0 < document["largest_own_error_mm"] < 100


def test_recorded_drive_is_flown(tmp_path: Path) -> None:
    drive = drives.write_drive(tmp_path, drives.make_drive())
    document = nav(tmp_path / "result", *BRIEF, "--trajectory", str(drive))
    assert document["trajectory"] == "drive.csv"


def test_log_without_truth_is_dead_reckoned(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    log = written(tmp_path, 180.0)
    options = ("--imu", str(log), "--latitude-deg", LATITUDE_DEG, "--align-s", "120")
    document = nav(tmp_path / "result", *options)
    files = {path.name for path in (tmp_path / "result").iterdir()}
    assert files == set(LOG)
    assert document["duration_s"] == pytest.approx(60)
    assert "north_error_m" not in document["at_the_end"]
    assert document["at_the_end"]["north_sigma_m"] > 0
    printed = capsys.readouterr().out
    assert "from where it was aligned, m" in printed
    assert "budget of the 1-sigma, m; squares add up\ngyro bias " in printed


def test_log_of_a_vehicle_at_rest_shows_its_drift(tmp_path: Path) -> None:
    log = written(tmp_path, 180.0)
    options = ("--imu", str(log), "--latitude-deg", LATITUDE_DEG, "--align-s", "120")
    document = nav(tmp_path / "result", *options, "--trajectory", "rest")
    assert 0 < document["at_the_end"]["radial_error_m"][0] < 20
    assert document["at_the_end"]["heading_error_deg"] == [None]
    table = csv.read_csv(tmp_path / "result" / "flights.csv").to_pandas()
    assert table["true_heading_deg"].isna().all()


def test_recorded_ring_laser_drifts(tmp_path: Path) -> None:
    document = nav(tmp_path, "--imu", str(ring_laser()), "--trajectory", "rest")
    assert document["at_the_end"]["time_s"] == pytest.approx(1540)
    assert 0 < document["at_the_end"]["radial_error_m"][0] < 2000


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (["--seed", "-1"], "seed: found -1, expected a whole number from 0 to"),
        (["--hours", "0"], "hours: found 0, expected hours up to 24 in whole minutes"),
        (["--hours", "nan"], "hours: found nan, expected hours up to 24 in whole minutes"),
        (["--hours", "0.11111"], "hours: found 0.11111, expected hours up to 24 in whole"),
        (["--rate-hz", "5"], "rate_hz: found 5, expected a whole number from 10 to 2000"),
        (["--rate-hz", "2000", "--hours", "2"], "at 2000 Hz, 14400000 increments; expected at"),
        (["--samples", "5"], "samples: found 5, expected a whole number from 2 to 4"),
        (["--runs", "0"], "runs: found 0, expected a whole number from 1 to 1000"),
        (["--height", "up"], "argument --height: found 'up', expected one of clamped, "),
        (["--align-s", "x"], "argument --align-s: found 'x', expected a number"),
        (["--align-s", "60", "--start-from-truth"], "not allowed with argument"),
        (["--trajectory", "nowhere"], "nowhere: found no such mission, expected aircraft, "),
        (["--trajectory", "nowhere.csv"], "nowhere.csv: can't be read: No such file"),
        (["--trajectory", "weaving"], "stand still for 300 s before; or start from the truth"),
        (["--trajectory", "missile"], "shorter than the 3600 s asked for"),
        (
            ["--imu", "nothing"],
            "nothing: found no such file and no ready IMU of this name, expected a",
        ),
        (["--imu", "nothing.toml"], "nothing.toml: found no such file"),
        (["--imu", "nothing.csv"], "nothing.csv: can't be read: No such file"),
        (["--latitude-deg", "40"], "--latitude-deg: is for recorded logs, and the IMU is sim"),
        (["--errors-of", "simple"], "--errors-of: is for recorded logs, and the IMU is simulated"),
        (["--imu", "typical-hrg", "--rate-hz", "30"], "expected a multiple of the gyros' control"),
        (["--bogus"], "found --bogus, expected"),
    ],
)
def test_mistake_is_one_line_and_status_2(
    tmp_path: Path,
    capsys: pytest.CaptureFixture[str],
    arguments: list[str],
    message: str,
) -> None:
    assert refusal(tmp_path, capsys, arguments).count("\n") == 1
    assert message in refusal(tmp_path, capsys, arguments)
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (
            [],
            "it doesn't say where it was recorded; expected the argument latitude_deg",
        ),
        (["--latitude-deg", "90"], "latitude_deg: found 90, expected a number from -89 to 89"),
        (["--height-m", "9"], "height_m: found 9, expected latitude_deg as well"),
        (["--latitude-deg", "40", "--runs", "2"], "--runs: is for simulated IMUs, and standing"),
        (["--latitude-deg", "40", "--start-from-truth"], "--start-from-truth: is for simulated"),
        (["--latitude-deg", "40"], "lasts 60 s; expected 300 s of alignment and 10 s of flight"),
        (
            ["--latitude-deg", "40", "--align-s", "40", "--trajectory", "nowhere.csv"],
            "nowhere.csv: can't be read",
        ),
    ],
)
def test_mistake_with_a_log_is_one_line_and_status_2(
    tmp_path: Path,
    capsys: pytest.CaptureFixture[str],
    arguments: list[str],
    message: str,
) -> None:
    log = written(tmp_path, 60.0)
    error = refusal(tmp_path, capsys, ["--imu", str(log), *arguments])
    assert message in error
    assert error.count("\n") == 1
    assert list(tmp_path.iterdir()) == [log]


def refusal(folder: Path, capsys: pytest.CaptureFixture[str], arguments: list[str]) -> str:
    """What is said of a run that is refused."""
    try:
        status = main(["nav", "--out", str(folder / "result"), *arguments])
    except SystemExit as stop:
        status = int(str(stop.code))
    assert status == 2
    return capsys.readouterr().err


def test_reference_must_begin_with_the_log(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    log = written(tmp_path, 60.0)
    drive = drives.write_drive(tmp_path, drives.make_drive())
    options = ["--imu", str(log), "--latitude-deg", "-40", "--align-s", "40"]
    error = refusal(tmp_path, capsys, [*options, "--trajectory", str(drive)])
    assert "km from where the log was recorded; expected at most 1 km" in error


def test_reference_must_cover_the_log(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    log = written(tmp_path, 400.0)
    drive = drives.write_drive(tmp_path, drives.make_drive())
    options = ["--imu", str(log), "--latitude-deg", "40", "--trajectory", str(drive)]
    assert "lasts 120 s; expected all of the log, 400 s" in refusal(tmp_path, capsys, options)


def test_interruption_leaves_nothing_behind(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def interrupted(*_: object) -> None:
        raise KeyboardInterrupt

    monkeypatch.setattr(fly, "fly_runs", interrupted)
    assert main(["nav", "--out", str(tmp_path / "result"), *BRIEF]) == 130
    assert list(tmp_path.iterdir()) == []


def test_folder_that_cannot_be_written(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (tmp_path / "file").write_text("in the way")
    assert main(["nav", "--out", str(tmp_path / "file")]) == 2
    assert capsys.readouterr().err.startswith(f"hrg: {tmp_path / 'file'}: it is no folder")
    (tmp_path / "map.png").mkdir()
    assert main(["nav", "--out", str(tmp_path)]) == 2
    assert "map.png is a folder" in capsys.readouterr().err


def test_an_own_fmu_is_for_gyros_of_a_device(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """Gyros of stated errors, a missing file and a recorded log are each refused in one line."""
    missing = str(tmp_path / "missing.fmu")
    log = written(tmp_path, 10)
    for imu, word in (("simple", "stated errors"), ("typical-hrg", missing), (str(log), "--fmu")):
        assert main(["nav", "--out", str(tmp_path / "out"), "--imu", imu, "--fmu", missing]) == 2
        error = capsys.readouterr().err
        assert word in error
        assert error.count("\n") == 1
