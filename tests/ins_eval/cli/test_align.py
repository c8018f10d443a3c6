"""`hrg align` from the command line."""

import json
from pathlib import Path

import pytest

from ins_eval.flights import align_report
from ins_eval.imu.specification import load_imu
from pyhrg.common.cli import main
from tests.ins_eval.flights.logs import LATITUDE_DEG, ring_laser, written


def align(out: Path, *arguments: str) -> dict:
    """Document of a run that succeeds."""
    assert main(["align", "--out", str(out), *arguments]) == 0
    assert sorted(path.name for path in out.iterdir()) == sorted(align_report.FILES)
    assert (out / "align.png").read_bytes().startswith(b"\x89PNG")
    return json.loads((out / "align.json").read_text())


def test_simulated_imu_is_aligned_within_its_sigma(tmp_path: Path) -> None:
    document = align(tmp_path / "result", "--seconds", "120")
    found = document["alignment"]
    for angle in ("heading", "pitch", "roll"):
        assert abs(document["error_deg"][angle]) < 4 * found[f"{angle}_sigma_deg"]
    assert document["believed"]["gyro_bias_deg_per_h"] == pytest.approx(0.01)
    assert "measured" not in document


def test_log_is_aligned_where_options_say(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    log = written(tmp_path, 130.0)
    options = (str(log), "--latitude-deg", LATITUDE_DEG, "--from-s", "10", "--seconds", "120")
    document = align(tmp_path / "result", *options)
    found = document["alignment"]
    assert found["heading_deg"] == pytest.approx(30, abs=4 * found["heading_sigma_deg"])
    assert document["from_s"] == pytest.approx(-120)
    assert "error_deg" not in document
    text = capsys.readouterr().out
    assert "standing.csv: 120 s at 100 Hz, from -120 s, at latitude 39.9000 deg" in text
    assert f"{found['heading_deg']:.4f}" in text
    assert "the vehicle sways by" in text
    assert "prior: random walks of the simple IMU, a decade wide; its biases are assumed" in text
    assert document["prior"] == "simple"
    measured = document["measured"]
    true = load_imu("simple").errors.velocity_random_walk
    error = abs(measured["velocity_random_walk_m_per_s_per_sqrt_s"] / true - 1)
    assert error < 4 * measured["velocity_random_walk_relative_sigma"] < 2


def test_recorded_ring_laser_is_aligned_on_its_first_300_s(tmp_path: Path) -> None:
    document = align(tmp_path, str(ring_laser()))
    found = document["alignment"]
    assert document["duration_s"] == pytest.approx(300)
    assert found["heading_deg"] == pytest.approx(90.6, abs=0.3)
    assert 0 < found["heading_sigma_deg"] < 0.2
    assert found["sway_m"] > 1e-5


def test_same_seed_same_bytes(tmp_path: Path) -> None:
    for out, seed in (("a", "5"), ("b", "5"), ("c", "6")):
        align(tmp_path / out, "--seconds", "60", "--seed", seed)
    for name in align_report.FILES:
        first = (tmp_path / "a" / name).read_bytes()
        assert first == (tmp_path / "b" / name).read_bytes(), name
        assert first != (tmp_path / "c" / name).read_bytes(), name


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (["--seconds", "15"], "seconds: found 15, expected a number from 30 to 7200"),
        (["--seed", "x"], "argument --seed: found 'x', expected a whole number"),
        (["--from-s", "5"], "--from-s: is for recorded logs, and the IMU is simulated"),
        (["--latitude-deg", "5"], "--latitude-deg: is for recorded logs, and the IMU is simulated"),
        (["nowhere.csv"], "nowhere.csv: can't be read: No such file"),
        (
            ["nowhere.csv", "--seed", "1"],
            "--seed: is for simulated IMUs, and nowhere.csv is recorded",
        ),
        (
            ["--imu", "nothing"],
            "nothing: found no such file and no ready IMU of this name, expected a",
        ),
        (["--trajectory", "great-circle"], "it can't stand still for 320 s before\n"),
    ],
)
def test_mistake_is_one_line_and_status_2(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], arguments: list[str], message: str
) -> None:
    try:
        status = main(["align", "--out", str(tmp_path / "result"), *arguments])
    except SystemExit as stop:
        status = int(str(stop.code))
    assert status == 2
    error = capsys.readouterr().err
    assert message in error
    assert error.count("\n") == 1
    assert list(tmp_path.iterdir()) == []


def test_log_must_be_long_enough(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    log = written(tmp_path, 60.0)
    arguments = ["align", str(log), "--latitude-deg", "40", "--out", str(tmp_path / "result")]
    assert main(arguments) == 2
    assert "found 60 s, expected 300 s at least" in capsys.readouterr().err
