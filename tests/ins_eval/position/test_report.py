import json
from dataclasses import replace
from pathlib import Path

import pytest

from ins_eval.position.diagnosis import read
from ins_eval.position.position import Asked, position
from ins_eval.position.report import section
from pyhrg.common.cli import main
from pyhrg.fmu import GyroFmu
from pyhrg.gap.findings.diagnosis import Diagnosis, Gap
from pyhrg.gap.report.sections import sections
from tests.ins_eval.position.conftest import ANGLE, FOUND, RATE, Written

SHORT = Asked(("car",), hours=0.1, triads=20)


def test_the_section_says_how_far_the_belief_misses(slow_fmu: GyroFmu, written: Written) -> None:
    made = section(position(slow_fmu, read(written(damping_anisotropy=4e-8)), SHORT))
    (mission,) = made.document["missions"]
    low, high = mission["missed_interval_95_m"]
    assert 0 < low < mission["missed_rms_m"] < high
    assert made.document["cosimulated"]["triads"] == 2
    assert "<svg" in made.html
    assert "20 triads, seed 1" in made.html
    assert json.loads(made.data())["schema"] == "hrg-gap-position/1"


def test_no_gap_is_no_metres(slow_fmu: GyroFmu, written: Written) -> None:
    made = section(position(slow_fmu, read(written()), SHORT))
    assert "the belief misses 0 m" in made.html
    assert made.document["missions"][0]["missed_rms_m"] == 0.0


def test_reservations_are_told(slow_fmu: GyroFmu, written: Written, confounded: Diagnosis) -> None:
    found = replace(confounded, gap=Gap(ANGLE, RATE, None, None, None, None))
    folder = written(found, drive_gain_mismatch=1e-5, misalignment=1e-3)
    said = " ".join(section(position(slow_fmu, read(folder), SHORT)).document["said"])
    assert "could not tell what was found from damping anisotropy" in said
    assert "No held-out test says" in said
    assert "tilt of the input axis" in said
    outside = replace(FOUND, verdict="unexplained")
    said = " ".join(section(position(slow_fmu, read(written(outside)), SHORT)).document["said"])
    assert "outside the catalogue" in said


def test_the_diagnosis_finds_the_section_and_outlives_its_failure(tmp_path: Path) -> None:
    assert "can't be read" in sections(tmp_path)["position"].document["failed"]


def test_command(written: Written, capsys: pytest.CaptureFixture[str]) -> None:
    folder = written(damping_anisotropy=4e-8)
    options = ["--mission", "car", "--hours", "0.1", "--triads", "20"]
    assert main(["position", str(folder), *options]) == 0
    assert "in car" in capsys.readouterr().out
    assert json.loads((folder / "position.json").read_text())["hours"] == 0.1


@pytest.mark.parametrize(
    ("options", "why"),
    [
        (["--mission", "nowhere"], "nowhere: found no such mission"),
        (["--hours", "11"], "found 11 hours"),
        (["--triads", "2"], "--triads: found 2, expected 10 or more"),
        (["--seed", "-1"], "--seed: found -1"),
    ],
)
def test_command_refuses(
    options: list[str], why: str, written: Written, capsys: pytest.CaptureFixture[str]
) -> None:
    folder = written()
    assert main(["position", str(folder), *options]) == 2
    assert why in capsys.readouterr().err
    assert not (folder / "position.json").exists()


def test_command_wants_a_diagnosis(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (tmp_path / "diagnosis.json").write_text('{"device": "x"}')
    assert main(["position", str(tmp_path)]) == 2
    assert "diagnosis.json: KeyError('verdict'); expected a diagnosis" in capsys.readouterr().err
