"""`hrg validate` from the command line: the small study, from blocks that are there already."""

import csv
import json
from dataclasses import replace
from pathlib import Path

import pytest

from ins_eval.study.run.block import identify_study, pack_block
from ins_eval.study.run.folder import claim_folder
from ins_eval.study.validation.validate import plan_validation
from pyhrg.common.cli import main
from tests.ins_eval.study import made_up
from tests.ins_eval.study.test_experiment import PLAN

OPTIONS = ["--hours", "0.2", "--triads", "36", "--seed", "3"]


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Blocks of the study that `OPTIONS` ask for, of gyros that were benched in a hurry."""
    study = plan_validation(hours=0.2, triads=36, seed=3)
    hurried = replace(study, settings={"bench": PLAN, "calibration": {**PLAN, "runs": 1}})
    out = tmp_path_factory.mktemp("validation") / "out"
    arrays = made_up.many(study, made_up.few(hurried))
    with claim_folder(out, identify_study(study)) as kept:
        for number, block in enumerate(made_up.blocks(study, arrays)):
            kept.keep(number, pack_block(block, kept.identity, number))
    return out


def test_validate_writes_its_files(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["validate", *OPTIONS, "--out", str(folder)]) == 0
    said = capsys.readouterr().out
    document = json.loads((folder / "validation.json").read_text())
    assert document["seed"] == 3
    assert document["flown"]["n"] == document["flown"]["co_simulated"] == 16
    assert document["predicted"]["fixed_position"]["radial_error_nmi"] == pytest.approx(0.09)
    assert document["predicted"]["full_circumference"]["radial_error_nmi"] == pytest.approx(10)
    for sentence in document["sentences"]:
        assert sentence in said
    flights = {each["mission"]: each for each in document["flights"]}
    assert list(flights) == ["car", "aircraft"]
    assert flights["car"]["flown"]["n"] == flights["car"]["flown"]["co_simulated"] == 36
    claims = document["claims"]["mean"]
    assert [each["claim"] for each in claims] == ["a", "b", "c"]
    for each in claims:
        assert f"({each['claim']}) {each['statement']}: {each['verdict'].upper()} (n" in said
        assert each["n"] == 36
        assert {score["mission_class"] for score in each["by_class"]} == {
            "car",
            "aircraft with rolls",
        }
    conditions = said.split("(d) The claims in other conditions, by the linear model:")[1]
    assert conditions.count("n = 24: (a) ") == len(document["conditions"]) == 7
    for each in document["conditions"]:
        assert each["name"] in conditions


def test_views_are_of_the_judged_triads(folder: Path) -> None:
    """The CSV's last row is the end, whose median the document has."""
    assert main(["validate", *OPTIONS, "--out", str(folder)]) == 0
    rows = list(csv.DictReader((folder / "position_error.csv").read_text().splitlines()))
    assert [(row["mission"], float(row["time_s"])) for row in rows] == [
        (mission, time) for mission in ("car", "aircraft") for time in (600, 720)
    ]
    assert {"triad_24_m", "triad_59_m"} <= set(rows[0])
    assert "triad_23_m" not in rows[0]
    document = json.loads((folder / "validation.json").read_text())
    median = document["flights"][-1]["flown"]["radial_error_nmi"] * 1852
    assert float(rows[-1]["flown_median_m"]) == pytest.approx(median, rel=1e-5)
    assert (folder / "validation.png").read_bytes().startswith(b"\x89PNG")


def test_again_is_told_without_work(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    for _ in range(2):
        assert main(["validate", *OPTIONS, "--out", str(folder)]) == 0
    said = capsys.readouterr().out
    assert said[: len(said) // 2] == said[len(said) // 2 :]


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (["--seed", "-1"], "seed: found -1, expected a whole number from 0 to"),
        (["--seed", "abc"], "argument --seed: found 'abc', expected a whole number"),
        (["--hours", "0"], "hours: found 0, expected a number from 0.1 to 10"),
        (["--hours", "nan"], "hours: found nan, expected a number"),
        (["--hours", "1e9"], "hours: found 1e+09, expected a number"),
        (["--triads", "5"], "triads: found 5, expected a whole number from 36 to 1000000"),
        (["--calibration", "best"], "--calibration: found 'best', expected one of mean, map"),
        (["--trajectory", "nowhere.csv"], "nowhere.csv: can't be read: No such file"),
        (["--trajectory", "nowhere"], "nowhere: found no such mission, expected aircraft, "),
        (["--trajectory", "weaving"], "weaving"),
        (["--workers", "0"], "workers: found 0, expected a whole number from 1"),
        (["--bogus"], "found --bogus, expected"),
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


def test_folder_of_something_else_is_refused(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "validation.json").write_text("mine")
    assert main(["validate", "--out", str(tmp_path)]) == 2
    assert "found validation.json, expected an empty folder or a study's" in capsys.readouterr().err
    assert (tmp_path / "validation.json").read_text() == "mine"
