"""`hrg study`: which bench figure predicts the navigator's error?"""

import argparse
from collections.abc import Sequence
from pathlib import Path

import ins_eval
from pyhrg.common.cli import collect_given, refuse
from pyhrg.common.errors import HrgError
from pyhrg.common.files import check_output_folder
from pyhrg.common.progress import Progress

HELP = (
    "bench many gyros, fly them in many manoeuvres, and say which bench figure predicts the error"
)

CHALLENGE = "challenge"
"""Name in place of a study that hands out the challenge, or scores predictions."""


def add_options(parser: argparse.ArgumentParser) -> None:
    add = parser.add_argument
    add("study", metavar="STUDY", nargs="?", default="small", help="small (default), standard, "
        "wide, narrow, one-maker, rarer, self-witness, or a file (TOML); challenge: hand out the "
        "gyros of small, their flights sealed")  # fmt: skip
    add("--out", type=Path, default=Path("hrg-study"), metavar="DIR", help="output folder "
        "(default hrg-study)")  # fmt: skip
    add("--seed", type=int, metavar="N", help="seed instead of the study's; a challenge needs one "
        "that nobody else knows")  # fmt: skip
    add("--predictions", type=Path, nargs="+", metavar="CSV", help="score these predictions of the "
        "challenge in the output folder, beside ours")  # fmt: skip
    add_cluster_options(parser)


def add_cluster_options(parser: argparse.ArgumentParser) -> None:
    """Declare the options that say who computes."""
    add = parser.add_mutually_exclusive_group().add_argument
    add("--workers", type=int, metavar="N", help="processes on this machine (default: all cores)")
    add("--scheduler", metavar="tcp://HOST:PORT", help="address of a Dask scheduler, instead of "
        "processes on this machine")  # fmt: skip


def run(options: argparse.Namespace) -> None:
    check_output_folder(options.out)
    if options.study == CHALLENGE:
        _run_challenge(options)
        return
    refuse(options, ["predictions"], f"expected with `hrg study {CHALLENGE}` alone")
    study = ins_eval.load_study(options.study, options.seed)
    for name in study.left_out:
        print(f"{name} is not here and is left out; HRG_REAL says where recorded drives are")
    with Progress(not options.quiet, "study", "triads") as progress:
        result = ins_eval.run_study(
            study,
            options.out,
            progress=progress.update,
            **collect_given(options, ("workers", "scheduler")),
        )
    print(result.verdict)
    tell_files(options.out, result.files)


def tell_files(out: Path, files: Sequence[str]) -> None:
    """Print what a study has written into a folder, and what to open."""
    print(f"\nwritten to {out}: {', '.join(files)}")
    print(f"to read, open {out / 'report.html'} in a browser")


def _run_challenge(options: argparse.Namespace) -> None:
    if options.predictions:
        refuse(options, ["seed", "workers", "scheduler"], "found beside --predictions")
        print(ins_eval.score_challenge(options.out, options.predictions))
        return
    if options.seed is None:
        raise HrgError(
            "--seed: found none, expected one that nobody else knows: it gives the truth"
        )
    given = collect_given(options, ("seed", "workers", "scheduler"))
    with Progress(not options.quiet, "study", "triads") as progress:
        folder = ins_eval.hand_out_challenge(options.out, progress=progress.update, **given)
    print(f"to be given away: {folder}; the truth, not to be given away, is beside it")
