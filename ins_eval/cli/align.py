"""`hrg align`: attitude of a standing vehicle from a record of its IMU, with its one-sigma."""

import argparse
from pathlib import Path

import ins_eval
from ins_eval.cli.nav import PLACE, add_place_options
from pyhrg.common.cli import collect_given, refuse
from pyhrg.common.files import check_output_folder

HELP = "find a standing vehicle's attitude from its IMU, with one-sigma"
OF_SIMULATIONS = ("trajectory", "seed")
OF_LOGS = ("from_s", *PLACE)


def add_options(parser: argparse.ArgumentParser) -> None:
    add = parser.add_argument
    add("log", nargs="?", type=Path, metavar="FILE", help="recorded log of a standing vehicle; "
        "without it, an IMU is simulated on one")  # fmt: skip
    add("--imu", default="simple", metavar="NAME|FILE", help="ready IMU or IMU TOML to "
        "simulate; for a log, its biases are assumed and its noise is the prior "
        "(default simple)")  # fmt: skip
    add("--trajectory", metavar="NAME|FILE", help="mission before whose start an IMU is simulated "
        "(default car)")  # fmt: skip
    add(
        "--from-s",
        type=float,
        metavar="S",
        help="time in a log at which the record begins (default 0)",
    )
    add("--seconds", type=float, metavar="S", help="duration of the record (default 300)")
    add("--seed", type=int, metavar="N", help="seed of all random numbers (default 1)")
    add("--out", type=Path, default=Path("hrg-align"), metavar="DIR", help="output folder "
        "(default hrg-align)")  # fmt: skip
    add_place_options(parser)


def run(options: argparse.Namespace) -> None:
    check_output_folder(options.out)
    if options.log is None:
        refuse(options, OF_LOGS, "is for recorded logs, and the IMU is simulated")
    else:
        refuse(options, OF_SIMULATIONS, f"is for simulated IMUs, and {options.log} is recorded")
    names = ("seconds", *OF_SIMULATIONS, *OF_LOGS)
    aligned = ins_eval.align(options.log, imu=options.imu, **collect_given(options, names))
    aligned.write(options.out)
    print(aligned.summary)
    print(f"\nwritten to {options.out}: {', '.join(aligned.files)}")
