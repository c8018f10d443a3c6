"""`hrg bench`: test procedures on the FMU or on recorded logs."""

import argparse
import os
import shutil
import sys
from collections.abc import Mapping, Sequence
from pathlib import Path

from tqdm import tqdm

from fmu_build.bundle import built_fmu
from fmu_build.cli import Command, UserError
from fmu_build.files import replaced_folder, write_whole
from fmu_build.platforms import BuildError
from fmu_build.roots import ROOTS
from fmu_build.translate import TranslationError
from pyhrg import campaign as campaigns
from pyhrg import device_file, parameters
from pyhrg.bench import report
from pyhrg.bench.bench import Bench
from pyhrg.bench.catalogue import BY_NAME, PROCEDURES
from pyhrg.bench.outcome import BenchError, Outcome
from pyhrg.bench.procedure import Procedure
from pyhrg.bench.store import Store
from pyhrg.campaign import Campaign, CampaignError
from pyhrg.fmu import GyroError, GyroFmu
from pyhrg.records import LogError

KEPT = ".records"
"""Folder, within the output's, of logs to resume from."""
Result = tuple[Procedure, Outcome | str]
"""A procedure with its outcome, or why there is none."""
Results = tuple[Mapping[str, float], list[Result]]
"""Limits of the specification, and what was done."""


def _add_options(parser: argparse.ArgumentParser) -> None:
    parser.formatter_class = argparse.RawDescriptionHelpFormatter
    width = max(len(name) for name in BY_NAME)
    listed = "\n".join(f"  {p.name:<{width}}  {p.title}" for p in PROCEDURES)
    parser.epilog = f"tests:\n{listed}\n  {'all':<{width}}  every one of them"
    parser.add_argument("test", metavar="TEST", choices=(*BY_NAME, "all"), help="see below")
    source = parser.add_mutually_exclusive_group()
    source.add_argument(
        "--device", type=Path, metavar="FILE", help="gyro to simulate, TOML (default: typical)"
    )
    source.add_argument(
        "--campaign", type=Path, metavar="DIR", help="evaluate recorded logs instead"
    )
    parser.add_argument("--seed", type=int, default=1, help="of everything random (default 1)")
    parser.add_argument("--workers", type=int, default=0, help="threads (default: all cores)")
    parser.add_argument(
        "--out", type=Path, default=Path("hrg-bench"), metavar="DIR", help="output folder"
    )


def _run(options: argparse.Namespace) -> None:
    chosen = list(PROCEDURES) if options.test == "all" else [BY_NAME[options.test]]
    if not 0 <= options.seed < 2**63:
        raise UserError(f"--seed {options.seed}: expected a whole number from 0 to 2^63 - 1")
    if options.workers < 0:
        raise UserError(f"--workers {options.workers}: expected a number of threads")
    try:
        run = _evaluated if options.campaign else _simulated
        _finish(*run(options, chosen), options.out)
    except (CampaignError, LogError, BenchError, device_file.DeviceError, GyroError) as error:
        raise UserError(str(error)) from error
    except (TranslationError, BuildError) as error:
        raise UserError(str(error)) from error
    except OSError as error:
        raise UserError(f"can't write {options.out}: {error.strerror or error}") from error


def _simulated(options: argparse.Namespace, chosen: Sequence[Procedure]) -> Results:
    """Run procedures on the FMU; a log once made is kept until all is done."""
    device = device_file.read(options.device) if options.device else parameters.TYPICAL
    store = Store(options.out / KEPT)
    done = []
    with tqdm(chosen, bar_format="{desc} {n}/{total} tests [{elapsed}]", file=sys.stderr) as bar:
        for procedure in chosen:
            bar.set_description(procedure.name)
            fmu = GyroFmu(built_fmu(bar.write, root=ROOTS[procedure.model]))
            workers = options.workers or len(os.sched_getaffinity(0))
            bench = Bench(fmu, device, options.seed, procedure.step, workers, store)
            try:
                campaign = bench.campaign(procedure.record(bench))
            except KeyboardInterrupt:
                raise KeyboardInterrupt("interrupted; the same command goes on from here") from None
            done.append(_judged(procedure, campaign, options))
            bar.update()
    shutil.rmtree(store.folder, ignore_errors=True)
    return device.specification, done


def _evaluated(options: argparse.Namespace, chosen: Sequence[Procedure]) -> Results:
    """Run procedures on a recorded campaign: with `all`, those whose kind of test it has."""
    campaign = campaigns.read(options.campaign)
    if len(chosen) > 1:
        chosen = [p for p in chosen if campaign.of_kind(*p.kinds)]
    return {}, [_judged(procedure, campaign, options) for procedure in chosen]


def _judged(procedure: Procedure, campaign: Campaign, options: argparse.Namespace) -> Result:
    """Evaluate and write; what the records can't give is said, and ends a single test."""
    try:
        outcome = procedure.evaluate(campaign)
    except (BenchError, LogError) as error:
        if options.test != "all":
            raise
        return procedure, str(error)
    folder = options.out / procedure.name
    with replaced_folder(folder) as aside:
        report.write(procedure, outcome, None if options.campaign else options.seed, aside)
        if not options.campaign:
            campaigns.write(campaign, aside)
    return procedure, outcome


def _finish(limits: Mapping[str, float], results: Sequence[Result], out: Path) -> None:
    """Print the outcomes and write the page of them all."""
    sections = []
    for procedure, outcome in results:
        if isinstance(outcome, Outcome):
            print(report.text(procedure, outcome, limits) + "\n")
            sections.append(report.section(procedure, outcome, limits))
        else:
            print(f"{procedure.title}\n{outcome}\n")
            sections.append(report.missing(procedure, outcome))
    write_whole(out / report.PAGE, report.page("HRG bench", sections).encode())
    print(f"written to {out}: {report.PAGE}, {', '.join(p.name for p, _ in results)}")


BENCH = Command(
    "test a gyro as it is used: procedures on the FMU or on recorded logs", _add_options, _run
)
