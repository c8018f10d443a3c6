"""`hrg validate`: the main job, the small study, and its verdict."""

import argparse
from dataclasses import replace
from pathlib import Path

from ins_eval.cli import study as study_command
from ins_eval.study.run.run import Experiment
from ins_eval.study.specification import (
    CALIBRATIONS,
    LONGEST_HOURS,
    MOST_TRIADS,
    Study,
    fewest_triads,
)
from ins_eval.study.validation import small_study
from ins_eval.trajectories.errors import TrajectoryError
from pyhrg.common.errors import HrgError
from pyhrg.common.option_numbers import number, whole

HELP = "bench gyros, fly triads of them, and say which bench test told the truth: the small study"


def add_options(parser: argparse.ArgumentParser) -> None:
    study = small_study.default()
    parser.add_argument("--seed", help=f"of everything random (default {study.seed})")
    parser.add_argument("--hours", help=f"mission length (default {study.hours:g})")
    parser.add_argument(
        "--triads", help=f"device triads, half of which is judged (default {study.triads})"
    )
    parser.add_argument(
        "--calibration",
        choices=CALIBRATIONS,
        help=f"by the maker (default {' and '.join(study.calibrations)})",
    )
    parser.add_argument(
        "--trajectory",
        metavar="NAME|FILE",
        help="ready mission, mission (TOML) or recorded drive (CSV, may be gzipped) that is "
        f"judged; default {study.missions[-1].name}",
    )
    parser.add_argument(
        "--out", type=Path, default=Path("hrg-validation"), metavar="DIR", help="output folder"
    )
    study_command.add_cluster_options(parser)


def run(options: argparse.Namespace) -> None:
    where = study_command.cluster(options)
    study = chosen(options)
    experiment = whole_experiment()
    study_command.perform(study, options.out, experiment, where)
    from ins_eval.study.report.result import read
    from ins_eval.study.validation.summary import summary

    print(summary(read(options.out)))
    print(f"\nwritten to {options.out}: {', '.join(experiment.files)}")


def chosen(options: argparse.Namespace) -> Study:
    """The small study with what the options ask for.

    Raises:
        HrgError: an option that is wrong.
    """
    study = small_study.default()
    if options.seed is not None:
        study = replace(study, seed=whole("--seed", options.seed, 0, 2**63 - 1))
    if options.hours is not None:
        hours = number("--hours", options.hours, 0.1, LONGEST_HOURS)
        study = small_study.with_hours(study, hours)
    if options.calibration is not None:
        study = small_study.calibrated(study, options.calibration)
    if options.triads is not None:
        fewest = fewest_triads(study.interval_percent)
        triads = whole("--triads", options.triads, fewest, MOST_TRIADS)
        study = small_study.with_triads(study, triads)
    try:
        if options.trajectory is not None:
            study = small_study.judged_in(study, options.trajectory)
    except TrajectoryError as error:
        raise HrgError(str(error)) from error
    return study


def whole_experiment() -> Experiment:
    """The study's, with views of its results."""
    from ins_eval.study.validation.views import with_views

    return with_views(study_command.experiment())
