"""`hrg build`: the FMU as a file."""

import argparse
from pathlib import Path

import fmu_build
from pyhrg.common.files import check_output_folder
from pyhrg.common.progress import Progress

HELP = "compile the Modelica gyro into an FMU"


def add_options(parser: argparse.ArgumentParser) -> None:
    parser.add_argument(
        "--model",
        choices=(*fmu_build.ROOTS, *fmu_build.PARTS),
        default="HRG",
        help="the gyro at 1 kHz, at its carrier, or with quasi-steady loops; with electronics that "
        "correct its bias map; its resonator or its electronics alone; the navigator, or its "
        "accelerometers",
    )
    parser.add_argument(
        "--class",
        dest="class_file",
        type=Path,
        metavar="FILE.mo",
        help="file of a Modelica class that is a gyro, such as the closed.mo of a diagnosis; it "
        "takes the place of --model",
    )
    parser.add_argument("--out", type=Path, help="file to write (default: MODEL.fmu)")
    parser.add_argument(
        "--fmi", type=int, choices=(2, 3), default=2, help="version of the standard"
    )
    parser.add_argument(
        "--platform",
        action="append",
        choices=(*fmu_build.PLATFORMS, "all"),
        default=[],
        help="platform to compile for; repeatable (default: this machine's)",
    )


def run(options: argparse.Namespace) -> None:
    name = options.model if options.class_file is None else options.class_file.stem
    out = options.out or Path(f"{name}.fmu")
    check_output_folder(out.parent)
    fmu_build.build_fmu(
        options.model,
        fmi=options.fmi,
        platforms=options.platform,
        class_file=options.class_file,
        out=out,
        progress=Progress(not options.quiet).say,
    )
    print(out)
