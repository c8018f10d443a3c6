"""`hrg bench`: test procedures on the FMU or on recorded logs."""

import argparse
import os
import sys
from collections.abc import Mapping, Sequence
from pathlib import Path

from fmu_build.binaries.platforms import BuildError
from fmu_build.equations.translate import TranslationError
from pyhrg.bench import session
from pyhrg.bench.catalogue import BY_NAME, PROCEDURES
from pyhrg.bench.outcome import BenchError
from pyhrg.bench.procedure import Procedure
from pyhrg.bench.reporting import report
from pyhrg.bench.reporting.page import PAGE
from pyhrg.bench.reporting.progress import Progress
from pyhrg.common.errors import HrgError
from pyhrg.device import device_file
from pyhrg.device import ready_devices as parameters
from pyhrg.fmu import GyroError
from pyhrg.records import LogError, campaign

HELP = "test a gyro as it is used: procedures on the FMU or on recorded logs"

ALL = "all"
REFUSALS = (
    campaign.CampaignError,
    device_file.DeviceError,
    LogError,
    BenchError,
    GyroError,
    TranslationError,
    BuildError,
)
"""What the user can mend."""


def add_options(parser: argparse.ArgumentParser) -> None:
    parser.formatter_class = argparse.RawDescriptionHelpFormatter
    width = max(len(name) for name in (*BY_NAME, ALL))
    groups = dict.fromkeys(p.group for p in PROCEDURES)
    lines = [f"  {ALL:<{width}}  every one of them"]
    for group in groups:
        lines += ["", f"{group}:"]
        lines += [f"  {p.name:<{width}}  {p.title}" for p in PROCEDURES if p.group == group]
    parser.epilog = "tests:\n" + "\n".join(lines)
    parser.add_argument("test", metavar="TEST", choices=(*BY_NAME, ALL), help="see below")
    source = parser.add_mutually_exclusive_group()
    source.add_argument(
        "--device", type=Path, metavar="FILE", help="gyro to simulate, TOML (default: typical)"
    )
    source.add_argument(
        "--campaign",
        type=Path,
        metavar="DIR",
        help=f"evaluate recorded logs instead; with {ALL}, the tests that it has records for",
    )
    parser.add_argument(
        "--seed", type=int, default=1, metavar="N", help="of everything random (default 1)"
    )
    parser.add_argument(
        "--workers", type=int, metavar="N", help="power-ons at a time (default: all cores)"
    )
    parser.add_argument(
        "--out",
        type=Path,
        default=Path("hrg-bench"),
        metavar="DIR",
        help="output folder (default hrg-bench): report.html, and a folder for each test",
    )
    for procedure in PROCEDURES:
        if procedure.options:
            plan = parser.add_argument_group(f"plan of {procedure.name}")
            for option in procedure.options:
                plan.add_argument(option.flag, type=option.kind, metavar="N", help=option.help)


def run(options: argparse.Namespace) -> None:
    chosen = PROCEDURES if options.test == ALL else (BY_NAME[options.test],)
    if not 0 <= options.seed < 2**63:
        raise HrgError(f"--seed {options.seed}: expected a whole number from 0 to 2^63 - 1")
    if options.workers is not None and options.workers < 1:
        raise HrgError(f"--workers {options.workers}: expected a whole number from 1")
    plan = _plan(options)
    _check_places(options.out, chosen)
    try:
        source = _source(options, chosen, plan)
        with Progress(len(source.procedures)) as progress:
            results = session.perform(source, options.out, progress)
    except REFUSALS as error:
        raise HrgError(str(error)) from error
    except OSError as error:
        raise HrgError(f"can't write {options.out}: {error.strerror or error}") from error
    print(report.text(results))
    folders = [result.procedure.name for result in results.done if result.outcome]
    print(f"\nwritten to {options.out}: {', '.join([PAGE, *folders])}")


def _plan(options: argparse.Namespace) -> dict[str, float]:
    """Options of the test's plan that were given; those of other tests are refused."""
    given = {}
    for procedure in PROCEDURES:
        for option in procedure.options:
            value = getattr(options, option.name)
            if value is None:
                continue
            if options.test != procedure.name or options.campaign:
                raise HrgError(f"{option.flag}: plans `hrg bench {procedure.name}` on a simulation")
            given[option.name] = value
    return given


def _source(
    options: argparse.Namespace, chosen: Sequence[Procedure], plan: Mapping[str, float]
) -> session.Source:
    if options.campaign:
        return session.recorded(campaign.read(options.campaign), chosen)
    device = device_file.read(options.device) if options.device else parameters.TYPICAL
    fmus = session.fmus(chosen, lambda text: print(text, file=sys.stderr))
    if options.device:
        names = {name for fmu in fmus.values() for name in fmu.references}
        device = device_file.read(options.device, names)
    workers = options.workers or len(os.sched_getaffinity(0))
    return session.simulated(chosen, fmus, device, options.seed, workers, options.out, plan)


def _check_places(out: Path, chosen: Sequence[Procedure]) -> None:
    """What is in the way is found before the work; what isn't a bench's result is not replaced."""
    above = next(path for path in (out, *out.absolute().parents) if path.exists())
    if not above.is_dir():
        raise HrgError(f"can't write {out}: {above} is no folder")
    if (out / PAGE).is_dir():
        raise HrgError(f"can't write {out}: {out / PAGE} is a folder")
    for folder in (out / procedure.name for procedure in chosen):
        if folder.exists() and not (folder / report.RESULT).is_file():
            raise HrgError(f"can't write {out}: {folder} is there and is no result of hrg bench")
