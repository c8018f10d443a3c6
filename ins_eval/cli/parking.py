"""`hrg parking`: what it buys to start level gyros' patterns where their maps say."""

import argparse
import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path

from tqdm import tqdm

from fmu_build.binaries.platforms import BuildError
from fmu_build.bundle import built_fmu
from fmu_build.equations.translate import TranslationError
from ins_eval.common.metrics import FEWEST_FOR_MEDIAN
from ins_eval.parking import report, study
from ins_eval.parking.mission import STILL, mission
from ins_eval.trajectories import catalogue
from ins_eval.trajectories.errors import TrajectoryError
from ins_eval.trajectories.trajectory import Trajectory
from pyhrg.common.errors import HrgError
from pyhrg.common.files import staging
from pyhrg.common.option_numbers import number, whole

HELP = "start level gyros' patterns where their maps say the error is least, and fly what it buys"

LONGEST_HOURS = 24.0
MARGIN = 10.0
"""Trajectories go on beyond the mission's end, so that no spline ends within it, s."""


def add_options(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("--seed", default="1", help="of everything random (default 1)")
    parser.add_argument("--hours", default="2", help="mission length (default 2)")
    parser.add_argument("--triads", default="12", help="device triads to fly (default 12)")
    parser.add_argument(
        "--trajectory",
        default="car",
        metavar="NAME|FILE",
        help="ready mission, mission (TOML) or recorded drive (CSV, may be gzipped); default car",
    )
    parser.add_argument(
        "--out", type=Path, default=Path("hrg-parking"), metavar="DIR", help="output folder"
    )


def run(options: argparse.Namespace) -> None:
    seed = whole("--seed", options.seed, 0, 2**63 - 1)
    triads = whole("--triads", options.triads, FEWEST_FOR_MEDIAN, 10_000)
    hours = _hours(options.hours)
    flying = mission(_trajectory(options.trajectory, hours * 3600 + MARGIN), hours)
    try:
        with staging(options.out, report.FILES) as folder:
            fmu = _present_fmu()
            print(f"simulating {flying.name} for {hours:g} h", file=sys.stderr)
            with _gyro_minutes(study.work(triads, flying)) as done:
                found = study.compare(fmu, flying, triads, seed, done=done)
            report.write(found, folder)
    except OSError as error:
        raise HrgError(f"can't write {options.out}: {error.strerror}") from error
    print(report.summary(found))
    print(f"\nwritten to {options.out}: {', '.join(report.FILES)}")


def _present_fmu() -> Path:
    """The FMU of the present sources, built if it isn't there.

    Raises:
        HrgError: it can't be built.
    """
    try:
        return built_fmu(lambda text: print(text, file=sys.stderr))
    except (TranslationError, BuildError) as error:
        raise HrgError(str(error)) from error
    except OSError as error:
        raise HrgError(f"can't build the FMU: {error}") from error


@contextmanager
def _gyro_minutes(total: int) -> Iterator[Callable[[int], None]]:
    """A bar of gyro time, minutes; what it gives is told how many more are done."""
    layout = "{desc} {percentage:3.0f}%|{bar}| {n}/{total} gyro minutes [{elapsed}]"
    with tqdm(total=total, desc="flights", bar_format=layout) as bar:

        def done(minutes: int) -> None:
            bar.update(minutes)

        yield done


def _trajectory(name_or_path: str, duration: float) -> Trajectory:
    try:
        return catalogue.trajectory(name_or_path, STILL, duration)
    except TrajectoryError as error:
        raise HrgError(str(error)) from error


def _hours(text: str) -> float:
    """In whole minutes."""
    hours = number("--hours", text, 0.1, LONGEST_HOURS)
    if abs(hours * 60 - round(hours * 60)) > 0.02:
        raise HrgError(f"--hours {text}: expected whole minutes")
    return round(hours * 60) / 60
