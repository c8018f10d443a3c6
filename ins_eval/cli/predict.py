"""`hrg predict`: the position error that two bench figures predict, with its interval."""

import argparse
import json
from pathlib import Path

import ins_eval
from pyhrg.common.cli import collect_given

HELP = "predict the position error in a mission from bias stabilities, by a finished study"


def add_options(parser: argparse.ArgumentParser) -> None:
    add = parser.add_argument
    add("mission", metavar="MISSION", help="name of a mission of the study, such as car")
    add("--fixed", dest="fixed_deg_h", type=float, metavar="DEG_H", help="in-run bias stability at "
        "a fixed position, rms of the three gyros")  # fmt: skip
    add("--circumference", dest="circumference_deg_h", type=float, metavar="DEG_H", help="bias "
        "stability over the full circumference, rms of the three gyros")  # fmt: skip
    add("--calibration", choices=("mean", "map"), help="what the maker calibrates (default mean)")
    add("--study", type=Path, default=Path("hrg-validation"), metavar="DIR", help="folder of a "
        "finished study (default hrg-validation)")  # fmt: skip
    add("--json", action="store_true", help="print a list of objects instead of sentences")


def run(options: argparse.Namespace) -> None:
    given = collect_given(options, ("fixed_deg_h", "circumference_deg_h", "calibration"))
    errors = ins_eval.predict_error(options.study, options.mission, **given)
    if options.json:
        print(json.dumps([error.document for error in errors], indent=1))
        return
    for error in errors:
        print(error)
