"""Results that are read again: a right one of every format, and what reads it."""

import json
import tempfile
from dataclasses import asdict, replace
from pathlib import Path

import numpy as np
import pandas as pd

import ins_eval
from ins_eval.study.challenge.score_predictions import FIELDS, read_predictions
from ins_eval.study.study_data import read_study_data
from ins_eval.study.summary.text import summarize
from pyhrg.bench.bias.position import fixed_position
from pyhrg.bench.outcome import Finding, Outcome
from pyhrg.bench.reporting.result import BenchResults, TestResult, read_result
from pyhrg.challenge.roster import Folder, Settings
from pyhrg.common.pages.markup import Table
from pyhrg.gap.findings.diagnosis import write as write_diagnosis
from pyhrg.gap.findings.diagnosis_reader import read_diagnosis
from tests.fuzzing.mutations import BYTES, DOCUMENT, TABLE
from tests.fuzzing.sample import Sample
from tests.ins_eval.study.report.synthetic import synthetic
from tests.pyhrg.gap.findings.test_diagnosis import GIVEN


def _write_study_result(folder: Path) -> None:
    data = synthetic(12)
    assert data.conditions
    pd.concat([data.table, data.conditions.table]).to_parquet(folder / "study.parquet")
    scores = [
        {k: None if isinstance(v, float) and np.isnan(v) else v for k, v in asdict(s).items()}
        for s in [*data.scores, *data.conditions.scores]
    ]
    (folder / "study.json").write_text(json.dumps({**data.about, "scores": scores}))


def _read_study_result(folder: Path) -> None:
    summarize(read_study_data(folder))
    ins_eval.predict_error(folder, "car", fixed_deg_h=0.01, circumference_deg_h=0.02)


def _write_challenge(folder: Path) -> None:
    challenge = Folder(folder)
    settings = Settings({"none": 1, "single": 1}, 1, 60.0, "ideal")
    challenge.begin(settings)
    challenge.publish(settings.list_cases(), ["0" * 64] * len(settings.list_cases()))


def _read_challenge(folder: Path) -> None:
    challenge = Folder(folder)
    settings, published = challenge.read_settings(), challenge.read_hashes()
    assert {case.name for case in settings.list_cases()} | set(published)


IDENTITY = {"device": "typical", "seed": 1}
OUTCOME = Outcome(
    (
        Finding("bias stability", 1e-8, "deg/h", 5e-9, 2e-8, 7, "of seven runs"),
        Finding("random walk", np.nan, "deg/sqrt(h)", note="the records are short"),
    ),
    "The bias is stable.",
    (Table("Runs, deg/h", ("run", "mean"), (("1", "0.1"), ("2", "0.2"))),),
    ("A warning.",),
)


def write_bench_result(folder: Path) -> None:
    limits = {"bias_stability_deg_per_h": 0.01}
    TestResult(fixed_position.PROCEDURE, OUTCOME, None, IDENTITY, limits).write(folder / "test")


def _read_bench_result(folder: Path) -> None:
    """As a bench does that adds a test to what is in its folder."""
    result = read_result(folder / "test", fixed_position.PROCEDURE, IDENTITY)
    results = BenchResults("typical", [result], result.limits)
    assert str(results), results.findings
    with tempfile.TemporaryDirectory() as elsewhere:
        results.write_page(Path(elsewhere))


FLIGHTS = {(triad, mission) for triad in range(4) for mission in ("car", "ship")}


def _write_predictions(folder: Path) -> None:
    rows = [(*flight, 1.0, 2.5, 4.0) for flight in sorted(FLIGHTS)]
    pd.DataFrame(rows, columns=FIELDS).to_csv(folder / "mine.csv", index=False)


RESULTS = {
    "diagnosis": Sample(
        lambda folder: write_diagnosis(replace(GIVEN), folder),
        *("diagnosis.json", DOCUMENT),
        read_diagnosis,
    ),
    "study's result": Sample(_write_study_result, "study.json", DOCUMENT, _read_study_result),
    "study's table": Sample(_write_study_result, "study.parquet", BYTES, _read_study_result),
    "challenge's settings": Sample(_write_challenge, "settings.json", DOCUMENT, _read_challenge),
    "challenge's index": Sample(_write_challenge, "challenge.json", DOCUMENT, _read_challenge),
    "bench test's result": Sample(
        write_bench_result, "test/result.json", DOCUMENT, _read_bench_result
    ),
    "predictions": Sample(
        _write_predictions,
        *("mine.csv", TABLE),
        lambda folder: read_predictions(folder / "mine.csv", FLIGHTS),
    ),
}
"""Formats by their names."""
