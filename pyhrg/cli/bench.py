"""`hrg bench`: the tests of the bench, on the FMU or on recorded logs."""

import argparse
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING

import pyhrg
from pyhrg.common.errors import HrgError
from pyhrg.common.files import check_output_folder

if TYPE_CHECKING:
    from pyhrg.bench.procedure import Procedure

HELP = "run bench tests on a simulated gyro or on recorded logs"

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
        "--fmu",
        type=Path,
        metavar="FILE",
        help="FMU of your own gyro class (hrg build --class) or closed.fmu of a diagnosis, to be "
        "simulated with the parameters of --device",
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
    campaign = None if options.campaign is None else _read_campaign(options.campaign)
    results = pyhrg.run_tests(
        None if options.test == ALL else [options.test],
        options.device,
        campaign=campaign,
        fmu=options.fmu,
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


def _read_campaign(folder: Path) -> "pyhrg.Campaign":
    """A campaign; where a diagnosis would refuse its records, each log says so, and with it the
    results."""
    from pyhrg.gap.soundness import screen_campaign

    campaign = pyhrg.read_campaign(folder)
    try:
        screen_campaign(campaign)
    except HrgError as error:
        note = f"a diagnosis would refuse these records: {error}"
        logs = [
            replace(test.log, exclusions=(*test.log.exclusions, note)) for test in campaign.tests
        ]
        pairs = zip(campaign.tests, logs, strict=True)
        return replace(campaign, tests=tuple(replace(t, recording=log) for t, log in pairs))
    return campaign
