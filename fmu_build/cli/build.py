"""`hrg build`: the FMU as a file."""

import argparse
import sys
from pathlib import Path

from fmu_build.binaries.platforms import PLATFORMS, BuildError, known_to
from fmu_build.bundle import Progress, built_fmu
from fmu_build.equations.translate import TranslationError
from fmu_build.roots import ROOTS
from pyhrg.common.errors import HrgError
from pyhrg.common.files import write_whole

HELP = "translate the Modelica gyro and build HRG.fmu"


def add_options(parser: argparse.ArgumentParser) -> None:
    parser.add_argument(
        "--model",
        choices=tuple(ROOTS),
        default="HRG",
        help="the gyro at 1 kHz, at its carrier, or with quasi-steady loops",
    )
    parser.add_argument("--out", type=Path, help="file to write (default: MODEL.fmu)")
    parser.add_argument(
        "--fmi", type=int, choices=(2, 3), default=2, help="version of the standard"
    )
    parser.add_argument(
        "--platform",
        action="append",
        choices=(*PLATFORMS, "all"),
        default=[],
        help="to compile for; may be repeated (default: this machine's)",
    )


def _say(text: str) -> None:
    print(text, file=sys.stderr)


def _platforms(named: list[str], fmi: int, progress: Progress) -> list[str]:
    """Those to build for; `all` are those that the standard knows."""
    if "all" not in named:
        return named
    for name in sorted(PLATFORMS.keys() - known_to(fmi)):
        progress(f"{name} is left out: FMI {fmi}.0 has no folder for it")
    return known_to(fmi)


def run(options: argparse.Namespace) -> None:
    root = ROOTS[options.model]
    out = options.out or Path(f"{root.identifier}.fmu")
    if out.is_dir():
        raise HrgError(f"can't write {out}: it is a folder; expected the name of a file")
    platforms = _platforms(options.platform, options.fmi, _say)
    try:
        built = built_fmu(_say, options.fmi, platforms, root)
    except (TranslationError, BuildError) as error:
        raise HrgError(str(error)) from error
    except OSError as error:
        raise HrgError(f"can't build the FMU: {error}") from error
    try:
        write_whole(out, built.read_bytes())
    except OSError as error:
        raise HrgError(f"can't write {out}: {error.strerror}") from error
    print(out)
