"""The study's own experiment, by two workers, processes of their own; beside another."""

from dataclasses import replace
from pathlib import Path

from ins_eval.study.run.run import Cluster, run_experiment
from ins_eval.study.run.workers import connect
from ins_eval.study.run_study import make_experiment
from tests.ins_eval.study.run.processes import contents, undisturbed
from tests.ins_eval.study.test_experiment import STUDY

SMALL = replace(
    STUDY,
    triads=3,
    training=1,
    agreement=1,
    steady_agreement=1,
    calibrations=("mean",),
    missions=(replace(STUDY.missions[0], hours=0.1),),
)
"""Three blocks: one of a training triad, two of judged ones."""


def test_two_workers_write_the_bytes_of_none(tmp_path: Path) -> None:
    run_experiment(SMALL, tmp_path / "two", make_experiment(SMALL), Cluster(workers=2))
    two = contents(tmp_path / "two")
    assert {"study.parquet", "phase_diagram.csv", "study.json", "report.html"} < set(two)
    assert two == undisturbed(SMALL, make_experiment(SMALL), tmp_path / "none")


def test_two_studies_run_at_once() -> None:
    """No warning of a port that is taken, which would be an error here."""
    with connect(None, 1) as one, connect(None, 1) as other:
        assert one.submit(sum, (1, 2)).result() == other.submit(sum, (1, 2)).result() == 3
