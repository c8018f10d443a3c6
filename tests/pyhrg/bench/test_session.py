"""The bench's front door, with short tests in the place of the real ones."""

import json
import math
from dataclasses import replace
from pathlib import Path

import numpy as np
import pandas as pd
import pytest
from matplotlib.figure import Figure

from pyhrg.bench import catalogue
from pyhrg.bench.outcome import BenchError
from pyhrg.bench.reporting.result import COLUMNS, TestResult
from pyhrg.bench.session import list_tests, run_test, run_tests
from pyhrg.common.errors import HrgError
from pyhrg.common.units import DEG_PER_H
from pyhrg.device.ready_devices import TYPICAL
from tests.pyhrg.bench.quick import PROCEDURES, RUNS

LIMITED = replace(TYPICAL, specification={"bias_stability_deg_per_h": 1.0})


@pytest.fixture(autouse=True)
def _short_tests(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(catalogue, "PROCEDURES", PROCEDURES)


@pytest.fixture(scope="module")
def result() -> TestResult:
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(catalogue, "PROCEDURES", PROCEDURES)
        return run_test("fixed-position", LIMITED, seed=7)


def test_tests_are_listed() -> None:
    tests = list_tests()
    assert list(tests.columns) == ["name", "group", "title", "reads", "plan"]
    assert list(tests["name"]) == [procedure.name for procedure in PROCEDURES]
    assert list(tests["reads"]) == ["static", "positions"]
    assert tests["plan"].iloc[1] == "positions, spacing_deg, dwell_s, runs"


def test_findings_are_those_of_the_file(result: TestResult, tmp_path: Path) -> None:
    result.write(tmp_path / "out")
    document = json.loads((tmp_path / "out" / "result.json").read_text())
    findings = result.findings
    assert tuple(findings.columns) == COLUMNS
    assert list(findings.index) == list(document["findings"])
    for key, finding in document["findings"].items():
        row = findings.loc[key]
        assert row["value"] == finding["value"]
        assert [row["low_95"], row["high_95"]] == finding["interval_95"]
    stability = findings.loc["bias_stability_deg_per_h"]
    assert stability["unit"] == "deg/h"
    assert (stability["target"], stability["verdict"]) == (1.0, "meets")
    other = findings.loc["bias_deg_per_h"]
    assert math.isnan(other["target"])
    assert other["verdict"] == ""
    assert result.verdict == document["verdict"]
    assert document["seed"] == 7
    assert {path.suffix for path in (tmp_path / "out").iterdir()} == {".json", ".png", ".gz"}


def test_a_finding_is_in_the_unit_that_it_names(result: TestResult) -> None:
    for finding, (_, row) in zip(result.outcome.findings, result.findings.iterrows(), strict=True):
        assert finding.unit == "deg/h"
        assert finding.value == row["value"]
        assert finding.interval == (row["low_95"], row["high_95"])
        assert finding.si_value == pytest.approx(finding.value * DEG_PER_H, rel=1e-15, abs=0.0)


def test_rows_are_numbers(result: TestResult) -> None:
    rows = result.rows
    assert list(rows.columns) == ["run", "mean", "std. dev."]
    assert len(rows) == RUNS
    assert rows["mean"].mean() == pytest.approx(result.findings["value"].iloc[0], abs=1e-5)
    assert rows.attrs["title"] == "Runs, deg/h"


def test_points_are_those_of_the_figure(result: TestResult) -> None:
    points = result.points
    assert list(points.attrs["units"]) == list(points.columns)
    assert points["run"].nunique() == RUNS
    runs = points.groupby("run")["bias_deg_per_h"]
    assert runs.mean().tolist() == pytest.approx(result.rows["mean"].tolist(), abs=1e-5)
    within = points.groupby(["run", "position"])["bias_deg_per_h"].var(ddof=1).mean()
    assert points["sigma_deg_per_h"].iloc[0] == pytest.approx(within**0.5, rel=1e-9, nan_ok=True)


def test_plot_draws_on_a_figure_of_its_own_or_in_a_grid(result: TestResult) -> None:
    (axes,) = result.plot()
    assert axes.get_ylabel() == "bias, deg/h"
    grid = Figure().subplots(1, 2)
    (part,) = result.plot(grid[1])
    assert part.get_ylabel() == "bias, deg/h"
    assert part.get_figure(root=True) is grid[0].get_figure()
    outside = Figure().add_axes((0.1, 0.1, 0.8, 0.8))
    with pytest.raises(HrgError, match=r"ax: found axes outside a grid, expected axes of plt\.sub"):
        result.plot(outside)


def test_what_is_no_result_is_not_replaced(result: TestResult, tmp_path: Path) -> None:
    (tmp_path / "thesis.tex").write_text("mine")
    with pytest.raises(HrgError, match="found what is no result of a bench test"):
        result.write(tmp_path)
    (tmp_path / "empty").mkdir()
    result.write(tmp_path / "empty")
    result.write(tmp_path / "empty")


def test_a_campaign_gives_what_its_simulation_gave(result: TestResult) -> None:
    again = run_test("fixed-position", campaign=result.records)
    assert again.seed is None
    columns = ["value", "low_95", "high_95"]
    pd.testing.assert_frame_equal(again.findings[columns], result.findings[columns])


def test_records_of_a_device_without_a_name_read_back(tmp_path: Path) -> None:
    run_test("fixed-position", replace(TYPICAL, name=""), out=tmp_path)
    again = run_test("fixed-position", campaign=tmp_path / "fixed-position")
    assert again.records.device == "gyro without a name"


def test_output_folder_holds_what_write_writes(tmp_path: Path) -> None:
    results = run_tests(None, LIMITED, seed=7, out=tmp_path / "run")
    results.write(tmp_path / "written")
    made, again = (
        {path.relative_to(folder): path.read_bytes() for path in folder.rglob("*.*")}
        for folder in (tmp_path / "run", tmp_path / "written")
    )
    texts = [path for path in made if path.suffix in (".json", ".html", ".png")]
    assert set(made) == set(again)
    assert all(made[path] == again[path] for path in texts)
    assert list(results.findings.index.names) == ["test", "key"]
    table = results.parameter_system.set_index("")
    assert table.loc["bias stability, room temperature (常温零偏稳定性)", "unit"] == "deg/h"


def test_a_failure_of_several_is_listed_and_a_single_one_raised() -> None:
    def fail(campaign: object) -> None:
        raise BenchError("no figures today")

    broken = replace(PROCEDURES[0], name="broken", evaluate=fail)
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(catalogue, "PROCEDURES", (*PROCEDURES, broken))
        results = run_tests(["fixed-position", "broken"], TYPICAL)
        assert results.failures == {"broken": "no figures today"}
        assert [result.name for result in results.results] == ["fixed-position"]
        with pytest.raises(HrgError, match="broken: no result; no figures today"):
            results["broken"]
        with pytest.raises(BenchError, match="no figures today"):
            run_test("broken", TYPICAL)


def test_progress_is_shown_only_when_asked(capsys: pytest.CaptureFixture[str]) -> None:
    lines: list[str] = []
    run_test("fixed-position", TYPICAL, progress=lines.append)
    run_test("fixed-position", TYPICAL)
    assert capsys.readouterr() == ("", "")
    assert lines[0].startswith("FMU HRGSlow: ")
    assert lines[-1].startswith(f"fixed-position: {RUNS} power-ons, ")


@pytest.mark.parametrize(
    ("name", "arguments", "message"),
    [
        ("fixed-positoin", {}, "test: found 'fixed-positoin', expected fixed-position"),
        ("fixed-position", {"seed": -1}, "seed: found -1, expected a whole number from 0 to 2"),
        ("fixed-position", {"workers": 0}, "workers: found 0, expected a whole number from 1"),
        ("fixed-position", {"campaign": "x"}, "device, campaign: found both, expected one gyro"),
        (
            "fixed-position",
            {"runs": 3},
            "runs: found 3, expected only with the simulated test full-",
        ),
        ("fixed-position", {"rnus": 3}, "rnus: found 3, expected no such argument"),
        ("full-circumference", {"runs": 1.5}, "runs: found 1.5, expected a whole number"),
        ("full-circumference", {"dwell_s": "long"}, "dwell_s: found 'long', expected a number"),
        ("full-circumference", {"dwell_s": math.inf}, "dwell_s: found inf, expected a finite"),
        ("full-circumference", {"dwell_s": math.nan}, "dwell_s: found nan, expected a finite"),
        ("fixed-position", {"seed": 1.5}, "seed: found 1.5, expected a whole number"),
    ],
)
def test_mistakes_name_the_argument(name: str, arguments: dict[str, object], message: str) -> None:
    with pytest.raises(HrgError, match=message):
        run_test(name, TYPICAL, **arguments)  # type: ignore[arg-type]


def test_a_device_with_an_unknown_parameter_is_refused() -> None:
    device = replace(TYPICAL, name="mine", model={"pickOff.fullScael": 1.0})
    expected = "mine: model.pickOff.fullScael: found an unknown key, expected model.pickOff.fullSc"
    with pytest.raises(HrgError, match=expected):
        run_test("fixed-position", device)


def test_same_seed_same_findings_on_any_number_of_workers(result: TestResult) -> None:
    again = run_test("fixed-position", LIMITED, seed=7, workers=1)
    assert np.array_equal(again.findings["value"], result.findings["value"])
