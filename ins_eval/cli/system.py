"""`hrg system`: a mission, gyros, accelerometers and navigator as an SSP."""

import argparse
from pathlib import Path

import fmu_build
import ins_eval
from pyhrg.common.cli import collect_given
from pyhrg.common.files import check_output_folder
from pyhrg.common.progress import Progress

HELP = "write an inertial navigation system of FMUs as an SSP"
GIVEN = ("hours", "rate_hz", "height", "seed", "ssp")


def add_options(parser: argparse.ArgumentParser) -> None:
    add = parser.add_argument
    add("--trajectory", default="car", metavar="NAME|FILE", help="ready mission, mission TOML or "
        "recorded drive (CSV, may be gzipped) (default car)")  # fmt: skip
    add("--imu", default="typical-hrg", metavar="NAME|FILE", help="ready IMU or IMU TOML whose "
        "gyros are of a device (default typical-hrg)")  # fmt: skip
    add(
        "--hours",
        type=float,
        metavar="H",
        help="duration of the mission, in whole minutes (default 1)",
    )
    add("--rate-hz", type=int, metavar="HZ", help="rate of increments and communication "
        "steps, 10 to 1000 (default: the IMU's)")  # fmt: skip
    add("--height", choices=("clamped", "free", "baro"), help="clamped to the true "
        "height, free, or held by a loop with the true height (default clamped)")  # fmt: skip
    add("--seed", type=int, metavar="N", help="seed of all random numbers (default 1)")
    add("--ssp", choices=("1.0", "2.0"), help="version of the standard (default 1.0)")
    add("--platform", action="append", choices=(*fmu_build.PLATFORMS, "all"), default=[],
        help="platform to compile for; repeatable (default: this machine's)")  # fmt: skip
    add("--out", type=Path, default=Path("system.ssp"), metavar="FILE", help="file to write "
        "(default system.ssp)")  # fmt: skip


def run(options: argparse.Namespace) -> None:
    check_output_folder(options.out.parent)
    path = ins_eval.write_system(
        options.out,
        options.trajectory,
        options.imu,
        platforms=options.platform,
        progress=Progress(not options.quiet).say,
        **collect_given(options, GIVEN),
    )
    print(path)
