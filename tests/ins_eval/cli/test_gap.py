"""`hrg gap diagnose` and `hrg gap predict`, from the command line."""

import json
import shutil
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any, cast

import numpy as np
import pytest

from ins_eval.cli import gap
from pyhrg import records
from pyhrg.bench.bench import Bench, PowerOn
from pyhrg.common.cli import main
from pyhrg.common.units import ARCSEC, DEG
from pyhrg.fmu import GyroFmu
from pyhrg.gap.findings.diagnosis import Cause, write
from pyhrg.records import campaign
from tests.pyhrg.gap.bench import recorded
from tests.pyhrg.gap.findings.test_diagnosis import GIVEN
from tests.pyhrg.gap.soundness.conftest import NOMINAL


@pytest.fixture(scope="session")
def made(fmu: GyroFmu, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A campaign of two tests, without a gap, on disk."""
    folder = tmp_path_factory.mktemp("campaign")
    begun = Bench(fmu, NOMINAL).programme
    power_ons = [
        PowerOn("still", "static", begun().rest(100)),
        PowerOn("ride", "manoeuvre", begun(0.5).rest(5).turn(90 * DEG, 10 * DEG).rest(120)),
    ]
    campaign.write_campaign(recorded(fmu, NOMINAL, power_ons=power_ons), folder)
    return folder


@pytest.fixture
def folder(made: Path, tmp_path: Path) -> Path:
    shutil.copytree(made, tmp_path / "campaign")
    return tmp_path / "campaign"


def edit(folder: Path, change: Callable[[dict[str, Any]], object]) -> None:
    index = json.loads((folder / "campaign.json").read_text())
    change(index)
    (folder / "campaign.json").write_text(json.dumps(index))


def diagnose(folder: Path, out: Path) -> int:
    return main(["gap", "diagnose", str(folder), "--out", str(out)])


def test_the_truth_is_never_read(folder: Path, tmp_path: Path) -> None:
    """It lies: the loops' delay is as believed."""
    lie = {"effects": ["loop_delay"], "parameters": {"loop_delay_s": 0.01}}
    (folder / "truth.json").write_text(json.dumps(lie))
    assert diagnose(folder, tmp_path / "out") == 0
    assert json.loads((tmp_path / "out" / "diagnosis.json").read_text())["verdict"] == "no_gap"
    assert "missions" in json.loads((tmp_path / "out" / "position.json").read_text())
    assert 'id="position"' in (tmp_path / "out" / "report.html").read_text()


def test_a_diagnosis_survives_a_section_that_fails(
    folder: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def fail(*_: object) -> None:
        raise ValueError("no mission")

    monkeypatch.setattr(gap, "make_position_section", fail)
    assert diagnose(folder, tmp_path / "out") == 0
    failed = json.loads((tmp_path / "out" / "position.json").read_text())["failed"]
    assert failed == "could not be made: ValueError: no mission"
    assert failed in (tmp_path / "out" / "report.html").read_text()


@pytest.mark.parametrize(
    ("options", "message"),
    [
        (["--belief", "belief.toml"], "found --belief, which is for static records"),
        (["--trusted"], "found --trusted, which is for static records"),
    ],
)
def test_options_of_a_static_record_are_refused_for_a_campaign(
    folder: Path,
    tmp_path: Path,
    options: list[str],
    message: str,
    capsys: pytest.CaptureFixture[str],
) -> None:
    assert main(["gap", "diagnose", str(folder), "--out", str(tmp_path / "out"), *options]) == 2
    assert message in refused(capsys)


def test_the_closed_simulation_answers_to_a_log(
    folder: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    edit(folder, lambda index: index["nominal"].update(colour=3.0))
    device = campaign.read_campaign(folder).device
    for name, causes in (("d", (Cause("loop_delay", 1.0, {"loop_delay_s": 0.01}),)), ("none", ())):
        (tmp_path / name).mkdir()
        write(replace(GIVEN, device=device, causes=causes), tmp_path / name)
    log = records.read_log(folder / "ride.csv.gz")
    answers = {}
    for name in ("d", "none"):
        given = [str(tmp_path / name / "diagnosis.json"), str(folder / "ride.csv.gz")]
        out = tmp_path / f"{name}.csv"
        assert main(["gap", "predict", *given, "--campaign", str(folder), "--out", str(out)]) == 0
        assert out.read_text().startswith("time_s,gyro_angle_deg,residual_arcsec\n")
        time, answers[name], residual = np.loadtxt(out, delimiter=",", skiprows=1).T
        recorded = log.gyro_angle / ARCSEC
        np.testing.assert_allclose(recorded - answers[name] * DEG / ARCSEC, residual, atol=1e-3)
        rms = np.std(residual)
        assert f"record less prediction: {rms:.3g} arcsec rms about" in capsys.readouterr().out
        np.testing.assert_allclose(time, log.time)
    left = answers["none"] * DEG - log.gyro_angle
    assert np.abs(left).max() < 3 * ARCSEC
    assert np.abs(answers["d"] - answers["none"]).max() * DEG > 1 * ARCSEC


def refused(capsys: pytest.CaptureFixture[str]) -> str:
    lines = [line for line in capsys.readouterr().err.splitlines() if line.startswith("hrg")]
    assert len(lines) == 1
    return lines[0]


BAD: list[tuple[Callable[[dict[str, Any]], object], str]] = [
    (lambda index: index["nominal"].pop("decay_time_s"), "nominal.decay_time_s: missing"),
    (lambda index: index["nominal"].update(decay_time_s=-1.0), "decay_time_s: found -1.0"),
    (lambda index: index.update(tests=index["tests"][1:]), "no test that may be fitted"),
    (lambda index: index["tests"][0].update(file="gone.csv.gz"), "gone.csv.gz"),
]


@pytest.mark.parametrize(("change", "message"), BAD)
def test_a_bad_campaign_is_refused_in_one_line(
    folder: Path,
    tmp_path: Path,
    change: Callable[[dict[str, Any]], object],
    message: str,
    capsys: pytest.CaptureFixture[str],
) -> None:
    edit(folder, change)
    assert diagnose(folder, tmp_path / "out") != 0
    assert message in refused(capsys)
    assert not (tmp_path / "out").exists()


def test_no_campaign_is_refused(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (tmp_path / "empty").mkdir()
    assert diagnose(tmp_path / "empty", tmp_path / "out") != 0
    assert "campaign.json" in refused(capsys)


def test_logs_without_the_angle_are_refused(
    folder: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    given = campaign.read_campaign(folder)
    for test in given.tests:
        log = test.log
        log.gyro_angle[:] = np.nan
        records.write_log(log, folder / f"{test.id}.csv.gz")
    assert diagnose(folder, tmp_path / "out") != 0
    assert "gyro_angle_deg" in refused(capsys)


def predict(folder: Path, document: dict[str, Any], log: str = "ride.csv.gz") -> int:
    """Into `p.csv` beside the campaign."""
    path = folder.parent / "d.json"
    device = campaign.read_campaign(folder).device
    path.write_text(json.dumps({**GIVEN.document(), "device": device, **document}))
    given = [str(path), str(folder / log), "--campaign", str(folder)]
    return main(["gap", "predict", *given, "--out", str(folder.parent / "p.csv")])


def cause(effect: str, **parameters: float) -> dict[str, Any]:
    (table,) = replace(GIVEN, causes=(Cause(effect, 1.0, parameters),)).document()["causes"]
    return cast(dict[str, Any], table)


BAD_DIAGNOSES: list[tuple[dict[str, Any], str]] = [
    (
        {"causes": [cause("frequency_split", frequency_split_Hz=1.0)]},
        "frequency_split: stiffness_axis_deg: missing",
    ),
    ({"causes": [cause("gremlins")]}, "gremlins: expected one of damping_anisotropy,"),
    ({"causes": [], "device": "another"}, "device: found 'another', expected"),
    ({"record": "static.imu"}, "record: found 'static.imu', expected a campaign's diagnosis"),
]


@pytest.mark.parametrize(("document", "message"), BAD_DIAGNOSES)
def test_a_bad_diagnosis_is_refused(
    folder: Path, document: dict[str, Any], message: str, capsys: pytest.CaptureFixture[str]
) -> None:
    assert predict(folder, document) != 0
    assert message in refused(capsys)
    assert not (folder.parent / "p.csv").exists()


def test_what_a_recorder_has_lost_is_predicted_as_it_is_diagnosed(folder: Path) -> None:
    log = records.read_log(folder / "ride.csv.gz")
    assert predict(folder, {"causes": []}) == 0
    whole = np.loadtxt(folder.parent / "p.csv", delimiter=",", skiprows=1)
    log.temperature[200] = np.nan
    log.virtual_rotation[:] = np.nan
    records.write_log(log, folder / "ride.csv.gz")
    assert predict(folder, {"causes": []}) == 0
    found = np.loadtxt(folder.parent / "p.csv", delimiter=",", skiprows=1)
    np.testing.assert_allclose(found, whole, atol=0.1 * ARCSEC / DEG)


def test_an_output_angle_that_counts_from_elsewhere_is_predicted_as_it_is_diagnosed(
    folder: Path,
) -> None:
    """Its offset would turn the simulated pattern at power-on."""
    log = records.read_log(folder / "ride.csv.gz")
    assert predict(folder, {"causes": []}) == 0
    whole = np.loadtxt(folder.parent / "p.csv", delimiter=",", skiprows=1)
    log.gyro_angle[:] += 20 * DEG
    records.write_log(log, folder / "ride.csv.gz")
    assert predict(folder, {"causes": []}) == 0
    found = np.loadtxt(folder.parent / "p.csv", delimiter=",", skiprows=1)
    np.testing.assert_allclose(found[:, 1], whole[:, 1], atol=0.1 * ARCSEC / DEG)


def test_a_log_without_angles_is_refused(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    log = records.read_log(folder / "ride.csv.gz")
    log.wave_angle[:] = np.nan
    records.write_log(log, folder / "ride.csv.gz")
    assert predict(folder, {"causes": []}) != 0
    assert "ride.csv.gz: no row with gyro_angle_deg and wave_angle_deg" in refused(capsys)
