"""Runs an experiment from its beginning, or from where an earlier command stopped."""

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

from ins_eval.study.run import block
from ins_eval.study.run.block import Arrays, BlockComputation, BlockWork, identify_study
from ins_eval.study.run.folder import StudyFolder, claim_folder
from ins_eval.study.run.workers import connect, run_blocks
from ins_eval.study.specification import Study
from pyhrg.common.arguments import check_whole_number
from pyhrg.common.errors import HrgError
from pyhrg.common.extras import require_extra
from pyhrg.common.files import stage_files

MOST_WORKERS = 10_000
"""Largest number of worker processes that is accepted. Chosen."""

Progress = Callable[[int, int], None]
"""Is called with the number of finished triads and the number of all."""


@dataclass(frozen=True)
class Experiment:
    """The functions of an experiment.

    Attributes:
        compute: computes the results of a range of triads, on workers.
        conclude: writes `files` into a folder, from the results of all triads.
        files: names in the order in which they appear; the last marks a complete study.
        prepare: does once what each worker of this machine would otherwise do.
    """

    compute: BlockComputation
    conclude: Callable[[Study, Arrays, Path], None]
    files: tuple[str, ...]
    prepare: Callable[[Study], None] = lambda study: None


@dataclass(frozen=True)
class Cluster:
    """Workers that compute the blocks.

    Attributes:
        scheduler: address of a Dask scheduler; None for processes of this machine.
        workers: number of these, None for all cores.
    """

    scheduler: str | None = None
    workers: int | None = None

    def __post_init__(self) -> None:
        if self.workers is not None:
            check_whole_number("workers", self.workers, 1, MOST_WORKERS)
        if self.scheduler is not None and self.workers is not None:
            raise HrgError(
                f"workers: found {self.workers}, expected none beside scheduler {self.scheduler}"
            )


def run_experiment(
    study: Study,
    out: Path,
    experiment: Experiment,
    cluster: Cluster,
    progress: Progress | None = None,
) -> None:
    """Run a study, or the part of it that is not done.

    Args:
        out: output folder; finished blocks of the same study there are not computed again.
        cluster: who computes; it has no influence on any byte.
        progress: is called whenever triads are finished, and once at the beginning.

    Raises:
        HrgError: the folder of another study; workers or scheduler that are lost for good; Dask is
            not installed.
        OSError: `out` can't be written.
    """
    with claim_folder(out, identify_study(study)) as kept:
        if all((out / name).is_file() for name in experiment.files):
            if progress:
                progress(study.triads, study.triads)
        else:
            _run_blocks(study, kept, experiment, cluster, progress)
            arrays = _join_all_blocks(study, kept)
            with stage_files(out, experiment.files) as folder:
                experiment.conclude(study, arrays, folder)
        kept.forget_blocks()


def _run_blocks(
    study: Study,
    kept: StudyFolder,
    experiment: Experiment,
    cluster: Cluster,
    progress: Progress | None,
) -> None:
    unfinished = [n for n in range(block.count_blocks(study)) if kept.load_block(n) is None]
    todo = {number: len(block.list_triads(study, number)) for number in unfinished}

    def report() -> None:
        if progress:
            progress(study.triads - sum(todo.values()), study.triads)

    def keep(number: int, file: bytes) -> None:
        kept.keep(number, file)
        del todo[number]
        report()

    report()
    if unfinished:
        require_extra("cluster")
        experiment.prepare(study)
        work = BlockWork(study, kept.identity, experiment.compute)
        with connect(cluster.scheduler, cluster.workers) as client:
            run_blocks(client, work, unfinished, f"hrg-study-{kept.identity.digest}", keep)


def _join_all_blocks(study: Study, kept: StudyFolder) -> Arrays:
    blocks = []
    for number in range(block.count_blocks(study)):
        arrays = kept.load_block(number)
        if arrays is None:
            raise HrgError(
                f"{kept.block(number)}: found it damaged; the same command makes it again"
            )
        blocks.append(arrays)
    return block.join_blocks(blocks)
