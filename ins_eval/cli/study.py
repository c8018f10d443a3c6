"""`hrg study`: which bench figure predicts the navigator's error?"""

import argparse
from pathlib import Path

import ins_eval
from pyhrg.common.cli import collect_given, progress_bar

HELP = (
    "bench many gyros, fly them in many manoeuvres, and say which bench figure predicts the error"
)


def add_options(parser: argparse.ArgumentParser) -> None:
    add = parser.add_argument
    add("study", metavar="STUDY", nargs="?", default="small", help="small (default), standard, "
        "wide, narrow, one-maker, or a file (TOML)")  # fmt: skip
    add("--out", type=Path, default=Path("hrg-study"), metavar="DIR", help="output folder "
        "(default hrg-study)")  # fmt: skip
    add("--seed", type=int, metavar="N", help="seed instead of the study's")
    add_cluster_options(parser)


def add_cluster_options(parser: argparse.ArgumentParser) -> None:
    """Declare the options that say who computes."""
    add = parser.add_mutually_exclusive_group().add_argument
    add("--workers", type=int, metavar="N", help="processes on this machine (default: all cores)")
    add("--scheduler", metavar="tcp://HOST:PORT", help="address of a Dask scheduler, instead of "
        "processes on this machine")  # fmt: skip


def run(options: argparse.Namespace) -> None:
    study = ins_eval.load_study(options.study, options.seed)
    for name in study.left_out:
        print(f"{name} is not here and is left out; HRG_REAL says where recorded drives are")
    with progress_bar("study", "triads") as progress:
        result = ins_eval.run_study(
            study,
            options.out,
            progress=progress,
            **collect_given(options, ("workers", "scheduler")),
        )
    print(result.verdict)
    print(f"\nwritten to {options.out}: {', '.join(result.files)}")
