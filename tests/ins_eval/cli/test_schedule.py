"""`hrg schedule` from the command line."""

import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import ins_eval
from ins_eval.schedules import report, schedules
from ins_eval.schedules.comparison import CASES, Comparison, Experiment
from ins_eval.schedules.schedule import Schedule
from pyhrg.common.cli import main


@pytest.fixture
def bench(tmp_path: Path) -> list[str]:
    """Results of three gyros with a map of 0.1 deg/h along axes of their own."""
    paths = []
    for number, phase in enumerate((0.3, 1.1, 2.5)):
        terms = {"cos4": 0.1 * np.cos(phase), "sin4": 0.1 * np.sin(phase), "mean": 0.03}
        findings = {
            f"bias_map_{name}_deg_per_h": {"value": x, "interval_95": [x - 4e-4, x + 4e-4]}
            for name, x in terms.items()
        }
        paths.append(tmp_path / f"gyro{number}.json")
        paths[-1].write_text(json.dumps({"findings": findings}))
    return [str(path) for path in paths]


def test_schedules_of_a_benchs_results(
    bench: list[str], capsys: pytest.CaptureFixture[str]
) -> None:
    """The command prints what the front door gives, and nothing worse than no schedule."""
    options = ["--hours", "0.1", "--start-angles-deg", "10", "40", "70"]
    assert main(["schedule", "--bench", *bench, *options, "--json"]) == 0
    printed = json.loads(capsys.readouterr().out)
    chosen = ins_eval.choose_schedules(bench, hours=0.1, start_angles_deg=(10, 40, 70))
    assert printed == chosen.document
    assert all(
        each["rms_m"] <= printed["unscheduled_rms_m"] for each in printed["families"].values()
    )
    assert main(["schedule", "--bench", *bench, *options]) == 0
    parked = printed["families"]["parking"]["start_angles_deg"]
    assert f"forward at {parked[0]:g} deg, right at {parked[1]:g} deg" in capsys.readouterr().out


def make_up(experiment: Experiment, mission: Any, triads: int, seed: int, **_: Any) -> Comparison:
    """Random numbers in place of flights; the first case's errors are ten times the others'."""
    generator = np.random.default_rng(seed)
    scale = np.where(np.arange(len(CASES)) == 0, 1000.0, 100.0)[:, None, None, None]
    error = scale * generator.uniform(1, 2, size=(len(CASES), triads, 6, 2))
    return Comparison(
        seed=seed,
        device="made up",
        mission=mission.name,
        time=60 * np.arange(1.0, 7.0),
        error=error,
        predicted=np.sqrt(np.square(error).sum(axis=-1).mean(axis=-1)),
        schedules=((Schedule(),) * triads,) * len(CASES),
    )


@pytest.mark.usefixtures("fmu_path")
def test_schedule_writes_what_it_promises(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr(schedules, "compare", make_up)
    for out in ("one", "two"):
        arguments = ["--seed", "3", "--hours", "0.1", "--triads", "6", "--out", str(tmp_path / out)]
        assert main(["schedule", *arguments]) == 0
    document = json.loads((tmp_path / "one" / "schedule.json").read_text())
    assert (document["seed"], document["n"], document["mission"]) == (3, 6, "car")
    for name, case in document["cases"].items():
        ratio = case["ratio_to_unscheduled"]["rms"]
        assert 0.8 < ratio["value"] / (10.0 if name == "mean" else 1.0) < 1.25
        assert len(case["schedules"]) == len(case["rms_m"]) == 6
    assert (tmp_path / "one" / "schedule.png").read_bytes().startswith(b"\x89PNG")
    for name in report.FILES:
        assert (tmp_path / "one" / name).read_bytes() == (tmp_path / "two" / name).read_bytes()
    assert "case turned to and fro: chosen" in capsys.readouterr().out


@pytest.mark.parametrize(
    ("options", "said"),
    [
        (["--triads", "5"], "triads: found 5, expected a whole number from 6 to 10000"),
        (["--hours", "11"], "hours: found 11, expected a number from 0.0166667 to 10"),
        (["--device", "table2"], "--device: found no --bench, expected it beside this option"),
        (
            ["--bench", "a", "b", "c", "--seed", "1"],
            "--seed: found --bench, expected none beside this option",
        ),
    ],
)
def test_mistakes_are_one_line(
    options: list[str], said: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(["schedule", *options, "--out", str(tmp_path / "result")]) == 2
    assert capsys.readouterr().err == f"hrg: {said}\n"
    assert list(tmp_path.iterdir()) == []
