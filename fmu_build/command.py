"""`hrg build`: the FMU as a file."""

import argparse
import shutil
import sys
from pathlib import Path

from fmu_build.bundle import BuildError, built_fmu
from fmu_build.cli import Command, UserError
from fmu_build.translate import TranslationError


def _add_options(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("--out", type=Path, default=Path("HRG.fmu"), help="file to write")


def _run(options: argparse.Namespace) -> None:
    try:
        built = built_fmu(lambda text: print(text, file=sys.stderr))
    except (TranslationError, BuildError) as error:
        raise UserError(str(error)) from error
    try:
        shutil.copyfile(built, options.out)
    except OSError as error:
        raise UserError(f"can't write {options.out}: {error.strerror}") from error
    print(options.out)


BUILD = Command("translate the Modelica gyro and build HRG.fmu", _add_options, _run)
