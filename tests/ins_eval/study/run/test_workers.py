"""The study's own experiment, by one worker and by two: processes of their own; beside another."""

from dataclasses import replace
from pathlib import Path

from ins_eval.study.run.run import Cluster, run_experiment
from ins_eval.study.run.workers import connect
from ins_eval.study.run_study import make_experiment
from tests.ins_eval.study.run.processes import contents
from tests.ins_eval.study.test_experiment import STUDY

SMALL = replace(
    STUDY,
    triads=4,
    training=2,
    agreement=2,
    steady_agreement=2,
    lead=1,
    calibrations=("mean",),
    missions=tuple(replace(mission, hours=0.1) for mission in STUDY.missions),
)
"""Four blocks: two of training triads, two of judged ones."""


def test_same_bytes_by_any_number_of_workers(tmp_path: Path) -> None:
    for workers in (1, 2):
        run_experiment(
            SMALL, tmp_path / str(workers), make_experiment(SMALL), Cluster(workers=workers)
        )
    one, two = (contents(tmp_path / str(workers)) for workers in (1, 2))
    assert {"study.parquet", "phase_diagram.csv", "study.json", "report.html"} < set(one)
    assert one == two


def test_two_studies_run_at_once() -> None:
    """No warning of a port that is taken, which would be an error here."""
    with connect(None, 1) as one, connect(None, 1) as other:
        assert one.submit(sum, (1, 2)).result() == other.submit(sum, (1, 2)).result() == 3
