"""`hrg validate`: the small study, its lead case and its verdict."""

import argparse
from pathlib import Path

import ins_eval
from ins_eval.cli.study import add_cluster_options, tell_files
from pyhrg.common.cli import collect_given
from pyhrg.common.files import check_output_folder
from pyhrg.common.progress import Progress

HELP = "bench gyros, fly triads of them, and say which bench test predicts the position error"
OPTIONS = ("seed", "hours", "triads", "calibration", "trajectory", "workers", "scheduler")


def add_options(parser: argparse.ArgumentParser) -> None:
    add = parser.add_argument
    add("--seed", type=int, metavar="N", help="seed of all random numbers (default 1)")
    add("--hours", type=float, metavar="H", help="duration of the missions (default 1)")
    add("--triads", type=int, metavar="N", help="triads that are judged (default 40)")
    add("--calibration", choices=("mean", "map"), help="what the maker calibrates (default mean)")
    add("--trajectory", metavar="NAME|FILE", help="mission beside the car: a ready one, a mission "
        "(TOML) or a recorded drive (CSV, may be gzipped) (default aircraft)")  # fmt: skip
    add("--out", type=Path, default=Path("hrg-validation"), metavar="DIR", help="output folder "
        "(default hrg-validation)")  # fmt: skip
    add_cluster_options(parser)


def run(options: argparse.Namespace) -> None:
    check_output_folder(options.out)
    with Progress(not options.quiet, "study", "triads") as progress:
        result = ins_eval.validate(
            options.out, progress=progress.update, **collect_given(options, OPTIONS)
        )
    print(result.summary)
    tell_files(options.out, result.files)
