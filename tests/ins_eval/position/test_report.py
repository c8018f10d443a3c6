"""The front door, its section of the page, and `hrg position`."""

import json
from dataclasses import replace
from pathlib import Path

import pytest

import ins_eval
from ins_eval.position.front import PositionGap
from pyhrg.common.cli import main
from pyhrg.common.errors import HrgError
from pyhrg.gap.findings.diagnosis import Diagnosis, Gap
from tests.ins_eval.position.conftest import ANGLE, DIAGNOSIS, RATE, WriteDiagnosis


def compute(folder: Path) -> PositionGap:
    return ins_eval.compute_position_gap(folder, missions=["car"], hours=0.1, triads=20)


def test_section_states_the_distance(write_diagnosis: WriteDiagnosis) -> None:
    section = compute(write_diagnosis(damping_anisotropy=4e-8)).section
    (mission,) = section.document["missions"]
    low, high = mission["missed_interval_95_m"]
    assert 0 < low < mission["missed_rms_m"] < high
    assert section.document["cosimulated"]["triads"] == 2
    assert "<svg" in section.html
    assert "20 triads, seed 1" in section.html
    assert json.loads(section.to_json())["schema"] == "hrg-gap-position/1"


def test_table_holds_the_figures_of_the_document(
    write_diagnosis: WriteDiagnosis, tmp_path: Path
) -> None:
    gap = compute(write_diagnosis(damping_anisotropy=4e-8))
    gap.write(tmp_path)
    (mission,) = json.loads((tmp_path / "position.json").read_text())["missions"]
    (row,) = gap.table.to_dict("records")
    assert (row["mission"], row["time_h"]) == ("car", pytest.approx(0.1))
    assert row["missed_m"] == mission["missed_rms_m"]
    assert [row["low_95"], row["high_95"]] == mission["missed_interval_95_m"]
    assert row["residual_steady_m"] == mission["leftover_steady_m"]
    assert row["residual_at_most_m"] == mission["leftover_at_most_m"]
    assert gap.table.attrs["units"]["missed_m"] == "m"


def test_equal_devices_are_stated_as_no_distance(write_diagnosis: WriteDiagnosis) -> None:
    section = compute(write_diagnosis()).section
    assert "0 m apart" in section.html
    assert section.document["missions"][0]["missed_rms_m"] == 0.0


def test_reservations_are_stated(write_diagnosis: WriteDiagnosis, confounded: Diagnosis) -> None:
    content = replace(confounded, gap=Gap(ANGLE, RATE, None, None, None, None))
    gap = compute(write_diagnosis(content, drive_gain_mismatch=1e-5, misalignment=1e-3))
    text = " ".join(gap.sentences)
    assert "confounded with damping anisotropy" in text
    assert "No held-out test says" in text
    assert "misalignment of the input axis" in text
    assert gap.table["residual_steady_m"].isna().all()
    outside = replace(DIAGNOSIS, verdict="unexplained")
    assert "outside the catalogue" in " ".join(compute(write_diagnosis(outside)).sentences)


def test_no_mission_is_refused(tmp_path: Path) -> None:
    with pytest.raises(HrgError, match="missions: found none"):
        ins_eval.compute_position_gap(tmp_path, missions=[])


def test_command(write_diagnosis: WriteDiagnosis, capsys: pytest.CaptureFixture[str]) -> None:
    folder = write_diagnosis(damping_anisotropy=4e-8)
    options = ["--mission", "car", "--hours", "0.1", "--triads", "20"]
    assert main(["position", str(folder), *options]) == 0
    assert "in car" in capsys.readouterr().out
    assert json.loads((folder / "position.json").read_text())["hours"] == 0.1


@pytest.mark.parametrize(
    ("options", "why"),
    [
        (["--mission", "nowhere"], "nowhere: found no such mission"),
        (["--hours", "11"], "hours: found 11, expected a number from"),
        (["--triads", "2"], "triads: found 2, expected a whole number from 10"),
        (["--seed", "-1"], "seed: found -1"),
    ],
)
def test_command_refuses(
    options: list[str],
    why: str,
    write_diagnosis: WriteDiagnosis,
    capsys: pytest.CaptureFixture[str],
) -> None:
    folder = write_diagnosis()
    assert main(["position", str(folder), *options]) == 2
    assert why in capsys.readouterr().err
    assert not (folder / "position.json").exists()


def test_command_wants_a_diagnosis(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (tmp_path / "diagnosis.json").write_text('{"device": "x"}')
    assert main(["position", str(tmp_path)]) == 2
    assert (
        "diagnosis.json: schema: found no such key, expected hrg-diagnosis/1"
        in capsys.readouterr().err
    )
