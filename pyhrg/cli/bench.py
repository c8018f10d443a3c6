"""`hrg bench`: the tests of the bench, on the FMU or on recorded logs."""

import argparse
import sys
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

import pyhrg
from pyhrg.common.errors import HrgError
from pyhrg.common.files import check_output_folder

if TYPE_CHECKING:
    from pyhrg.bench.procedure import Procedure

HELP = "test a gyro as it is used: procedures on the FMU or on recorded logs"

ALL = "all"


def add_options(parser: argparse.ArgumentParser) -> None:
    from pyhrg.bench.catalogue import PROCEDURES

    names = [procedure.name for procedure in PROCEDURES]
    parser.formatter_class = argparse.RawDescriptionHelpFormatter
    parser.epilog = _list_tests(PROCEDURES)
    parser.add_argument(
        "test", metavar="TEST", choices=(*names, ALL), help="name of the test; the list is below"
    )
    source = parser.add_mutually_exclusive_group()
    source.add_argument(
        "--device",
        metavar="DEVICE",
        help="gyro to simulate: a ready device or a TOML file (default: typical)",
    )
    source.add_argument(
        "--campaign",
        type=Path,
        metavar="DIR",
        help=f"evaluate recorded logs instead; with {ALL}, the tests that it has records for",
    )
    parser.add_argument(
        "--seed", type=int, default=1, metavar="N", help="seed of all random numbers (default 1)"
    )
    parser.add_argument(
        "--workers",
        type=int,
        metavar="N",
        help="power-ons simulated at the same time (default: all cores)",
    )
    parser.add_argument(
        "--out",
        type=Path,
        default=Path("hrg-bench"),
        metavar="DIR",
        help="output folder (default hrg-bench): report.html, and a folder for each test",
    )
    parser.add_argument(
        "--force",
        action="store_true",
        help="replace results of another device, seed or version in the output folder",
    )
    for procedure in PROCEDURES:
        if procedure.options:
            group = parser.add_argument_group(f"plan of {procedure.name}")
            for option in procedure.options:
                flag = f"--{option.name.replace('_', '-')}"
                group.add_argument(flag, type=option.kind, metavar="N", help=option.help)


def _list_tests(procedures: Sequence["Procedure"]) -> str:
    """Names and titles of the tests by group, for the help; models other than `HRG`."""
    width = max(len(name) for name in (*(p.name for p in procedures), ALL))
    lines = [
        "tests (the model HRG is simulated where no other is named):",
        f"  {ALL:<{width}}  every one of them",
    ]
    for group in dict.fromkeys(p.group for p in procedures):
        lines += ["", f"{group}:"]
        lines += [
            f"  {p.name:<{width}}  {p.title}" + (f" ({p.model})" if p.model != "HRG" else "")
            for p in procedures
            if p.group == group
        ]
    return "\n".join(lines)


def run(options: argparse.Namespace) -> None:
    from pyhrg.bench.catalogue import PROCEDURES

    check_output_folder(options.out)
    plan = {o.name: getattr(options, o.name) for p in PROCEDURES for o in p.options}
    campaign = None if options.campaign is None else pyhrg.read_campaign(options.campaign)
    results = pyhrg.run_tests(
        None if options.test == ALL else [options.test],
        options.device,
        campaign=campaign,
        seed=options.seed,
        workers=options.workers,
        out=options.out,
        force=options.force,
        progress=not options.quiet,
        **plan,
    )
    print(results)
    folders = [result.name for result in results.results]
    print(f"\nwritten to {options.out}: {', '.join(['report.html', *folders])}")
    if campaign is not None:
        _warn_of_refusal(campaign)


def _warn_of_refusal(campaign: "pyhrg.Campaign") -> None:
    """Say on standard error why a diagnosis would refuse the records whose figures were printed."""
    from pyhrg.gap.soundness import screen_campaign

    try:
        screen_campaign(campaign)
    except HrgError as error:
        print(f"hrg: warning: a diagnosis would refuse these records: {error}", file=sys.stderr)
