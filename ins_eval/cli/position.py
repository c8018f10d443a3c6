"""`hrg position`: the gap of a diagnosis as a position error."""

import argparse
from pathlib import Path

import ins_eval
from pyhrg.common.cli import collect_given
from pyhrg.common.files import check_output_folder

HELP = "compute the position error that the gap of a diagnosis causes, in metres"


def add_options(parser: argparse.ArgumentParser) -> None:
    add = parser.add_argument
    add("diagnosis", type=Path, metavar="DIR", help="folder that hrg gap diagnose wrote")
    add("--mission", action="append", dest="missions", metavar="NAME|FILE", help="ready mission, "
        "mission TOML or recorded drive; repeatable (default car, aircraft, ship)")  # fmt: skip
    add("--hours", type=float, help="duration of the navigation (default 2)")
    add("--triads", type=int, help="number of triads, 10 or more (default 500)")
    add("--seed", type=int, help="seed of power-on angles and bootstrap intervals (default 1)")


def run(options: argparse.Namespace) -> None:
    check_output_folder(options.diagnosis)
    arguments = collect_given(options, ("missions", "hours", "triads", "seed"))
    gap = ins_eval.compute_position_gap(options.diagnosis, progress=not options.quiet, **arguments)
    gap.write(options.diagnosis)
    print("\n".join(gap.sentences))
