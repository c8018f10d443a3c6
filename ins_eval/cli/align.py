"""`hrg align`: attitude of a standing vehicle from a record of its IMU, with its one-sigma."""

import argparse
from pathlib import Path

from ins_eval.alignment.align import SHORTEST, align
from ins_eval.cli.flight_options import align_report, sources
from ins_eval.cli.flight_options.place import (
    FLAGS,
    add_place_options,
    place,
    refuse_options_of_logs,
)
from ins_eval.cli.flight_options.records import recorded, simulated
from ins_eval.cli.flight_options.refusals import REFUSALS
from pyhrg.common.errors import HrgError
from pyhrg.common.files import staging
from pyhrg.common.option_numbers import number, whole

HELP = "find a standing vehicle's attitude from its IMU, with one-sigma"

TRAJECTORY = "car"
"""Unless options say otherwise."""


def add_options(parser: argparse.ArgumentParser) -> None:
    add = parser.add_argument
    add("log", nargs="?", type=Path, metavar="FILE", help="recorded log of a standing vehicle; "
        "without it, an IMU is simulated on one")  # fmt: skip
    add("--imu", default="simple", metavar="NAME|FILE", help="ready IMU or IMU TOML: what is "
        "simulated, or whose errors the one-sigma of a log rests on (default simple)")  # fmt: skip
    add("--trajectory", metavar="NAME|FILE", help="where an IMU is simulated, before it sets off "
        f"(default {TRAJECTORY})")  # fmt: skip
    add("--from-s", metavar="S", help="where to begin in a log (default 0)")
    add("--seconds", metavar="S", default="300", help="of the record that are used (default 300)")
    add("--seed", metavar="N", help="of everything random (default 1)")
    add("--out", type=Path, default=Path("hrg-align"), metavar="DIR", help="output folder "
        "(default hrg-align)")  # fmt: skip
    add_place_options(parser)


def run(options: argparse.Namespace) -> None:
    seconds = number("--seconds", options.seconds, SHORTEST, 7200)
    first = number("--from-s", options.from_s or "0", 0, 1e6)
    seed = whole("--seed", options.seed or "1", 0, 2**63 - 1)
    where = place(options)
    try:
        with staging(options.out, align_report.FILES) as folder:
            imu = sources.imu(options.imu, None)
            if options.log is None:
                refuse_options_of_logs(options, ("--from-s", *FLAGS))
                record = simulated(imu, options.trajectory or TRAJECTORY, seconds, seed)
            else:
                _refuse_options_of_simulations(options)
                record = recorded(options.log, where, first, seconds)
            alignment = align(record.increments, record.position, imu.errors)
            align_report.write(record, alignment, imu.errors, folder)
    except REFUSALS as error:
        raise HrgError(str(error)) from error
    except OSError as error:
        raise HrgError(f"can't write {options.out}: {error.strerror or error}") from error
    print(align_report.summary(record, alignment))
    print(f"\nwritten to {options.out}: {', '.join(align_report.FILES)}")


def _refuse_options_of_simulations(options: argparse.Namespace) -> None:
    for flag, value in (("--trajectory", options.trajectory), ("--seed", options.seed)):
        if value is not None:
            raise HrgError(f"{flag}: is for simulated IMUs, and {options.log} is a recorded log")
