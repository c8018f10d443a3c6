"""Options that experiments on missions share: read, checked, and told what is wrong with them."""

import argparse
import math
import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path

from tqdm import tqdm

from fmu_build.bundle import built_fmu
from fmu_build.cli import UserError
from fmu_build.platforms import BuildError
from fmu_build.translate import TranslationError
from ins_eval.command_line import whole
from ins_eval.metrics import FEWEST_FOR_MEDIAN
from ins_eval.trajectories import catalogue
from ins_eval.trajectories.errors import TrajectoryError
from ins_eval.trajectories.trajectory import Trajectory
from ins_eval.validation.mission import STILL, Mission, mission

LONGEST_HOURS = 24.0
MARGIN = 10.0
"""Trajectories go on beyond the mission's end, so that no spline ends within it, s."""


def add_options(parser: argparse.ArgumentParser, out: str, triads: int) -> None:
    """Those of `hrg validate`, with a default folder and number of triads."""
    parser.add_argument("--seed", default="1", help="of everything random (default 1)")
    parser.add_argument("--hours", default="2", help="mission length (default 2)")
    parser.add_argument(
        "--triads", default=str(triads), help=f"device triads to fly (default {triads})"
    )
    parser.add_argument(
        "--trajectory",
        default="car",
        metavar="NAME|FILE",
        help="ready mission, mission (TOML) or recorded drive (CSV, may be gzipped); default car",
    )
    parser.add_argument("--out", type=Path, default=Path(out), metavar="DIR", help="output folder")


def seed_and_triads(options: argparse.Namespace) -> tuple[int, int]:
    """Checked.

    Raises:
        UserError: no such whole number.
    """
    seed = whole("--seed", options.seed, 0, 2**63 - 1)
    return seed, whole("--triads", options.triads, FEWEST_FOR_MEDIAN, 10_000)


def chosen_mission(options: argparse.Namespace) -> Mission:
    """The mission that `--hours` and `--trajectory` ask for.

    Raises:
        UserError: no such length, or no such drive.
    """
    hours = _hours(options.hours)
    return mission(_trajectory(options.trajectory, hours * 3600 + MARGIN), hours)


def present_fmu() -> Path:
    """The FMU of the present sources, built if it isn't there.

    Raises:
        UserError: it can't be built.
    """
    try:
        return built_fmu(lambda text: print(text, file=sys.stderr))
    except (TranslationError, BuildError) as error:
        raise UserError(str(error)) from error
    except OSError as error:
        raise UserError(f"can't build the FMU: {error}") from error


@contextmanager
def gyro_minutes(total: int, name: str) -> Iterator[Callable[[int], None]]:
    """A bar of gyro time, minutes; what it gives is told how many more are done."""
    layout = "{desc} {percentage:3.0f}%|{bar}| {n}/{total} gyro minutes [{elapsed}]"
    with tqdm(total=total, desc=name, bar_format=layout) as bar:

        def done(minutes: int) -> None:
            bar.update(minutes)

        yield done


def _trajectory(name_or_path: str, duration: float) -> Trajectory:
    try:
        return catalogue.trajectory(name_or_path, STILL, duration)
    except TrajectoryError as error:
        raise UserError(str(error)) from error


def _hours(text: str) -> float:
    try:
        hours = float(text)
    except ValueError:
        hours = math.nan
    if not 0.1 <= hours <= LONGEST_HOURS or abs(hours * 60 - round(hours * 60)) > 0.02:
        raise UserError(
            f"--hours {text}: expected a number from 0.1 to {LONGEST_HOURS:g}, in whole minutes"
        )
    return round(hours * 60) / 60
