"""`hrg nav`: an IMU's path along a trajectory, with its position error and the causes."""

from __future__ import annotations

import argparse
from pathlib import Path

import ins_eval
from pyhrg.common.cli import collect_given, refuse
from pyhrg.common.files import check_output_folder
from pyhrg.common.progress import Progress

PLACE = ("latitude_deg", "longitude_deg", "height_m")


def add_place_options(parser: argparse.ArgumentParser) -> None:
    """Declare `--latitude-deg`, `--longitude-deg`, `--height-m`."""
    group = parser.add_argument_group("place where a log was recorded, unless the log states it")
    add = group.add_argument
    add("--latitude-deg", type=float, metavar="DEG", help="geodetic latitude")
    add("--longitude-deg", type=float, metavar="DEG", help="longitude (default 0)")
    add("--height-m", type=float, metavar="M", help="height above the ellipsoid (default 0)")


HELP = "fly an IMU along a trajectory, and compute its position error and the causes"
OF_SIMULATIONS = ("fmu", "rate_hz", "seed", "runs")
OF_LOGS = ("errors_of", *PLACE)
OF_BOTH = ("hours", "samples", "height", "align_s", "out", "force")


def add_options(parser: argparse.ArgumentParser) -> None:
    add = parser.add_argument
    add("--trajectory", metavar="NAME|FILE", help="ready mission, mission TOML or recorded drive "
        "(CSV, may be gzipped; default car); for a log, its true motion: none (default), rest, or "
        "a recorded drive that begins with the log")  # fmt: skip
    add("--imu", default="simple", metavar="NAME|FILE", help="ready IMU, IMU TOML, or recorded log "
        "(default simple)")  # fmt: skip
    add("--fmu", type=Path, metavar="FILE", help="FMU of your own gyro class (hrg build --class) "
        "or closed.fmu of a diagnosis; it simulates the gyros with the parameters of the IMU's "
        "device")  # fmt: skip
    add("--errors-of", metavar="NAME|FILE", help="ready IMU or IMU TOML that states the errors of "
        "a log's IMU, for its alignment (default simple)")  # fmt: skip
    add("--out", type=Path, default=Path("hrg-nav"), metavar="DIR", help="output folder "
        "(default hrg-nav)")  # fmt: skip
    add("--hours", type=float, metavar="H", help="duration, whole minutes (default 1; for a log, "
        "its length)")  # fmt: skip
    add("--rate-hz", type=int, metavar="HZ", help="rate of increments, 10 to 2000 (default: the "
        "IMU's)")  # fmt: skip
    add("--samples", type=int, metavar="N", help="increments a navigation step, 2 to 4 (default 2)")
    add("--height", choices=("clamped", "free", "baro"), help="clamped to the true "
        "height, free, or held by a loop with the true height (default clamped)")  # fmt: skip
    start = parser.add_mutually_exclusive_group()
    start.add_argument("--align-s", type=float, metavar="S", help="time from power-on to the "
                       "start, alignment included (default 300)")  # fmt: skip
    start.add_argument(
        "--start-from-truth", action="store_true", help="start with the true attitude, not aligned"
    )
    add("--seed", type=int, metavar="N", help="seed of all random numbers (default 1)")
    add(
        "--runs",
        type=int,
        metavar="N",
        help="number of flights, each with an IMU of its own (default 1)",
    )
    add("--force", action="store_true", help="replace another flight in the output folder")
    add_place_options(parser)


def run(options: argparse.Namespace) -> None:
    check_output_folder(options.out)
    is_log = Path(options.imu).suffix not in ("", ".toml")
    flight = _fly_log(options) if is_log else _fly(options)
    print(flight.summary)
    print(f"\nwritten to {options.out}: {', '.join(flight.files)}")


def _fly(options: argparse.Namespace) -> ins_eval.Flight:
    refuse(options, OF_LOGS, "is for recorded logs, and the IMU is simulated")
    arguments = collect_given(options, (*OF_SIMULATIONS, *OF_BOTH))
    if options.start_from_truth:
        arguments["align_s"] = None
    with Progress(not options.quiet, "navigation", "flights") as progress:
        return ins_eval.fly(
            options.trajectory or "car", options.imu, progress=progress.update, **arguments
        )


def _fly_log(options: argparse.Namespace) -> ins_eval.Flight:
    reason = f"is for simulated IMUs, and {Path(options.imu).name} is a recorded one"
    refuse(options, (*OF_SIMULATIONS, "start_from_truth"), reason)
    truth = options.trajectory or "none"
    arguments = collect_given(options, (*OF_BOTH, *OF_LOGS))
    return ins_eval.fly_log(options.imu, truth=truth, **arguments)
