"""A study from beginning to end, or from wherever it was killed."""

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

from ins_eval.study.run import block
from ins_eval.study.run.block import Arrays, BlockWork, Made
from ins_eval.study.run.errors import StudyRunError
from ins_eval.study.run.folder import StudyFolder, claimed
from ins_eval.study.run.identity import identity
from ins_eval.study.run.workers import connected, spread
from ins_eval.study.specification import Study
from pyhrg.common.files import staging

Done = Callable[[int], None]


@dataclass(frozen=True)
class Experiment:
    """What is done with triads.

    Attributes:
        made: of a range of triads, by workers.
        conclude: what a study says, from the arrays of all its triads; writes `files` into a
            folder.
        files: in the order in which they appear; the last is the mark of a complete study.
        prepare: what workers of this machine would otherwise do each for itself.
    """

    made: Made
    conclude: Callable[[Study, Arrays, Path], None]
    files: tuple[str, ...]
    prepare: Callable[[Study], None] = lambda study: None


@dataclass(frozen=True)
class Cluster:
    """scheduler: address; None for this machine's cores. workers: how many of them then."""

    scheduler: str | None = None
    workers: int | None = None


def run(
    study: Study, out: Path, experiment: Experiment, cluster: Cluster, done: Done = lambda _: None
) -> None:
    """Run a study, or what is left of it.

    Args:
        study: what is done.
        out: folder; may hold blocks of the same study, which are not done again.
        experiment: how it is done.
        cluster: by whom; has no influence on any byte.
        done: told how many more triads are done and kept; at once, how many were before.

    Raises:
        StudyRunError: another study's folder; workers or scheduler that are lost for good.
        OSError: `out` can't be written.
    """
    with claimed(out, identity(study)) as kept:
        if all((out / name).is_file() for name in experiment.files):
            done(study.triads)
        else:
            _do_blocks(study, kept, experiment, cluster, done)
            arrays = _all_triads(study, kept)
            with staging(out, experiment.files) as folder:
                experiment.conclude(study, arrays, folder)
        kept.forget_blocks()


def _do_blocks(
    study: Study, kept: StudyFolder, experiment: Experiment, cluster: Cluster, done: Done
) -> None:
    left = [n for n in range(block.count(study)) if kept.arrays(n) is None]

    def triads(number: int) -> int:
        return len(block.triads_of(study, number))

    def keep(number: int, file: bytes) -> None:
        kept.keep(number, file)
        done(triads(number))

    done(study.triads - sum(map(triads, left)))
    if left:
        experiment.prepare(study)
        work = BlockWork(study, kept.identity, experiment.made)
        with connected(cluster.scheduler, cluster.workers) as client:
            spread(client, work, left, f"hrg-study-{kept.identity.digest}", keep)


def _all_triads(study: Study, kept: StudyFolder) -> Arrays:
    blocks = []
    for number in range(block.count(study)):
        arrays = kept.arrays(number)
        if arrays is None:
            raise StudyRunError(
                f"{kept.block(number)}: found it damaged; the same command makes it again"
            )
        blocks.append(arrays)
    return block.joined(blocks)
