"""`hrg allan`: bias, Allan deviation and noise coefficients of a record at rest."""

import argparse
import json
from pathlib import Path

import pyhrg
from pyhrg.common.files import check_output_folder

HELP = "compute bias, Allan deviation and noise coefficients of a record at rest"


def add_options(parser: argparse.ArgumentParser) -> None:
    add = parser.add_argument
    add("log", type=Path, metavar="LOG", help="log of any IMU (docs/imus.md) or of a bench "
        "(docs/records.md)")  # fmt: skip
    add("--trusted", action="store_true", help="take units and axes as stated, though gravity or "
        "Earth's rate contradict them")  # fmt: skip
    add("--out", type=Path, default=Path("hrg-allan"), metavar="DIR", help="output folder "
        "(default hrg-allan)")  # fmt: skip
    add("--force", action="store_true", help="replace the result of another record in the output "
        "folder")  # fmt: skip
    add("--json", action="store_true", help="print allan.json instead of the summary")


def run(options: argparse.Namespace) -> None:
    from pyhrg.gap.static_record.allan import FILES

    check_output_folder(options.out)
    noise = pyhrg.compute_allan(
        options.log, trusted=options.trusted, out=options.out, force=options.force
    )
    if options.json:
        print(json.dumps(noise.document, indent=1, allow_nan=False))
        return
    print(noise.summary)
    print(f"\nwritten to {options.out}: {', '.join(FILES)}")
