"""`hrg position`, and the section that every diagnosis gets: what a gap is worth in metres."""

import argparse
import sys
from pathlib import Path

from fmu_build.binaries.platforms import BuildError
from fmu_build.bundle import built_fmu
from fmu_build.equations.translate import TranslationError
from fmu_build.roots import ROOTS
from ins_eval.position import diagnosis, report
from ins_eval.position.position import (
    HOURS,
    MISSIONS,
    SEED,
    TRIADS,
    USUAL,
    Asked,
    Position,
    position,
)
from ins_eval.trajectories.errors import TrajectoryError
from pyhrg.common.errors import HrgError
from pyhrg.common.files import write_whole
from pyhrg.device.device_file import DeviceError
from pyhrg.fmu import GyroError, GyroFmu
from pyhrg.gap.report.sections import Say, Section

HELP = "what the gap of a diagnosis is worth in metres"

FILE = "position.json"
REFUSALS = (
    diagnosis.DiagnosisError,
    DeviceError,
    GyroError,
    TrajectoryError,
    TranslationError,
    BuildError,
)
"""What the user can mend."""
FEWEST = 10
"""Triads that an interval can be told of."""


def section(folder: Path, say: Say) -> Section:
    """Of the folder of a diagnosis, in the usual missions."""
    return report.section(_position(folder, USUAL, say))


def _position(folder: Path, asked: Asked, say: Say) -> Position:
    found = diagnosis.read(folder)
    fmu = GyroFmu(built_fmu(say, root=ROOTS["HRGSlow"]))
    fmu.prepare()
    return position(fmu, found, asked, say)


def add_options(parser: argparse.ArgumentParser) -> None:
    add = parser.add_argument
    add("diagnosis", type=Path, metavar="DIR", help="folder that hrg gap diagnose wrote")
    add("--mission", action="append", metavar="NAME|FILE", help="ready mission, mission TOML or "
        f"recorded drive; may be given again (default {', '.join(MISSIONS)})")  # fmt: skip
    add("--hours", type=float, default=HOURS, help=f"of navigation (default {HOURS:g})")
    add("--triads", type=int, default=TRIADS, help=f"that are drawn (default {TRIADS})")
    add("--seed", type=int, default=SEED, help=f"of the draws (default {SEED})")


def run(options: argparse.Namespace) -> None:
    if options.triads < FEWEST:
        raise HrgError(f"--triads: found {options.triads}, expected {FEWEST} or more")
    if options.seed < 0:
        raise HrgError(f"--seed: found {options.seed}, expected 0 or more")
    missions = tuple(options.mission or MISSIONS)
    asked = Asked(missions, options.hours, options.triads, options.seed)
    try:
        found = report.section(_position(options.diagnosis, asked, _say))
        write_whole(options.diagnosis / FILE, found.data())
    except REFUSALS as error:
        raise HrgError(str(error)) from error
    except OSError as error:
        raise HrgError(f"{error.filename or options.diagnosis}: {error.strerror}") from error
    print("\n".join(found.document["said"]))


def _say(text: str) -> None:
    print(text, file=sys.stderr, flush=True)
