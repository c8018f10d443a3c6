"""The front door of the study: run one, and read its result. What takes seconds to import is
imported where it is needed."""

from __future__ import annotations

from dataclasses import asdict, dataclass, replace
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING

import pandas as pd

from ins_eval.study.run.run import Cluster, Experiment, Progress, run_experiment
from ins_eval.study.specification import Study
from ins_eval.study.study_data import StudyData, read_study_data
from ins_eval.study.study_file import load_study
from ins_eval.study.summary.text import state_verdict, summarize
from ins_eval.study.tables.columns import COLUMNS
from pyhrg.common.arguments import check_seed
from pyhrg.common.errors import HrgError, describe_briefly

if TYPE_CHECKING:
    from matplotlib.axes import Axes


@dataclass(frozen=True)
class StudyResult:
    """A finished study.

    Attributes:
        folder: folder of its files.
        files: names of the files.
    """

    folder: Path
    files: tuple[str, ...]

    __repr__ = describe_briefly

    @cached_property
    def _data(self) -> StudyData:
        return read_study_data(self.folder)

    @property
    def table(self) -> pd.DataFrame:
        """A row for each triad, calibration and mission, the conditions' rows included.
        `attrs["units"]` has the unit of each column."""
        parts = [self._data.table]
        if self._data.conditions:
            parts.append(self._data.conditions.table)
        table = pd.concat(parts).sort_index()
        table.attrs["units"] = {column.name: column.unit for column in COLUMNS}
        return table

    @property
    def scores(self) -> pd.DataFrame:
        """A row for each score, with its interval and requirement (`tables.score.Score`)."""
        conditions = self._data.conditions.scores if self._data.conditions else []
        return pd.DataFrame([asdict(score) for score in [*self._data.scores, *conditions]])

    @property
    def verdict(self) -> str:
        """Each claim with its verdict, its number of triads and the figures that decide it, with
        intervals; its verdict in other conditions."""
        return state_verdict(self._data)

    @property
    def summary(self) -> str:
        """The paper's gyro, predicted and flown errors of each mission, and the verdict, as
        text."""
        return summarize(self._data)

    def plot(self, ax: Axes | None = None, calibration: str | None = None) -> Axes:
        """Draw flown against predicted error of the judged triads, on logarithmic axes in nmi.

        Args:
            ax: axes to draw on; new ones if None.
            calibration: "mean" or "map"; the study's first if None.

        Raises:
            HrgError: the study has no such calibration.
        """
        from matplotlib.figure import Figure

        from ins_eval.study.summary.figure import draw_scatter

        known = self._data.calibrations
        chosen = calibration or known[0]
        if chosen not in known:
            raise HrgError(
                f"calibration: found {chosen!r}, expected {' or '.join(map(repr, known))}"
            )
        axes = ax if ax is not None else Figure(layout="constrained").subplots()
        draw_scatter(axes, self._data, chosen)
        return axes


def run_study(
    study: Study | Path | str,
    out: Path | str,
    *,
    seed: int | None = None,
    workers: int | None = None,
    scheduler: str | None = None,
    progress: Progress | None = None,
) -> StudyResult:
    """Run a study, or its unfinished part, and return its result.

    Finished blocks of triads are kept in `out`, so that the same call continues an interrupted
    study. The result does not depend on the number of workers.

    Args:
        study: a study, the name of one that comes with the package, or a file (TOML).
        out: output folder; new, empty, or of the same study.
        seed: seed instead of the study's.
        workers: number of processes on this machine; all cores if None.
        scheduler: address of a Dask scheduler, instead of processes on this machine.
        progress: function that is called with the number of finished triads and the number of all.

    Raises:
        HrgError: the study's file can't be used; `out` holds something else; an argument is out of
            range; workers or scheduler are lost.
        OSError: `out` can't be written.
    """
    if not isinstance(study, Study):
        study = load_study(study, seed)
    elif seed is not None:
        study = replace(study, seed=check_seed(seed))
    return run_to_result(
        study, Path(out), make_experiment(study), Cluster(scheduler, workers), progress
    )


def make_experiment(study: Study) -> Experiment:
    from ins_eval.study import experiment
    from ins_eval.study.conclusion import list_files, write_conclusion

    return Experiment(
        compute=experiment.compute_block,
        conclude=write_conclusion,
        files=list_files(study),
        prepare=experiment.prepare,
    )


def run_to_result(
    study: Study, out: Path, own: Experiment, cluster: Cluster, progress: Progress | None
) -> StudyResult:
    """The result of an experiment; arguments as `run_experiment`.

    Raises:
        KeyboardInterrupt: interrupted; the message says how to continue.
    """
    try:
        run_experiment(study, out, own, cluster, progress)
    except KeyboardInterrupt:
        raise KeyboardInterrupt("interrupted; the same command goes on from here") from None
    return StudyResult(out, own.files)
