"""`hrg aid`: bias maps of the gyros and the path of the vehicle, from a log with position fixes."""

import argparse
from pathlib import Path

import ins_eval
from pyhrg.common.cli import collect_given
from pyhrg.common.files import check_output_folder

HELP = "estimate sensor errors and gyro bias maps from a drive with position fixes"


def add_options(parser: argparse.ArgumentParser) -> None:
    add = parser.add_argument
    add("log", type=Path, metavar="LOG", help="recorded log of an IMU; of whole-angle gyros with "
        "their pattern angles (docs/imus.md)")  # fmt: skip
    add("fixes", type=Path, metavar="FIXES", help="CSV of positions, velocities, speeds in the "
        "log's time (docs/aided.md)")  # fmt: skip
    add("--errors-of", metavar="NAME|FILE", help="ready IMU or IMU TOML: the errors known before "
        "the drive (default simple)")  # fmt: skip
    add("--lever-arm-m", type=float, nargs=3, metavar=("X", "Y", "Z"), help="from IMU to antenna: "
        "forward, right, down (default 0 0 0)")  # fmt: skip
    add("--hold-out-h", type=float, metavar="H", help="hours at the end whose fixes only judge the "
        "position without fixes (default 0)")  # fmt: skip
    add("--bench", type=Path, nargs=3, metavar=("FORWARD", "RIGHT", "DOWN"), help="result.json of "
        "`hrg bench calibration` of each gyro: its maps are known before the drive")  # fmt: skip
    add("--bench-drift", type=float, nargs=2, metavar=("DEG_H", "PPM"), help="with --bench: "
        "1-sigma of what a term of the maps of bias and scale factor changed since")  # fmt: skip
    add("--out", type=Path, default=Path("hrg-aid"), metavar="DIR", help="output folder "
        "(default hrg-aid)")  # fmt: skip


def run(options: argparse.Namespace) -> None:
    check_output_folder(options.out)
    names = ("errors_of", "lever_arm_m", "hold_out_h", "bench", "bench_drift")
    result = ins_eval.aid(options.log, options.fixes, **collect_given(options, names))
    result.write(options.out)
    print(result.summary)
    print(f"\nwritten to {options.out}: {', '.join(result.files)}")
