"""`hrg gap challenge`: campaigns whose gap is hidden from the diagnosis, and the score."""

import argparse
import os
from pathlib import Path

from fmu_build.binaries.platforms import BuildError
from fmu_build.equations.translate import TranslationError
from pyhrg.challenge.roster import STRONG, ChallengeError, Folder, Settings
from pyhrg.challenge.run import Challenge, Diagnose
from pyhrg.challenge.scoring import report
from pyhrg.challenge.truths.truth import LEAST
from pyhrg.common.errors import HrgError
from pyhrg.fmu import GyroError

NAME = "challenge"
HELP = "score the diagnosis on campaigns whose gap is hidden from it"
KINDS = {
    "none": (300, "without a gap"),
    "single": (150, "with one effect of the catalogue"),
    "pairs": (150, "with two"),
    "outside": (150, "with an effect that the catalogue does not have"),
    "weak": (0, f"with one effect below {LEAST:g} sigma, for the curve against strength"),
    "several": (0, "with three to seven effects, up to ten times as strong"),
    "left-out": (0, "with an effect that is taken out of the catalogue, each in turn"),
}
"""Options, each with its default and what it counts."""
KIND_OF = {"pairs": "pair", "left-out": "left_out"}
REFUSALS = (ChallengeError, GyroError, TranslationError, BuildError)
"""What the user can mend."""


def add_parser(subparsers: "argparse._SubParsersAction[argparse.ArgumentParser]") -> None:
    """Add the subcommand to those of `hrg gap`."""
    parser = subparsers.add_parser(NAME, help=HELP, description=HELP)
    parser.add_argument(
        "--out", type=Path, required=True, metavar="DIR", help="output folder; goes on in one begun"
    )
    for option, (count, what) in KINDS.items():
        parser.add_argument(
            f"--{option}",
            type=int,
            default=count,
            metavar="N",
            help=f"campaigns {what} (default {count})",
        )
    parser.add_argument(
        "--strongest",
        type=float,
        default=STRONG[1],
        metavar="SIGMAS",
        help=f"effects are drawn from {LEAST:g} sigma up to this (default {STRONG[1]:g})",
    )
    parser.add_argument(
        "--seed", type=int, default=1, metavar="N", help="of everything random (default 1)"
    )
    parser.add_argument(
        "--with",
        dest="others",
        type=Path,
        nargs="+",
        default=[],
        metavar="DIR",
        help="folders of finished challenges, of other seeds, to be scored together with this one",
    )
    parser.add_argument(
        "--workers", type=int, metavar="N", help="campaigns at a time (default: all cores)"
    )


def run(options: argparse.Namespace, diagnose: Diagnose) -> None:
    """Run a challenge and print its score.

    Args:
        options: of `add_parser`.
        diagnose: under challenge.

    Raises:
        HrgError: an option out of range, a folder of another challenge, an unusable diagnosis.
    """
    settings = _settings(options)
    workers = options.workers or len(os.sched_getaffinity(0))
    challenge = Challenge(Folder(options.out), settings, diagnose)
    try:
        score = challenge.run(workers, [Folder(other) for other in options.others])
    except REFUSALS as error:
        raise HrgError(str(error)) from error
    except OSError as error:
        raise HrgError(f"{error.filename or options.out}: {error.strerror or error}") from error
    except KeyboardInterrupt:
        raise KeyboardInterrupt("interrupted; the same command goes on from here") from None
    print(report.text(score))
    print(f"\nwritten to {challenge.folder.score}")


def _settings(options: argparse.Namespace) -> Settings:
    counts = {}
    for option in KINDS:
        count = getattr(options, option.replace("-", "_"))
        if count < 0:
            raise HrgError(f"--{option} {count}: expected a whole number from 0")
        counts[KIND_OF.get(option, option)] = count
    if not 0 <= options.seed < 2**63:
        raise HrgError(f"--seed {options.seed}: expected a whole number from 0 to 2^63 - 1")
    if options.workers is not None and options.workers < 1:
        raise HrgError(f"--workers {options.workers}: expected a whole number from 1")
    if not options.strongest > LEAST:
        raise HrgError(f"--strongest {options.strongest:g}: expected more than {LEAST:g}")
    return Settings(counts, options.seed, options.strongest)
