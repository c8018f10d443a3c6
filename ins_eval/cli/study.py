"""`hrg study`: does the full circumference predict the navigator's error?"""

import argparse
import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path

from tqdm import tqdm

from ins_eval.study import study_file
from ins_eval.study.run.errors import StudyRunError
from ins_eval.study.run.run import Cluster, Experiment
from ins_eval.study.run.run import run as run_blocks
from ins_eval.study.specification import Study
from pyhrg.common.errors import HrgError
from pyhrg.common.toml_table import SpecificationError

HELP = "bench gyros and fly them in manoeuvres, many of both, and say which bench figure predicts"


def add_options(parser: argparse.ArgumentParser) -> None:
    parser.add_argument(
        "study",
        metavar="STUDY",
        nargs="?",
        default="small",
        help=f"{', '.join(study_file.READY)} or a file (TOML); default small",
    )
    parser.add_argument(
        "--out", type=Path, default=Path("hrg-study"), metavar="DIR", help="output folder"
    )
    parser.add_argument("--seed", type=int, metavar="N", help="instead of the study's")
    add_cluster_options(parser)


def add_cluster_options(parser: argparse.ArgumentParser) -> None:
    """Who does the work."""
    where = parser.add_mutually_exclusive_group()
    where.add_argument(
        "--workers", type=int, metavar="N", help="processes on this machine (default: all cores)"
    )
    where.add_argument(
        "--scheduler", metavar="tcp://HOST:PORT", help="a Dask cluster's, instead of this machine"
    )


def cluster(options: argparse.Namespace) -> Cluster:
    """That the options ask for.

    Raises:
        HrgError: no number of workers.
    """
    if options.workers is not None and options.workers < 1:
        raise HrgError(f"--workers {options.workers}: expected a whole number from 1")
    return Cluster(options.scheduler, options.workers)


def run(options: argparse.Namespace) -> None:
    where = cluster(options)
    try:
        study = study_file.study(options.study, options.seed)
        for name in study.left_out:
            print(f"{name} is not here and left out; HRG_REAL says where recorded drives are")
        whole = experiment()
        perform(study, options.out, whole, where)
    except SpecificationError as error:
        raise HrgError(str(error)) from error
    print(f"written to {options.out}: {', '.join(whole.files)}")


def experiment() -> Experiment:
    """The study's own; loaded when it is wanted, so that no other command of `hrg` waits for it."""
    from ins_eval.study.conclusion import FILES, conclude
    from ins_eval.study.experiment import made, prepare

    return Experiment(made=made, conclude=conclude, files=FILES, prepare=prepare)


def perform(study: Study, out: Path, whole: Experiment, where: Cluster) -> None:
    """Run a study with a bar on stderr.

    Raises:
        HrgError: what the user can mend.
        KeyboardInterrupt: says that the same command goes on.
    """
    try:
        with _bar(study.triads) as done:
            run_blocks(study, out, whole, where, done)
    except StudyRunError as error:
        raise HrgError(str(error)) from error
    except OSError as error:
        raise HrgError(f"can't write {out}: {error.strerror or error}") from error
    except KeyboardInterrupt:
        raise KeyboardInterrupt("interrupted; the same command goes on from here") from None


@contextmanager
def _bar(total: int) -> Iterator[Callable[[int], None]]:
    layout = "{desc} {percentage:3.0f}%|{bar}| {n}/{total} triads [{elapsed}]"
    with tqdm(total=total, desc="study", bar_format=layout, file=sys.stderr) as bar:

        def done(triads: int) -> None:
            bar.update(triads)

        yield done
