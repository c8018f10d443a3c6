"""`hrg validate`: the main job."""

import argparse
import math
import sys
from pathlib import Path

from tqdm import tqdm

from fmu_build.bundle import built_fmu
from fmu_build.cli import Command, UserError
from fmu_build.platforms import BuildError
from fmu_build.translate import TranslationError
from ins_eval.metrics import FEWEST_FOR_MEDIAN
from ins_eval.staging import staging
from ins_eval.trajectories import catalogue
from ins_eval.trajectories.errors import TrajectoryError
from ins_eval.trajectories.trajectory import Trajectory
from ins_eval.validation import report, study
from ins_eval.validation.mission import STILL, mission

LONGEST_HOURS = 24.0
MARGIN = 10.0
"""Trajectories go on beyond the mission's end, so that no spline ends within it, s."""


def _add_options(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("--seed", default="1", help="of everything random (default 1)")
    parser.add_argument("--hours", default="2", help="mission length (default 2)")
    parser.add_argument("--triads", default="20", help="device triads to fly (default 20)")
    parser.add_argument(
        "--trajectory",
        default="car",
        metavar="NAME|FILE",
        help="ready mission, mission (TOML) or recorded drive (CSV, may be gzipped); default car",
    )
    parser.add_argument(
        "--out", type=Path, default=Path("hrg-validation"), metavar="DIR", help="output folder"
    )


def _run(options: argparse.Namespace) -> None:
    seed = _whole("--seed", options.seed, 0, 2**63 - 1)
    triads = _whole("--triads", options.triads, FEWEST_FOR_MEDIAN, 10_000)
    hours = _hours(options.hours)
    trajectory = _trajectory(options.trajectory, hours * 3600 + MARGIN)
    try:
        with staging(options.out, report.FILES) as folder:
            result = _validated(seed, triads, hours, trajectory)
            report.write(result, folder)
    except OSError as error:
        raise UserError(f"can't write {options.out}: {error.strerror}") from error
    print(report.summary(result))
    print(f"\nwritten to {options.out}: {', '.join(report.FILES)}")


def _validated(seed: int, triads: int, hours: float, trajectory: Trajectory) -> study.Validation:
    try:
        fmu = built_fmu(lambda text: print(text, file=sys.stderr))
    except (TranslationError, BuildError) as error:
        raise UserError(str(error)) from error
    except OSError as error:
        raise UserError(f"can't build the FMU: {error}") from error
    print(f"simulating {trajectory.name} for {hours:g} h", file=sys.stderr)
    flown = mission(trajectory, hours)
    layout = "{desc} {percentage:3.0f}%|{bar}| {n}/{total} gyro minutes [{elapsed}]"
    with tqdm(total=study.work(triads, flown), desc="bench, flights", bar_format=layout) as bar:

        def done(minutes: int) -> None:
            bar.update(minutes)

        return study.validate(fmu, flown, triads, seed, done=done)


def _trajectory(name: str, duration: float) -> Trajectory:
    try:
        return catalogue.trajectory(name, STILL, duration)
    except TrajectoryError as error:
        raise UserError(str(error)) from error


def _whole(option: str, text: str, low: int, high: int) -> int:
    try:
        value = int(text)
    except ValueError:
        value = low - 1
    if not low <= value <= high:
        raise UserError(f"{option} {text}: expected a whole number from {low} to {high}")
    return value


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


VALIDATE = Command(
    "bench one gyro, fly triads of its kind, and say which bench test told the truth",
    _add_options,
    _run,
)
