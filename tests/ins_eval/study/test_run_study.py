"""The front door of the study: its result as tables, words and a figure; what it refuses."""

import json
from dataclasses import asdict, replace
from pathlib import Path

import numpy as np
import pandas as pd
import pytest

from ins_eval.study import run_study as front_door
from ins_eval.study.run_study import StudyResult, run_study
from ins_eval.study.tables import columns as c
from pyhrg.common.errors import HrgError
from tests.ins_eval.study import cases
from tests.ins_eval.study.report.synthetic import CONDITIONS, synthetic
from tests.ins_eval.study.run.cheap import CHEAP


@pytest.fixture(scope="module")
def result(tmp_path_factory: pytest.TempPathFactory) -> StudyResult:
    """A made-up study of several missions and two calibrations."""
    folder: Path = tmp_path_factory.mktemp("study")
    data = synthetic(12)
    assert data.conditions
    table = pd.concat([data.table, data.conditions.table])
    table.to_parquet(folder / "study.parquet")
    scores = [
        {k: None if isinstance(v, float) and np.isnan(v) else v for k, v in asdict(s).items()}
        for s in [*data.scores, *data.conditions.scores]
    ]
    (folder / "study.json").write_text(json.dumps({**data.about, "scores": scores}))
    return StudyResult(folder, ("study.parquet", "study.json"))


def test_table_has_all_rows_and_units(result: StudyResult) -> None:
    table = result.table
    assert len(table) == len(pd.read_parquet(result.folder / "study.parquet"))
    assert set(CONDITIONS) < set(table[c.CLASS])
    assert table.attrs["units"][c.FLOWN_RADIAL] == "m"


def test_scores_are_a_row_each(result: StudyResult) -> None:
    document = json.loads((result.folder / "study.json").read_text())
    assert len(result.scores) == len(document["scores"])
    assert {"score", "value", "low", "high", "n"} < set(result.scores.columns)


def test_verdict_is_of_each_calibration(result: StudyResult) -> None:
    lines = result.verdict.splitlines()
    assert {"Mean calibrated:", "Whole map calibrated:"} < set(lines)
    for letter in "abc":
        assert sum(line.startswith(f"({letter}) ") for line in lines) == 2
    (line,) = (each for each in lines if each.startswith("    self-calibrated "))
    assert "(b) fails" in line
    assert result.summary.endswith(result.verdict)
    assert result.summary.startswith("The gyro of the paper's Table 2, its mean over the")


def test_plot_is_of_one_calibration(result: StudyResult) -> None:
    axes = result.plot()
    assert axes is result.plot(axes, calibration="map")
    legend = axes.get_legend()
    assert legend
    assert any(text.get_text().startswith("fitted map") for text in legend.get_texts())
    with pytest.raises(HrgError, match="calibration: found 'best', expected 'mean' or 'map'"):
        result.plot(calibration="best")


def test_arguments_are_checked(tmp_path: Path) -> None:
    with pytest.raises(HrgError, match="huge: found no such file"):
        run_study("huge", tmp_path)
    with pytest.raises(HrgError, match="seed: found -1, expected a whole number from 0"):
        run_study(cases.study(), tmp_path, seed=-1)
    with pytest.raises(HrgError, match="workers: found 0, expected a whole number from 1"):
        run_study(cases.study(), tmp_path, workers=0)
    with pytest.raises(
        HrgError, match="workers: found 2, expected none beside scheduler tcp://a:1"
    ):
        run_study(cases.study(), tmp_path, workers=2, scheduler="tcp://a:1")
    assert list(tmp_path.iterdir()) == []


def test_interruption_says_how_to_go_on(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def interrupt(*_: object) -> None:
        raise KeyboardInterrupt

    monkeypatch.setattr(
        front_door, "make_experiment", lambda study: replace(CHEAP, prepare=interrupt)
    )
    with pytest.raises(KeyboardInterrupt, match="the same command goes on from here"):
        run_study(cases.study(), tmp_path / "out", seed=4)
