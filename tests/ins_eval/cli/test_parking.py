"""`hrg parking` from the command line."""

import csv
import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from ins_eval.parking import parking, report
from ins_eval.parking.gyro import CASES
from ins_eval.parking.mission import Mission
from ins_eval.parking.study import Comparison
from ins_eval.parking.triad import RECORDS
from pyhrg.common.cli import main


def made_up(triads: int, seed: int, mission: Mission) -> Comparison:
    """Random numbers in place of flights; the first case's errors are ten times the others'."""
    generator = np.random.default_rng(seed)
    time = mission.time
    scale = np.where(np.arange(len(CASES)) == 0, 1000.0, 100.0)[:, None, None]
    heading = generator.normal(0.0, 1e-3, size=(len(CASES), triads))
    radius = generator.uniform(1, 2, size=(len(CASES), triads, 1))
    return Comparison(
        seed=seed,
        device="made up",
        mission=mission.name,
        time=time,
        radial=scale * radius * time / time[-1],
        heading=heading,
        ready=np.full((len(CASES), triads), 10.7),
        start_up=generator.normal(0.0, 1e-4, size=(len(RECORDS), triads)),
    )


@pytest.fixture
def _no_flights(monkeypatch: pytest.MonkeyPatch) -> None:
    def compare(fmu: Path, mission: Mission, triads: int, seed: int, **kwargs: Any) -> Comparison:
        return made_up(triads, seed, mission)

    monkeypatch.setattr(parking, "compare", compare)


@pytest.mark.usefixtures("_no_flights", "fmu_path")
def test_parking_writes_what_it_promises(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    for out in ("one", "two"):
        arguments = ["--seed", "3", "--hours", "0.1", "--triads", "6", "--out", str(tmp_path / out)]
        assert main(["parking", *arguments]) == 0
    document = json.loads((tmp_path / "one" / "parking.json").read_text())
    assert (document["seed"], document["n"], document["mission"]) == (3, 6, "car")
    for name, case in document["cases"].items():
        expected = 1.0 if name == "random_mean" else 0.1
        for errors in (case["final"], case["greatest"]):
            low, high = errors["ratio_interval_95"]
            assert low <= errors["ratio"] <= high
            assert expected / 2 < errors["ratio"] < expected * 2
            low, high = errors["interval_95_nmi"]
            assert low < errors["radial_error_nmi"] < high
            assert len(errors["triads_nmi"]) == 6
        assert case["greatest"]["radial_error_nmi"] >= case["final"]["radial_error_nmi"]
    text = (tmp_path / "one" / "position_error.csv").read_text()
    rows = list(csv.DictReader(text.splitlines()))
    assert len(rows) == 6
    assert {"time_s", "map_triad_006_m"} <= set(rows[0])
    assert (tmp_path / "one" / "parking.png").read_bytes().startswith(b"\x89PNG")
    for name in report.FILES:
        assert (tmp_path / "one" / name).read_bytes() == (tmp_path / "two" / name).read_bytes()
    text = capsys.readouterr().out
    assert "parked at a zero" in text
    assert "ready at most 10.7 s after power-on" in text


def test_mistake_is_one_line_and_status_2(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    out = tmp_path / "result"
    assert main(["parking", "--triads", "5", "--out", str(out)]) == 2
    error = capsys.readouterr().err
    assert error == "hrg: triads: found 5, expected a whole number from 6 to 10000\n"
    assert list(tmp_path.iterdir()) == []
