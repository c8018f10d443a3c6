"""`hrg parking`: the gain of starting level gyros' patterns where their bias is known."""

import argparse
from pathlib import Path

import ins_eval
from pyhrg.common.cli import collect_given
from pyhrg.common.files import check_output_folder
from pyhrg.common.progress import Progress

HELP = "fly triads with and without parking: starting level gyros where their bias is known"


def add_options(parser: argparse.ArgumentParser) -> None:
    add = parser.add_argument
    add("--seed", type=int, help="seed of all random numbers (default 1)")
    add("--hours", type=float, help="duration of the mission (default 2)")
    add("--triads", type=int, help="number of triads to fly (default 12)")
    add("--trajectory", metavar="NAME|FILE", help="ready mission, mission (TOML) or recorded drive "
        "(CSV, may be gzipped); default car")  # fmt: skip
    add("--out", type=Path, default=Path("hrg-parking"), metavar="DIR", help="output folder")


def run(options: argparse.Namespace) -> None:
    check_output_folder(options.out)
    arguments = collect_given(options, ("seed", "hours", "triads", "trajectory"))
    with Progress(not options.quiet, "flights", "gyro minutes") as progress:
        comparison = ins_eval.compare_parking(progress=progress.update, **arguments)
    comparison.write(options.out)
    print(comparison.summary)
    print(f"\nwritten to {options.out}: {', '.join(comparison.files)}")
