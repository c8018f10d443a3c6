"""`hrg nav`: an IMU's way along a trajectory, and how far it goes astray."""

import argparse
import sys
from pathlib import Path

from tqdm import tqdm

from ins_eval.cli.flight_options import place, plans, sources
from ins_eval.cli.flight_options.refusals import REFUSALS
from ins_eval.flights import report
from ins_eval.flights.experiment import experiment
from ins_eval.flights.flown import Flown
from ins_eval.flights.log_flight import fly_log
from ins_eval.flights.truth import still
from ins_eval.trajectories import catalogue
from ins_eval.trajectories.errors import MovingStartError
from pyhrg.common.errors import HrgError
from pyhrg.common.files import staging

HELP = "fly an IMU along a trajectory, and say how far it goes astray"

TRAJECTORY, IMU = "car", "simple"
"""Unless options say otherwise."""


def add_options(parser: argparse.ArgumentParser) -> None:
    add = parser.add_argument
    add("--trajectory", metavar="NAME|FILE", help="ready mission, mission TOML or recorded drive "
        f"(CSV, may be gzipped) (default {TRAJECTORY}); of a log its truth: {sources.NONE} "
        f"(default), {sources.REST}, or a recorded drive that begins with it")  # fmt: skip
    add("--imu", default=IMU, metavar="NAME|FILE", help="ready IMU, IMU TOML, or recorded log "
        f"(default {IMU})")  # fmt: skip
    add("--errors-of", metavar="NAME|FILE", help="ready IMU or IMU TOML: the errors that alignment "
        f"believes of a log (default {IMU})")  # fmt: skip
    add("--out", type=Path, default=Path("hrg-nav"), metavar="DIR", help="output folder "
        "(default hrg-nav)")  # fmt: skip
    plans.add_options(parser)
    place.add_place_options(parser)


def run(options: argparse.Namespace) -> None:
    recorded = sources.is_log(options.imu)
    names = report.files(
        truth=not recorded or sources.has_truth(options.trajectory), simulated=not recorded
    )
    try:
        with staging(options.out, names) as folder:
            flown = _of_log(options) if recorded else _simulated(options)
            report.write(flown, folder, names)
    except REFUSALS as error:
        raise HrgError(str(error)) from error
    except OSError as error:
        raise HrgError(f"can't write {options.out}: {error.strerror or error}") from error
    print(report.summary(flown))
    print(f"\nwritten to {options.out}: {', '.join(names)}")


def _simulated(options: argparse.Namespace) -> Flown:
    place.refuse_options_of_logs(options, ("--errors-of", *place.FLAGS))
    imu = sources.imu(options.imu, plans.rate(options))
    asked = plans.of_simulation(options, imu.interval)
    _, zero = still(asked.alignment, asked.interval)
    path = options.trajectory or TRAJECTORY
    try:
        trajectory = catalogue.trajectory(path, zero * asked.interval, asked.duration)
    except MovingStartError as error:
        raise HrgError(f"{error}; or --start-from-truth") from error
    layout = "{desc} {percentage:3.0f}%|{bar}| {n}/{total} flights [{elapsed}]"
    total = asked.runs + 1
    with tqdm(total=total, desc="navigation", bar_format=layout, delay=2, file=sys.stderr) as bar:
        return experiment(asked, trajectory, imu, bar.update)


def _of_log(options: argparse.Namespace) -> Flown:
    path = Path(options.imu)
    record, position = sources.log(path, place.place(options))
    asked = plans.of_log(options, path.name, record.increments)
    name = options.trajectory or sources.NONE
    first = -(asked.alignment or 0.0)
    reference = sources.reference(name, position, first, asked.duration)
    errors = sources.imu(options.errors_of or IMU, None).errors
    return fly_log(asked, path.name, record.increments, position, errors, reference)
