"""`hrg gap challenge`: score the diagnosis on campaigns whose truth is sealed."""

import argparse
from pathlib import Path

import pyhrg
from pyhrg.common.cli import collect_given
from pyhrg.common.files import check_output_folder

HELP = "score the diagnosis on campaigns whose truth is sealed"
COUNTS = {
    "none": "without a gap (default 300)",
    "single": "with one effect of the catalogue (default 150)",
    "pairs": "with two effects (default 150)",
    "outside": "with an effect that the catalogue lacks (default 150)",
    "weak": "with one effect of 1 to 6 sigma, for the curve of recognition against strength",
    "several": "with three to eight effects, up to ten times as strong",
    "left-out": "with an effect that is removed from the catalogue, each in turn",
}
"""What the campaigns of each kind have; their counts are options."""
ARGUMENTS = (
    *(name.replace("-", "_") for name in COUNTS),
    "strongest",
    "level",
    "data",
    "seed",
    "workers",
)


def add_options(parser: argparse.ArgumentParser) -> None:
    parser.add_argument(
        "--out", type=Path, required=True, metavar="DIR", help="output folder; a challenge that "
        "was begun there is continued"
    )  # fmt: skip
    for name, help_text in COUNTS.items():
        parser.add_argument(f"--{name}", type=int, metavar="N", help=f"campaigns {help_text}")
    parser.add_argument(
        "--strongest",
        type=float,
        metavar="SIGMAS",
        help="strengths are drawn from 6 sigma up to this (default 60)",
    )
    parser.add_argument(
        "--level",
        metavar="LEVEL",
        help="ideal (default); good-lab: nominal values and bench are off within their "
        "tolerances; rough-lab: within three times that",
    )
    parser.add_argument(
        "--data",
        metavar="AMOUNT",
        help="full (default); few: one or two kinds of tests beside the held-out one; short: tests "
        "a tenth as long; coarse: rows of at least 1 s",
    )
    parser.add_argument(
        "--seed", type=int, metavar="N", help="seed of all random numbers (default 1)"
    )
    parser.add_argument(
        "--with",
        dest="others",
        type=Path,
        nargs="+",
        default=[],
        metavar="DIR",
        help="folders of finished challenges of other seeds, scored together with this one",
    )
    parser.add_argument(
        "--workers", type=int, metavar="N", help="campaigns at a time (default: all cores)"
    )


def run(options: argparse.Namespace) -> None:
    check_output_folder(options.out)
    arguments = collect_given(options, ARGUMENTS)
    score = pyhrg.run_challenge(
        options.out, others=options.others, progress=not options.quiet, **arguments
    )
    print(score.summary)
    print(f"\nwritten to {options.out / 'score.json'}")
